# What gnuplot says in SVG and a browser knows anyway: with -z, the file as one line. Tenths of a pixel are enough.
s/<g [^>]*>\n<.g>\n|<rect x="0" y="0"[^>]*>\n//g
s/<filter.*<.filter>|<(title|desc)>[^<]*<.(title|desc)>//g
s/ (stroke-linecap="butt"|stroke-linejoin="miter"|font-family="serif"|fill="none"|color="black"|stroke="currentColor"|class="gridline"|font-size="12.00" )//g
s/gnuplot_canvas"/& fill="none" stroke="currentColor" font-family="serif" font-size="12"/
s/([0-9]\.[0-9])[0-9]+([ ,'")])/\1\2/g
s/rgb\( ?51, *51, *51\)/#333/g
s/rgb\(221, *221, *221\)/#ddd/g
s/ +([L'])/\1/g
s/<tspan *>([^<]*)<.tspan>/\1/g
s/\n[\t\n]*/\n/g

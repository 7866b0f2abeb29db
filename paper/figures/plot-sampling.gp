# How long the law may be held, and how late it may act, against n: the linear model with the gains of (44), hours of the paper's orbit.
Omega = real(system("awk -F, '$1 == \"Omega\" { print $3 }' '".data."/table1.csv'"))
hours(name) = column(name) / Omega / 3600
# The gains 12, 4 stand apart from the rule.
ruled = "< sed '/^12,4\\.0/d' '".data."/sampling.csv'"
freed = "< sed -n '1p; /^12,4\\.0/p' '".data."/sampling.csv'"
eval tall(6.6)
eval open
set xlabel '$n = C_1/\Omega^2$'
set ylabel 'longest [h]' offset -0.6, 0
set bmargin at screen 0.19
set xrange [9:40]
set yrange [0:3]
plot ruled using 'c1':(hours('hold')) with lines linestyle 1 title 'held', \
     ruled using 'c1':(hours('delay')) with lines linestyle 2 title 'late', \
     freed using 'c1':(hours('hold')) with points pointtype 7 pointsize 0.6 linecolor '#1b4f8a' title '$C_2 = 4\,\Omega$', \
     freed using 'c1':(hours('delay')) with points pointtype 7 pointsize 0.6 linecolor '#c2571a'

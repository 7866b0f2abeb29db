# Figure 4: the real parts of the two pairs of roots of (41) against n; beside it the slower pair about n = 12 and its optimum.
best = real(system("sed -n 's/^fastest-decay.*fastest at n[^ ]* = \\([0-9.]*\\).*/\\1/p' '".data."/verdicts.csv'"))
eval tall(7.4)
eval open
set multiplot
set bmargin at screen 0.19
set xlabel '$n = C_1/\Omega^2$'
set lmargin at screen 0.1
set rmargin at screen 0.60
set ylabel 'real part [$10^{-5}\,\mathrm{s}^{-1}$]' offset -0.4, 0
set xrange [9:40]
set xtics (9, 12, 15, 20, 25, 30, 35, 40)
set yrange [*:0.5]
set arrow 1 from 12, graph 0 to 12, graph 1 nohead linestyle 8
plot data.'/figure4.csv' using 'n':(1e5 * column('re1')) with lines linestyle 1 title 'slower pair', \
     ''                  using 'n':(1e5 * column('re2')) with lines linestyle 2 title 'faster pair'
unset arrow 1
set lmargin at screen 0.72
set rmargin at screen 0.985
set xrange [11:13]
set xtics 0.5
set yrange [-4.4:-4.0]
set ytics 0.1
unset ylabel
set arrow 1 from 12, graph 0 to 12, graph 1 nohead linestyle 8
set arrow 2 from best, graph 0 to best, graph 1 nohead linestyle 4 dashtype (1, 3)
set label '$12$' at 12.04, graph 0.9 left
set label sprintf('$%.4f$', best) at best - 0.04, graph 0.9 right
plot data.'/figure4.csv' using 'n':(1e5 * column('re1')) with lines linestyle 1
unset multiplot

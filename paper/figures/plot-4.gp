# Figure 4: the real parts of the two pairs of roots of (41) against n; the marks are n = 12 and the optimum.
best = real(system("sed -n 's/^fastest-decay.*fastest at n[^ ]* = \\([0-9.]*\\).*/\\1/p' '".data."/verdicts.csv'"))
set xlabel 'gain factor $n = C_1/\Omega^2$'
set ylabel 'real part [$10^{-5}\,\mathrm{s}^{-1}$]' offset -1.2, 0
set xrange [9:40]
set xtics (9, 12, 15, 20, 25, 30, 35, 40)
set yrange [*:0.5]
set key samplen 3
set arrow from 12, graph 0 to 12, graph 1 nohead linestyle 8
set arrow from best, graph 0 to best, graph 1 nohead linestyle 4 dashtype (1, 3)
set label sprintf('$n = 12$ (dashed) and the optimum $n = %.4f$ (dotted)', best) at 12.5, graph 0.07
plot data.'/figure4.csv' using 'n':(1e5 * column('re1')) with lines linestyle 1 title 'slower pair', \
     ''                  using 'n':(1e5 * column('re2')) with lines linestyle 2 title 'faster pair'

# Figure 4: the real parts of the two pairs of roots of (41) against the gain factor n of (43) and (44); the marks are
# n = 12 and the optimum.
best = real(system("sed -n 's/^fastest-decay.*fastest at n[^ ]* = \\([0-9.]*\\).*/\\1/p' '".data."/verdicts.csv'"))
set xlabel 'gain factor n = C_1/Ω^2'
set ylabel 'real part of the roots [10^{−5} s^{−1}]'
set xrange [9:40]
set xtics (9, 12, 15, 20, 25, 30, 35, 40)
set yrange [*:0.5]
set arrow from 12, graph 0 to 12, graph 1 nohead linestyle 8
set arrow from best, graph 0 to best, graph 1 nohead linestyle 8 dashtype (1, 2)
set label sprintf('n = 12 (dashed) and the fastest, n = %.4f (dotted)', best) at 12.4, graph 0.06 textcolor '#444444'
plot data.'/figure4.csv' using 'n':(1e5 * column('re1')) with lines linestyle 1 title 'slower pair', \
     ''                  using 'n':(1e5 * column('re2')) with lines linestyle 2 title 'faster pair'

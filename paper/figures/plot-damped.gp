# Pitch under a reference length that moves with it: its amplitude, what the averaged rate makes of it, and that without the law.
motions = build.'/damped.csv'
mrad(name) = 1000 * column(name)
eval tall(6.4)
eval open
eval time_axis
set xrange [0:20]
set xtics 5
set bmargin at screen 0.18
set yrange [0:11]
set ytics 2
set ylabel 'amplitude of pitch [mrad]' offset -0.6, 0
plot motions using (days(column('t'))):(mrad('amplitude_undamped')) with lines linestyle 2 title 'length held', \
     ''      using (days(column('t'))):(mrad('amplitude_law')) with lines linestyle 7 title 'averaged rate', \
     ''      using (days(column('t'))):(mrad('amplitude')) with lines linestyle 1 linewidth 1.2 title 'length moved'

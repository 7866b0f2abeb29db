# The closed form of what pitch forces: how far the motion is from it, and the decay of pitch that it predicts.
eval tall(7.6)
eval open
eval besides
eval beside(1)
set title 'motion less closed form' offset 0, -0.6
set xlabel 'amplitude of pitch [rad]'
set ylabel 'difference after 12\,h [m, rad]'
set xrange [5e-5:0.2]
set xtics 1e-4, 10
set format x '$10^{%T}$'
set yrange [1e-22:1e2]
set ytics 1e6
eval 'plot '.difference('forced_43200s', 'dL', 1, '$\delta L$').', '.difference('forced_43200s', 'psi', 3, '$\psi$').', '.difference('forced_43200s', 'theta', 2, '$\theta$')
eval beside(2)
unset logscale
set format '$%g$'
set title 'pitch, from 0.2\,rad' offset 0, -0.6
set xlabel 'time [days]'
set ylabel '$\theta$ [rad]' offset 0, 0
set xrange [0:30]
set xtics 5
set yrange [-0.22:0.3]
set ytics 0.1
set key at graph 0.97, 0.99 top right vertical Right noreverse
plot data.'/pitch.csv' using (days(column('t'))):'theta' with lines linewidth 0.5 linecolor '#999999' title '$\theta$', \
     ''                using (days(column('t'))):'amplitude_law' with lines linestyle 7 title 'slow law', \
     ''                using (days(column('t'))):'amplitude' with lines linestyle 1 title 'amplitude'
unset multiplot

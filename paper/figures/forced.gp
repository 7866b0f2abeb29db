# What pitch leaves of the length error and of yaw where the linear model has them at rest: motion and closed form.
eval panels(2)
set xrange [2:6]
set xtics 1
eval next
set ylabel 'length error δL [mm]'
set yrange [-0.6:0.6]
set ytics 0.2
plot data.'/forced.csv' using (days(column('t'))):(1e3 * column('dL_forced')) with lines linestyle 7 title 'closed form', \
     ''                 using (days(column('t'))):(1e3 * column('dL')) with lines linestyle 1 title 'nonlinear', \
     ''                 using (days(column('t'))):(1e3 * column('dL_linear')) with lines linestyle 2 title 'linear'
eval next
set ylabel 'ψ [µrad]'
set yrange [-20:40]
set ytics 10
plot data.'/forced.csv' using (days(column('t'))):(1e6 * column('psi_forced')) with lines linestyle 7, \
     ''                 using (days(column('t'))):(1e6 * column('psi')) with lines linestyle 1, \
     ''                 using (days(column('t'))):(1e6 * column('psi_linear')) with lines linestyle 2
unset multiplot

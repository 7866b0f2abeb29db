# What the classical Runge-Kutta method makes of the motions in steps of 100 s, against the certified ones.
eval tall(9.4)
eval open
eval panels(2)
set logscale y
set format y '$10^{%T}$'
set ytics 1e-14, 100
set yrange [1e-16:1e-8]
error(name, unit) = (d = abs(column(name.'_rk4') - column(name)) / unit, d > 0 ? d : NaN)
eval next
set ylabel 'error, linear' offset -1.2, 0
plot data.'/figure5a.csv' every 6 using (days(column('t'))):(error('theta', 1)) with lines linestyle 2 title '$\theta$', \
     ''                   every 6 using (days(column('t'))):(error('psi', 1))   with lines linestyle 1 title '$\psi$', \
     ''                   every 6 using (days(column('t'))):(error('dL', 10))   with lines linestyle 3 title '$\delta L/L_\mathrm{ref}$'
eval next
set ylabel 'error, nonlinear' offset -1.2, 0
plot data.'/figure6.csv'  every 6 using (days(column('t'))):(error('z1', 5)) with lines linestyle 2 title '$z_1$', \
     ''                   every 6 using (days(column('t'))):(error('y1', 5)) with lines linestyle 1 title '$y_1$', \
     ''                   every 6 using (days(column('t'))):(error('x1', 5)) with lines linestyle 3 title '$x_1$, by 5\,m'
unset multiplot

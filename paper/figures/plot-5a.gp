# Figure 5(a): the angles and the length error of the linear model.
eval tall(7.6)
eval open
eval panels(2)
eval next
set ylabel 'angle [rad]' offset -1.2, 0
set ytics 0.005
set yrange [-0.0108:0.0108]
plot data.'/figure5a.csv' every 6 using (days(column('t'))):'psi'   with lines linestyle 1 title '$\psi$', \
     ''                   every 6 using (days(column('t'))):'theta' with lines linestyle 2 title '$\theta$'
eval next
set yrange [*:*]
set ylabel 'length error $\delta L$ [m]' offset -1.2, 0
set ytics 0.05
plot data.'/figure5a.csv' every 6 using (days(column('t'))):'dL' with lines linestyle 1
unset multiplot

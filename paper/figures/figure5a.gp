# Figure 5(a): the angles and the length error of the linear model.
eval panels(2)
eval next
set ylabel 'angle [rad]'
set ytics 0.005
plot data.'/figure5a.csv' every 6 using (days(column('t'))):'psi'   with lines linestyle 1 title 'ψ', \
     ''                   every 6 using (days(column('t'))):'theta' with lines linestyle 2 title 'θ'
eval next
set ylabel 'length error δL [m]'
set ytics 0.05
plot data.'/figure5a.csv' every 6 using (days(column('t'))):'dL' with lines linestyle 1
unset multiplot

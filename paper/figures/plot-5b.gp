# Figure 5(b): the motion of craft 1 in the Hill frame, by the linear model.
eval tall(7.6)
eval open
eval panels(2)
eval next
set ylabel '$x_1$ [m]' offset -1.2, 0
set ytics 0.02
plot data.'/figure5b.csv' every 6 using (days(column('t'))):'x1' with lines linestyle 1
eval next
set ylabel '$y_1$, $z_1$ [m]' offset -1.2, 0
set ytics 0.025
plot data.'/figure5b.csv' every 6 using (days(column('t'))):'y1' with lines linestyle 3 title '$y_1$', \
     ''                   every 6 using (days(column('t'))):'z1' with lines linestyle 2 title '$z_1$'
unset multiplot

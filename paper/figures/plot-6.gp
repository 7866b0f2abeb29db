# Figure 6: the nonlinear motion of craft 1 over the linear motion of Figure 5(b), and their difference.
linear    = data.'/figure5b.csv'
nonlinear = data.'/figure6.csv'
both      = sprintf("< paste -d, '%s' '%s'", linear, nonlinear)
columns   = words(system("head -n 1 '".linear."' | tr , ' '"))   # of the first file
difference(k) = 1e3 * (column(columns + k) - column(k))
eval tall(12)
eval open
eval panels(3)
eval next
set ylabel '$x_1$ [m]' offset -1.2, 0
set ytics 0.02
plot linear    every 6 using (days(column('t'))):'x1' with lines linestyle 7 title 'linear', \
     nonlinear every 6 using (days(column('t'))):'x1' with lines linestyle 1 title 'nonlinear'
eval next
set ylabel '$y_1$, $z_1$ [m]' offset -1.2, 0
set ytics 0.05
plot linear    every 6 using (days(column('t'))):'y1' with lines linestyle 7 title 'linear', \
     ''        every 6 using (days(column('t'))):'z1' with lines linestyle 7, \
     nonlinear every 6 using (days(column('t'))):'y1' with lines linestyle 3 title '$y_1$', \
     ''        every 6 using (days(column('t'))):'z1' with lines linestyle 2 title '$z_1$'
eval next
set ylabel 'difference [mm]' offset -1.2, 0
set ytics 1
plot both every 6 using (days($1)):(difference(2)) with lines linestyle 1 title '$x_1$', \
     ''   every 6 using (days($1)):(difference(3)) with lines linestyle 3 title '$y_1$', \
     ''   every 6 using (days($1)):(difference(4)) with lines linestyle 2 title '$z_1$'
unset multiplot

# The bounds of every motion that starts in a box: of x1, between them; and how far they lie apart.
bounds = build.'/set.csv'
apart(name) = 1000 * (column(name.'_high') - column(name.'_low'))
eval tall(7.6)
eval open
eval panels(2)
eval next
set ylabel '$x_1$ [m]' offset -1.2, 0
set ytics 0.02
plot bounds using (days(column('t'))):'x1_low':'x1_high' with filledcurves linecolor '#c8c8c8', \
     ''     using (days(column('t'))):'x1_low' with lines linestyle 1, \
     ''     using (days(column('t'))):'x1_high' with lines linestyle 1
eval next
set ylabel 'apart [mm]' offset -1.2, 0
set logscale y
set ytics 100
set format y '$10^{%T}$'
plot bounds using (days(column('t'))):(apart('x1')) with lines linestyle 1 title '$x_1$', \
     ''     using (days(column('t'))):(apart('y1')) with lines linestyle 3 title '$y_1$', \
     ''     using (days(column('t'))):(apart('z1')) with lines linestyle 2 title '$z_1$'
unset multiplot

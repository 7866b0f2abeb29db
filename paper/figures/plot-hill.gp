# Hill's field against the inverse square: what the difference is after 12 h, as the orbit grows.
eval tall(7.6)
eval open
eval besides
set xrange [5e-6:2e-3]
set xtics 1e-5, 10
set format x '$10^{%T}$'
set xlabel '$L_\mathrm{ref}/R_c$'
eval beside(1)
set title 'the place of craft 1' offset 0, -0.6
set ylabel 'difference after 12\,h [m]'
set yrange [1e-7:1e1]
set ytics 100
eval 'plot '.difference('hill_43200s', 'y1', 1, '$y_1$').', '.difference('hill_43200s', 'x1', 3, '$x_1$').', '.difference('hill_43200s', 'z1', 2, '$z_1$')
eval beside(2)
set title 'the tether' offset 0, -0.6
set ylabel 'difference after 12\,h [m, rad]'
set yrange [1e-12:1e4]
set ytics 1e-12, 1e4
eval 'plot '.difference('hill_unequal_43200s', 'dL', 1, '$\delta L$, 100 and 200\,kg').', '.difference('hill_unequal_43200s', 'psi', 3, '$\psi$, 100 and 200\,kg').', '.difference('hill_43200s', 'dL', 2, '$\delta L$, equal').', '.difference('hill_43200s', 'psi', 8, '$\psi$, equal')
unset multiplot

# How far off the pair may start: each coordinate alone, and all at once; and with charges that have a bound.
eval tall(8.2)
eval open
eval besides
unset logscale x
set format x '$%g$'
set xlabel '$n$'
set xrange [9:40]
set xtics 10
set yrange [5e-4:5]
set ytics 10
set key at graph 0.97, 0.03 bottom right vertical Right noreverse
eval beside(1)
set title 'largest disturbances' offset 0, -0.6
set ylabel 'rad, $L_\mathrm{ref}$, $\Omega$, $\Omega L_\mathrm{ref}$'
basin(name) = sprintf("data.'/basin.csv' using 'c1':'%s' with lines", name)
eval 'plot '.basin('angle_rate').' linestyle 8 title "a rate alone", '.basin('yaw').' linestyle 2 title "yaw alone", '.basin('length').' linestyle 3 title "length alone", '.basin('box').' linestyle 1 title "all at once"'
eval beside(2)
set title 'all at once, charges bounded' offset 0, -0.6
set ylabel 'rad, $L_\mathrm{ref}$, $\Omega$, $\Omega L_\mathrm{ref}$'
charge(q) = sprintf("data.'/saturation.csv' using (column('charge') == %s ? column('c1') : NaN):'box' with lines", q)
eval 'plot '.charge('2').' linestyle 1 title ''$q_\mathrm{max}/q_\mathrm{ref}=2$'', '.charge('1.5').' linestyle 2 title "1.5", '.charge('1.2').' linestyle 3 title "1.2", '.charge('1.05').' linestyle 8 title "1.05"'
unset multiplot

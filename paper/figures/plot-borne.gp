# Errors that stay: where rest moves, and how much of each is borne.
eval tall(8.2)
eval open
eval besides
unset logscale
set format '$%g$'
eval beside(1)
set title 'length of rest' offset 0, -0.6
set xlabel 'force over the commanded one'
set ylabel '$L/L_\mathrm{ref}$' offset 0, 0
set xrange [0.6:1.8]
set xtics 0.6, 0.4
set yrange [0.8:1.6]
set ytics 0.2
set key at graph 0.97, 0.6 top right vertical Right noreverse
gain(c1) = sprintf("data.'/balance.csv' using (column('c1') == %d ? column('force') : NaN):'rest' with lines", c1)
eval 'plot '.gain(10).' linestyle 1 title "$n=10$", '.gain(12).' linestyle 2 title "12", '.gain(20).' linestyle 3 title "20", '.gain(40).' linestyle 8 title "40"'
eval beside(2)
set title 'what is borne' offset 0, -0.6
set logscale y
set format y '$10^{%T}$'
set xlabel '$n$'
set ylabel 'part of the force; push in $\Omega^2L_\mathrm{ref}$' offset -0.6, 0
set xrange [9:40]
set xtics 10
set yrange [1e-3:20]
set ytics 10
set key at graph 0.97, 0.03 bottom right vertical Right noreverse
tolerance(name) = sprintf("data.'/tolerance.csv' using 'c1':'%s' with lines", name)
eval 'plot '.tolerance('deficit').' linestyle 1 title "force missing", '.tolerance('outward').' linestyle 2 title "outward push", '.tolerance('inward').' linestyle 3 title "inward", '.tolerance('along').' linestyle 8 title "along the track"'
unset multiplot

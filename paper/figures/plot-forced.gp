# What pitch forces: the length error of both models, and what is left of the nonlinear one without the closed form.
eval tall(6.4)
eval open
eval time_axis
set xrange [0:6]
set xtics 1
set bmargin at screen 0.18
set logscale y
set format y '$10^{%T}$'
set yrange [1e-9:0.3]
set ytics 100
set ylabel '$|\delta L|$ [m]' offset -1.2, 0
plot data.'/forced.csv' using (days(column('t'))):(abs(column('dL_linear'))) with lines linestyle 2 title 'linear', \
     ''                 using (days(column('t'))):(abs(column('dL'))) with lines linestyle 1 title 'nonlinear', \
     ''                 using (days(column('t'))):(abs(column('dL') - column('dL_forced'))) with lines linestyle 3 title 'less forced'

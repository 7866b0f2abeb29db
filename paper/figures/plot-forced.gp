# What pitch forces: the length error of the linear and of the nonlinear motion, and the amplitude in closed form.
linear    = data.'/figure5a.csv'
nonlinear = data.'/figure6.csv'
L_ref = real(system("awk -F, '$1 == \"L_ref\" { print $3 }' '".data."/table1.csv'"))
n = 10; a = 0.01                                       # of the simulation
s = sqrt(n - 9)
forced = L_ref * a**2 * 36 / abs({13, 0} * s**2 - 144 + {0, 104} * s)   # verdict forced-response: |h|
eval tall(6.4)
eval open
eval time_axis
set bmargin at screen 0.18
set logscale y
set format y '$10^{%T}$'
set yrange [3e-6:0.3]
set ylabel '$|\delta L|$ [m]' offset -1.2, 0
# equal masses: craft 1 stands half the length away from the centre
plot linear    every 3 using (days(column('t'))):(abs(column('dL'))) with lines linestyle 2 title 'linear', \
     nonlinear every 3 using (days(column('t'))):(abs(2 * sqrt(column('x1')**2 + column('y1')**2 + column('z1')**2) - L_ref)) \
               with lines linestyle 1 title 'nonlinear', \
     forced with lines linestyle 8 title 'forced amplitude'

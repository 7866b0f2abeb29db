# Figure 7(b): the charge of craft 2 along the nonlinear motion, and its value at rest, -sqrt(-Q_ref).
Q_ref = real(system("awk -F, '$1 == \"Q_ref\" { print $3 }' '".data."/table1.csv'"))
eval tall(5.6)
eval open
eval time_axis
set bmargin at screen 0.21
set ylabel '$q_2$ [$\mu$C]' offset -1.2, 0
set format y '$%.3f$'
plot -sqrt(-Q_ref) with lines linestyle 8 title 'at rest', \
     data.'/figure7b.csv' every 6 using (days(column('t'))):'q2_uC' with lines linestyle 1 title '$q_2$'

# Figure 7(b): the charge of craft 2 along the nonlinear motion, and its value at rest, -sqrt(-Q_ref).
Q_ref = real(system("awk -F, '$1 == \"Q_ref\" { print $3 }' '".data."/table1.csv'"))
eval time_axis
set ylabel 'charge of craft 2 [µC]'
set format y '%.3f'
plot -sqrt(-Q_ref) with lines linestyle 8 title 'static equilibrium', \
     data.'/figure7b.csv' every 6 using (days(column('t'))):'q2_uC' with lines linestyle 1 title 'q_2'

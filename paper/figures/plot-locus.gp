# The root locus: one root of each pair of (41), in units of Omega, as n grows from 9 to 40.
Omega = real(system("awk -F, '$1 == \"Omega\" { print $3 }' '".data."/table1.csv'"))
eval tall(8.2)
eval open
set xlabel 'real part $/\,\Omega$'
set ylabel 'imaginary part $/\,\Omega$' offset -1.2, 0
set xrange [-5.8:0.3]
set yrange [0:3]
set arrow from 0, graph 0 to 0, graph 1 nohead linestyle 4
set key at graph 0.42, 1.0 bottom
u(name) = column(name) / Omega
near(n, m) = abs(column('n') - n) < 1e-9 ? m : NaN
set label '$n = 12$' at -1.13, 2.24 right
set label '$n = 12$' at -0.66, 1.03 right
set label '$n = 10$' at -0.66, 2.60 right
set label '$n = 10$' at -0.48, 0.45 right
set label '$\sqrt{7}\,i$' at 0.06, 2.62 left
set label '$\sqrt{3}\,i$' at 0.06, 1.68 left
plot data.'/figure4.csv' using (u('re1')):(u('im1')) with lines linestyle 1 title 'slower pair', \
     ''                  using (u('re2')):(u('im2')) with lines linestyle 2 title 'faster pair', \
     ''                  using (near(12, u('re1'))):(u('im1')) with points pointtype 7 pointsize 0.5 linecolor '#000000', \
     ''                  using (near(12, u('re2'))):(u('im2')) with points pointtype 7 pointsize 0.5 linecolor '#000000', \
     ''                  using (near(10, u('re1'))):(u('im1')) with points pointtype 6 pointsize 0.6 linecolor '#000000', \
     ''                  using (near(10, u('re2'))):(u('im2')) with points pointtype 6 pointsize 0.6 linecolor '#000000'

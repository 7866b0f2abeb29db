# The title page: the path of craft 1 in the plane of yaw and length error, from the nonlinear motion; where it begins
# and where it comes to rest are marked.
eval tall(7.5)
eval open
unset border
unset tics
unset grid
set margins 1, 1, 1, 1
set offsets graph 0.02, graph 0.02, graph 0.02, graph 0.02
plot data.'/figure6.csv' every 3 using 'y1':'x1' with lines linewidth 1.6 linecolor '#1b4f8a' dashtype solid, \
     '' every ::0::0 using 'y1':'x1' with points pointtype 7 pointsize 1 linecolor '#c2571a', \
     '+' every ::0::0 using (0):(5) with points pointtype 7 pointsize 0.6 linecolor '#333333'

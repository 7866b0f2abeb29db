# The title page: the path of craft 1 in the plane of yaw and length error, from the nonlinear motion.
eval tall(7.5)
eval open
unset border
unset tics
unset grid
set margins 0, 0, 0, 0
plot data.'/figure6.csv' every 3 using 'y1':'x1' with lines linewidth 1.4 linecolor '#1b4f8a' dashtype solid

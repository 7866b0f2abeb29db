# How the errors vanish: of the Runge-Kutta method with its step, of the linear model with the size of the disturbance.
eval tall(7.6)
eval open
eval besides
eval beside(1)
set title 'Runge--Kutta less the motion' offset 0, -0.6
set xlabel 'step [s]'
set ylabel 'difference after 24000\,s [m, rad]'
set xrange [4:400]
set xtics (5, 10, 20, 40, 80, 160, 320)
set ytics 100
set yrange [1e-17:1e-5]
eval 'plot '.difference('rk4_nonlinear_24000s', 'dL', 1, '$\delta L$').', '.difference('rk4_nonlinear_24000s', 'theta', 2, '$\theta$').', '.difference('rk4_nonlinear_24000s', 'psi', 3, '$\psi$')
eval beside(2)
set title 'nonlinear less linear' offset 0, -0.6
set xlabel 'part of the initial disturbance'
set ylabel 'difference after 2\,days [m, rad]'
set xrange [5e-5:2]
set xtics 1e-4, 10
set format x '$10^{%T}$'
set ytics 1e4
set yrange [1e-18:1e2]
eval 'plot '.difference('linear_172800s', 'dL', 1, '$\delta L$').', '.difference('linear_172800s', 'theta', 2, '$\theta$').', '.difference('linear_172800s', 'psi', 3, '$\psi$').', '.difference('linear_pitch_172800s', 'theta', 8, '$\theta$, from pitch alone')
unset multiplot

# What approximations leave out against what is made small: each falls along the slope of its order.
curve(study, variable, style, name) = sprintf("data.'/convergence.csv' using (strcol('study') eq '%s' && strcol('variable') eq '%s' ? column('parameter') : NaN):'difference' with linespoints linestyle %d pointtype %d title '%s'", study, variable, style, style < 8 ? 3 + 2 * style : 4, name)
panel(k) = sprintf("set margins screen %g, screen %g, screen %g, screen %g", k % 2 ? 0.625 : 0.125, k % 2 ? 0.96 : 0.46, k < 2 ? 0.645 : 0.145, k < 2 ? 0.94 : 0.44)
set logscale xy
set format '10^{%T}'
set key top left at graph 0.01, 1.0 vertical Left reverse samplen 2 width 0
set pointsize kind eq 'svg' ? 0.5 : 0.8
set title offset 0, -0.7
set xlabel offset 0, 0.5
set ylabel 'm, rad' offset 1, 0
set multiplot
eval panel(0)
set title 'nonlinear − linear, 2 days'
set xlabel 'scale of the initial disturbance'
set xtics 10
set ytics 1e4
eval 'plot [][:1e4] '.curve('linear_172800s', 'dL', 1, 'δL').', '.curve('linear_172800s', 'theta', 2, 'θ').', '.curve('linear_172800s', 'psi', 3, 'ψ').', '.curve('linear_pitch_172800s', 'theta', 8, 'θ, pitch alone')
eval panel(1)
set title 'Runge-Kutta method, 24000 s'
set xlabel 'step [s]'
set xtics (5, 10, 20, 40, 80, 160, 320)
set format x '%g'
eval 'plot [4:400][:1e-5] '.curve('rk4_nonlinear_24000s', 'dL', 1, 'δL').', '.curve('rk4_nonlinear_24000s', 'theta', 2, 'θ').', '.curve('rk4_nonlinear_24000s', 'psi', 3, 'ψ')
eval panel(2)
set title "inverse square − Hill's field, 12 h"
set xlabel 'L_{ref}/R_c'
set format x '10^{%T}'
set xtics 10
eval 'plot [1e-5:1e-3][:1e3] '.curve('hill_unequal_43200s', 'y1', 1, 'y_1').', '.curve('hill_unequal_43200s', 'dL', 2, 'δL, masses 1:2').', '.curve('hill_43200s', 'dL', 3, 'δL, masses 1:1')
eval panel(3)
set title 'motion − closed form, 12 h'
set xlabel 'amplitude of pitch [rad]'
set ytics 1e6
eval 'plot [1e-4:0.1][:1e2] '.curve('forced_43200s', 'dL', 1, 'δL').', '.curve('forced_43200s', 'psi', 3, 'ψ').', '.curve('forced_43200s', 'theta', 2, 'θ')
unset multiplot

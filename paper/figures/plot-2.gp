# Figure 2: the pair at rest on the radius, and what acts on each craft.
eval tall(5.4)
eval open
eval drawing
set xrange [-6.2:6.4]
set yrange [-2.15:2.15]
set arrow from -6.1, 0 to 6.0, 0 filled linestyle 5
set label '$\hat o_r$' at 6.15, 0.32 center
set arrow from 0, -1.2 to 0, 1.5 filled linestyle 5
set label '$\hat o_\theta$' at 0.32, 1.5 center
set object circle at 0, 0 size 0.07 fillstyle solid border linecolor '#333333' fillcolor '#333333'
set label 'to the Earth' at -6.1, -0.3 left
set arrow from -1.7, 0 to 3.4, 0 nohead linestyle 7
x1 = 3.4; x2 = -1.7
set object circle at x1, 0 size 0.22 front fillstyle solid border linecolor '#333333' fillcolor '#c2571a'
set object circle at x2, 0 size 0.32 front fillstyle solid border linecolor '#333333' fillcolor '#1b4f8a'
set label '$m_1,\ q_1>0$' at x1, 0.72 center
set label '$m_2,\ q_2<0$' at x2, 0.82 center
set arrow from x1 + 0.25, 0 to x1 + 1.6, 0 filled front linestyle 1
set label 'tide' at x1 + 1.0, 0.3 center
set arrow from x1 - 0.25, 0 to x1 - 1.6, 0 filled front linestyle 2
set label 'charge' at x1 - 1.2, -0.3 center
set arrow from x2 - 0.35, 0 to x2 - 1.7, 0 filled front linestyle 1
set label 'tide' at x2 - 1.1, 0.3 center
set arrow from x2 + 0.35, 0 to x2 + 1.5, 0 filled front linestyle 2
set label 'charge' at x2 + 1.0, -0.3 center
set arrow from x2, -1.5 to 0, -1.5 heads filled linestyle 4
set label '$\frac{m_1}{m_1+m_2}L_{\mathrm{ref}}$' at x2 / 2, -1.95 center
set arrow from 0, -1.5 to x1, -1.5 heads filled linestyle 4
set label '$\frac{m_2}{m_1+m_2}L_{\mathrm{ref}}$' at x1 / 2, -1.95 center
set arrow from x1, -0.35 to x1, -1.65 nohead linestyle 5
set arrow from x2, -0.45 to x2, -1.65 nohead linestyle 5
set arrow from 0, -0.15 to 0, -1.65 nohead linestyle 5
plot NaN

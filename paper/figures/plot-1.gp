# Figure 1: the Hill frame about a point of a circular orbit, seen from a little above the orbit's plane.
eval tall(7.2)
eval open
eval drawing
set xrange [-4.4:7.0]
set yrange [-2.45:2.95]
set parametric
tilt = 0.42                       # the orbit's circle is seen as an ellipse of this flatness
R = 4.0
at = -0.55                        # where the origin stands on it
X = R * cos(at); Y = tilt * R * sin(at)
set object circle at 0, 0 size 0.75 fillstyle solid 0.12 border linecolor '#333333' fillcolor '#1b4f8a'
set label 'Earth' at 0, 0 center
set arrow from 0.68 * cos(at), 0.68 * tilt * sin(at) to X, Y nohead linestyle 5
set label '$R_c$' at 0.42 * X, 0.42 * Y - 0.26 center
ox = cos(at); oy = tilt * sin(at)
set arrow from X, Y to X + 2.2 * ox, Y + 2.2 * oy filled linestyle 1
set label '$\hat o_r$' at X + 2.42 * ox, Y + 2.42 * oy center
set arrow from X, Y to X - 1.9 * sin(at), Y + 1.9 * tilt * cos(at) filled linestyle 1
set label '$\hat o_\theta$' at X - 2.15 * sin(at), Y + 2.15 * tilt * cos(at) + 0.12 center
set arrow from X, Y to X, Y + 1.9 filled linestyle 1
set label '$\hat o_h$' at X - 0.02, Y + 2.12 center
set object circle at X, Y size 0.06 fillstyle solid border linecolor '#333333' fillcolor '#333333'
set label '$\mathcal{O}$' at X - 0.15, Y - 0.25 right
cx = X + 1.35 * ox + 0.55 * (-sin(at)); cy = Y + 1.35 * oy + 0.55 * tilt * cos(at) + 0.75
set arrow from X, Y to cx, cy filled linestyle 2
set label '$\boldsymbol\rho$' at 0.5 * (X + cx) + 0.22, 0.5 * (Y + cy) - 0.1 center
set object circle at cx, cy size 0.11 fillstyle solid border linecolor '#333333' fillcolor '#c2571a'
set label 'craft' at cx + 0.25, cy + 0.08 left
set label '$\Omega$' at R * cos(1.75), tilt * R * sin(1.75) + 0.3 center
set arrow from R * cos(1.68), tilt * R * sin(1.68) to R * cos(1.80), tilt * R * sin(1.80) filled linestyle 4
plot [-pi:pi] R * cos(t), tilt * R * sin(t) with lines linestyle 5

# Figure 3: the angles of the rod, psi within the orbit's plane and theta out of it, in parallel projection.
eval tall(7.0)
eval open
eval drawing
set xrange [-4.6:6.2]
set yrange [-2.6:3.0]
set parametric
# The picture of a point (x, y, z) of the Hill frame: the radius to the right and down, the velocity to the right and up.
H(x, y, z) = 0.86 * x + 0.62 * y
V(x, y, z) = -0.34 * x + 0.42 * y + 0.90 * z
psi = 0.62; theta = -0.50; r = 4.6
a1(l) = l * cos(theta) * cos(psi); a2(l) = l * cos(theta) * sin(psi); a3(l) = -l * sin(theta)
point(x, y, z) = sprintf("%.4f, %.4f", H(x, y, z), V(x, y, z))
eval "set arrow from ".point(-1.2, 0, 0)." to ".point(5.2, 0, 0)." filled linestyle 4"
eval "set label '$\\hat o_r$' at ".point(5.5, 0, -0.1)." center"
eval "set arrow from ".point(0, -1.2, 0)." to ".point(0, 4.2, 0)." filled linestyle 4"
eval "set label '$\\hat o_\\theta$' at ".point(0, 4.6, 0)." center"
eval "set arrow from ".point(0, 0, -0.8)." to ".point(0, 0, 2.9)." filled linestyle 4"
eval "set label '$\\hat o_h$' at ".point(-0.3, 0, 2.95)." center"
eval "set arrow from 0, 0 to ".point(a1(r), a2(r), a3(r))." nohead linestyle 1"
eval "set arrow from 0, 0 to ".point(a1(-2.0), a2(-2.0), a3(-2.0))." nohead linestyle 1"
eval "set arrow from ".point(a1(r), a2(r), a3(r))." to ".point(a1(1.28 * r), a2(1.28 * r), a3(1.28 * r))." filled linestyle 2"
eval "set label '$\\hat b_1$' at ".point(a1(1.36 * r), a2(1.36 * r), a3(1.36 * r))." center"
eval "set object circle at ".point(a1(r), a2(r), a3(r))." size 0.13 front fillstyle solid border linecolor '#333333' fillcolor '#c2571a'"
eval "set label '$m_1$' at ".point(a1(r), a2(r), a3(r) + 0.38)." center"
eval "set object circle at ".point(a1(-2.0), a2(-2.0), a3(-2.0))." size 0.18 front fillstyle solid border linecolor '#333333' fillcolor '#1b4f8a'"
eval "set label '$m_2$' at ".point(a1(-2.0), a2(-2.0), a3(-2.0) - 0.45)." center"
# the foot of the rod in the orbit's plane
eval "set arrow from 0, 0 to ".point(a1(r), a2(r), 0)." nohead linestyle 5"
eval "set arrow from ".point(a1(r), a2(r), 0)." to ".point(a1(r), a2(r), a3(r))." nohead linestyle 5"
s = 2.4
eval "set label '$\\psi$' at ".point(1.18 * s * cos(psi / 2), 1.18 * s * sin(psi / 2), 0)." center"
w = 3.0
eval "set label '$-\\theta$' at ".point(1.12 * w * cos(theta / 2) * cos(psi), 1.12 * w * cos(theta / 2) * sin(psi), -1.12 * w * sin(theta / 2))." center"
plot [0:1] H(s * cos(psi * t), s * sin(psi * t), 0), V(s * cos(psi * t), s * sin(psi * t), 0) with lines linestyle 4, \
     H(w * cos(theta * t) * cos(psi), w * cos(theta * t) * sin(psi), 0), \
     V(w * cos(theta * t) * cos(psi), w * cos(theta * t) * sin(psi), -w * sin(theta * t)) with lines linestyle 4

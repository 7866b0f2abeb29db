# The slow law: a pitch of 0.2 rad for 30 days, its amplitude, and the one that the closed form gives it.
set xrange [0:30]
set xlabel 'time [days]'
set ylabel 'pitch θ [rad]'
set yrange [-0.22:0.22]
set ytics 0.05
plot data.'/pitch.csv' using (days(column('t'))):'theta' with lines linewidth 0.8 linecolor '#999999' title 'θ', \
     ''                using (days(column('t'))):'amplitude_law' with lines linestyle 7 title 'slow law', \
     ''                using (days(column('t'))):'amplitude' with lines linestyle 1 title 'amplitude'

# What all figures share, read before each of them. From the command line: `data`, the folder of the CSV
# files; `picture`, the file to draw; `kind`, svg or png.
# Lines differ by dash or width as well as by shade: nothing is lost in grayscale.
set encoding utf8
set minussign
set datafile separator ','
set datafile columnheaders

if (kind eq 'svg') {
    set terminal svg size 760,520 dynamic font 'DejaVu Sans,14' background '#ffffff' butt
} else {
    set terminal pngcairo size 1520,1040 fontscale 2 linewidth 2 font 'DejaVu Sans,11.5' background '#ffffff' butt
}
set output picture

set style line 1 linewidth 2.2 linecolor '#1b4f8a' dashtype solid
set style line 2 linewidth 2.2 linecolor '#c2571a' dashtype (8, 3)
set style line 3 linewidth 2.2 linecolor '#2f7a3d' dashtype (8, 2, 2, 2)
set style line 7 linewidth 5.5 linecolor '#cccccc' dashtype solid    # broad and pale: what lies beneath
set style line 8 linewidth 1.1 linecolor '#555555' dashtype (6, 4)   # a value to compare with
set style line 9 linewidth 0.6 linecolor '#dddddd' dashtype solid    # the grid

set border 3 linewidth 0.9 linecolor '#333333'
set tics nomirror out scale 0.7
set grid linestyle 9
set key noautotitle horizontal samplen 2.6 width 1 bottom right at graph 1, 1.005
set margins screen 0.145, screen 0.97, screen 0.14, screen 0.925

# A motion is drawn against days, in panels one above the other: `eval panels(N)`, then for each panel
# `eval next`, its own settings and a plot.
days(t) = t / 86400.0
time_axis = "set xrange [0:3]; set xtics 0.5; set xlabel 'time [days]'"
panels(N) = sprintf("count = %d; panel = 0; %s; set multiplot", N, time_axis)
next = "height = 0.855 / count; panel = panel + 1; base = 0.14 + (count - panel) * height; \
        set margins screen 0.145, screen 0.97, screen base, screen base + height - 0.07; \
        if (panel < count) { set format x ''; unset xlabel } \
        else { set format x '%h'; set xlabel 'time [days]' }"

# What the plots of the literate edition share. On paper LaTeX sets their text, in the fonts of the page; for the web
# plain.sed has made it plain. From the command line: `data`, the folder of the CSV files; `name`, the plot, for paper;
# `picture`, the file, for the web. Lines differ by dash or width as
# well as by shade: nothing is lost in grayscale.
set encoding utf8
set datafile separator ','
set datafile columnheaders
tall(height) = exists('picture') ? sprintf("set terminal svg enhanced size 575,%.0f font 'serif,12' linewidth 0.8 dashlength 0.7 butt", 37.8 * height) \
               : sprintf("set terminal cairolatex pdf size 15.2cm,%.2fcm font ',9' linewidth 1.6 dashlength 1 butt", height)
open = exists('picture') ? "set output picture" : "set output 'plot-'.name.'.tex'"
eval tall(7.4)
eval open

set style line 1 linewidth 2.2 linecolor '#1b4f8a' dashtype solid
set style line 2 linewidth 2.2 linecolor '#c2571a' dashtype (8, 3)
set style line 3 linewidth 2.2 linecolor '#2f7a3d' dashtype (8, 2, 2, 2)
set style line 4 linewidth 1.2 linecolor '#333333' dashtype solid    # outlines of drawings
set style line 5 linewidth 1.0 linecolor '#777777' dashtype (5, 4)   # what is only thought of
set style line 7 linewidth 11 linecolor '#c8c8c8' dashtype solid    # broad and pale: what lies beneath
set style line 8 linewidth 1.1 linecolor '#555555' dashtype (6, 4)   # a value to compare with
set style line 9 linewidth 0.6 linecolor '#dddddd' dashtype solid    # the grid

set border 3 linewidth 0.9 linecolor '#333333'
set tics nomirror out scale 0.6
set grid linestyle 9
set key noautotitle horizontal samplen 2.4 width 1 spacing 1.3 at graph 1, 1.03 bottom right
set lmargin at screen 0.13
set rmargin at screen 0.985
set tmargin at screen 0.9

# A motion against days, in panels one above the other: `eval panels(N)`, then `eval next` before each.
days(t) = t / 86400.0
time_axis = "set xrange [0:3]; set xtics 0.5; set xlabel 'time [days]'"
panels(N) = sprintf("count = %d; panel = 0; %s; set multiplot", N, time_axis)
next = "height = 0.86 / count; panel = panel + 1; base = 0.135 + (count - panel) * height; \
        set tmargin at screen base + height - 0.075; set bmargin at screen base; \
        if (panel < count) { set format x ''; unset xlabel } \
        else { set format x '$%h$'; set xlabel 'time [days]' }"

# Two plots beside each other: `eval besides`, then `eval beside(K)` before each. How fast differences vanish:
# those of data/convergence.csv against what is made small, and a line of slope p through a point.
besides = "set multiplot; set logscale xy; set format y '$10^{%T}$'; set bmargin at screen 0.19; set tmargin at screen 0.89; \
           set key at graph 0.03, 0.99 top left vertical Left reverse width 0 samplen 2; set ylabel offset -0.6, 0"
beside(k) = sprintf("set lmargin at screen %g; set rmargin at screen %g", k == 1 ? 0.105 : 0.625, k == 1 ? 0.465 : 0.985)
difference(study, variable, style, title) = sprintf("data.'/convergence.csv' using (strcol('study') eq '%s' && \
  strcol('variable') eq '%s' ? column('parameter') : NaN):'difference' with linespoints linestyle %d pointtype %d \
  pointsize 0.7 title '%s'", study, variable, style, 3 + 2 * (style % 4), title)

# A drawing has neither axes nor key, and one scale for both directions.
drawing = "unset border; unset tics; unset grid; unset key; set margins 0, 0, 0, 0; set size ratio -1"

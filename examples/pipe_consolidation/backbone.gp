# SPDX-License-Identifier: BSD-3-Clause
# V against v D / c_v, of the results.csv of study.toml:
#   gnuplot -e 'folder="out/pipe_backbone"' examples/pipe_consolidation/backbone.gp
set datafile separator comma
set terminal pngcairo size 900,600
set output folder."/backbone.png"
file = folder."/results.csv"
undrained = real(system("grep '^pipe,undrained' ".file." | cut -d, -f3"))
drained = real(system("grep '^pipe,drained' ".file." | cut -d, -f3"))
set logscale x
set xrange [0.003:300]
set yrange [0:7.5]
set xlabel "v D / c_v"
set ylabel "V (kN/m)"
set key top right
set grid
f(x) = undrained * (1 + (drained / undrained - 1) / (1 + (x / 0.3)**0.85))
plot drained title "drained" dashtype 2 linewidth 2, undrained title "undrained" dashtype 3 linewidth 2, \
     f(x) title "backbone, 50 % at 0.3, exponent 0.85" linewidth 2, \
     "< grep -v drained ".file using 2:3 skip 1 title "berm, w = 0.27 to 0.3 D" with points pointtype 7 pointsize 1.5

# The time of a step against how far the shape is from where level 0 has it. Set csv and svg with gnuplot -e.
set terminal svg size 1200,560 font "DejaVu Sans,13" background "white"
set output svg
set datafile separator ","
set logscale y
set xlabel "off from level 0, median of the steps, mm"
set ylabel "99th percentile of a step, microseconds"
set grid xtics ytics lc rgb "#dddddd"
set key top right
row(curve) = sprintf("< awk -F, '$1 == \"%s\" && $2 != \"auto\"' %s", curve, csv)
auto(curve) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"auto\"' %s", curve, csv)
set multiplot layout 1,2
do for [curve in "radial fractal"] {
    set title curve." curve, 65536 edges, 64 in the hand"
    plot row(curve) using 6:($5 / 1000) with linespoints lw 2 pt 7 ps 0.7 title "levels 0, 1, 2 ...", \
        row(curve) using 6:($5 / 1000):2 with labels offset 1,0.6 notitle, \
        auto(curve) using 6:($5 / 1000) with points pt 3 ps 1.5 lw 2 title "level by speed"
}
unset multiplot

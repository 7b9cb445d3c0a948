# The 99th percentile of the servo steps against the number of edges, one curve beside the other.
# Set csv and svg with gnuplot -e.
set terminal svg size 1200,560 font "DejaVu Sans,13" background "white"
set output svg
set datafile separator ","
set datafile missing ""
set logscale xy
set xlabel "edges"
set xtics ("512" 512, "4096" 4096, "65536" 65536, "1 048 576" 1048576)
set xrange [400:2000000]
set yrange [100:1e10]
set format y "10^{%L}"
set grid xtics ytics lc rgb "#dddddd"
set linetype 5 lc rgb "#8c6d00"
set key top left reverse Left samplen 2
names = "Touchline level auto|Touchline level 0|plain proxy over uniform grid|plain proxy over AABB tree (CGAL)|plain proxy over R-tree (Boost.Geometry)|plain proxy over brute force|Box2D 2.4 whole step (0.5 mm disc)"
name(i) = system(sprintf("echo '%s' | cut -d'|' -f%d", names, i))
row(i, curve) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"step\" && $3 == \"%s\"' %s", name(i), curve, csv)
set multiplot layout 1,2
do for [curve in "radial fractal"] {
    set title curve." curve"
    set ylabel "99th percentile of a step, nanoseconds"
    plot for [i = 1:7] row(i, curve) using 4:8 with linespoints lw (i < 3 ? 3 : 1.5) pt i ps 0.9 title name(i)
}
unset multiplot

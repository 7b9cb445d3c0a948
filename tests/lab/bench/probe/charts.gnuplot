# The 99th percentile of a step against the edges of the scene, one line a shape (chart steps); the time of a step against how
# far the shape is from where level 0 has it (chart accuracy). Set chart, csv and svg with gnuplot -e.
set terminal svg size 1200,560 font "DejaVu Sans,13" background "white"
set output svg
set datafile separator ","
if (chart eq "steps") {
    set logscale xy
    set xlabel "edges of the scene"
    set ylabel "99th percentile of a step, microseconds"
    set xtics ("512" 512, "4096" 4096, "65536" 65536, "1 048 576" 1048576)
    set xrange [400:2000000]
    set yrange [0.1:10000]
    set grid xtics ytics lc rgb "#dddddd"
    set linetype 5 lc rgb "#8c6d00"
    set key top left reverse Left samplen 2
    shapes = "0 4 16 64 256"
    name(i) = word(shapes, i) eq "0" ? "a point" : word(shapes, i)." edges"
    row(i, level) = sprintf("< awk -F, '$1 == \"radial\" && $2 == %s && $4 == \"%s\"' %s", word(shapes, i), level, csv)
    set multiplot layout 1,2
    do for [level in "auto 0"] {
        set title level eq "auto" ? "radial curve, level by speed" : "radial curve, level 0"
        plot for [i = 1:5] row(i, level) using 3:($7 / 1000) with linespoints lw (i == 4 ? 3 : 1.5) pt i ps 0.9 title name(i), \
            30 with lines lw 1 dt 2 lc rgb "#888888" title "bar for 64 edges on 65536"
    }
    unset multiplot
} else {
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
}

# The 99th percentile of the servo steps against the number of edges, one curve beside the other (chart steps); time of a step
# against error, by levels and budgets of boxes and walks (chart accuracy). Set chart, csv and svg with gnuplot -e.
set output svg
set datafile separator ","
if (chart eq "steps") {
    set terminal svg size 1200,560 font "DejaVu Sans,13" background "white"
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
} else {
    set terminal svg size 1200,900 font "DejaVu Sans,13" background "white"
    set logscale xy
    set logscale x2
    least = 1e-3
    at_least(v) = v > least ? v : least
    named(error) = column(error) > least ? stringcolumn(2) : ""  # those without error lie on one another
    set linetype 5 lc rgb "#8c6d00"
    set xrange [least * 0.6:100]
    set x2range [least * 1.2:200]
    set yrange [100:2e4]
    set format y "10^{%L}"
    set format x "%g"
    set format x2 "%g"
    set xtics nomirror
    set x2tics
    set grid xtics ytics lc rgb "#dddddd"
    set key top right
    rows(series, curve) = sprintf("< awk -F, '$1 == \"%s\" && $3 == \"%s\" && $4 == 65536 && $2 < 1e6' %s", series, curve, csv)
    set multiplot layout 2,2
    do for [kind in "RMS largest"] {
        force = kind eq "RMS" ? 11 : 12
        do for [curve in "radial fractal"] {
            set title curve." curve, ".kind." error" offset 0,0.5
            set xlabel "force error against level 0, newtons (0.001: that or less)"
            set x2label "place error of the proxy, millimetres"
            set ylabel "99th percentile of a step, ns"
            plot rows("level", curve) using (at_least(column(force))):8 with linespoints pt 7 ps 0.7 lw 2 title "fixed level 0, 1, 2 ...", \
                 rows("level", curve) using (at_least(column(force))):8:2 with labels offset 0.8,0.6 font ",10" notitle, \
                 rows("budget", curve) using (at_least(column(force))):8 with linespoints pt 5 ps 0.7 lw 2 title "level 0, budget of 1, 2, 4 ... boxes", \
                 rows("budget", curve) using (at_least(column(force))):8:(named(force)) with labels offset 0.8,-0.6 font ",10" notitle, \
                 rows("walks", curve) using (at_least(column(force))):8 with linespoints pt 9 ps 0.7 lw 2 title "level 0, at most 16, 32 ... 4096 edges a tick", \
                 rows("walks", curve) using (at_least(column(force))):8:(named(force)) with labels offset -1.2,-0.6 font ",10" notitle
        }
    }
    unset multiplot
}

# Time, processor time and memory against size. Set chart (pictures, start, restart, use), csv and svg with gnuplot -e.
set terminal svg size 800,480 font "DejaVu Sans,13" background "white"
set output svg
set datafile separator ","
set grid xtics ytics lc rgb "#dddddd"
set key top left reverse Left samplen 2
set yrange [0:*]
if (chart eq "pictures") {
    set logscale x
    set xtics (0.3, 1, 3, 6, 12, 24)
    set xlabel "megapixels of the JPEG"
    set ylabel "chosen to force, ms"
    plot csv using 1:2 every ::1 with linespoints lw 3 pt 7 title "median", csv using 1:3 every ::1 with linespoints lw 1.5 pt 5 title "90 of 100", \
        1000 with lines lw 2 dt 2 lc rgb "#888888" title "bar for 12 megapixels"
}
if (chart eq "start") {
    set logscale x
    set xtics (14, 56, 224)
    set xlabel "pictures of the gallery"
    set ylabel "start to the screen that waits, s"
    row(cache) = sprintf("< awk -F, '$2 == \"%s\"' %s", cache, csv)
    plot row("warm") using 1:3 with linespoints lw 3 pt 7 title "files in memory", row("cold") using 1:3 with linespoints lw 3 pt 5 title "files on the disk", \
        2 with lines lw 2 dt 2 lc rgb "#888888" title "bar"
}
if (chart eq "restart") {
    set logscale x
    set xlabel "edges of the picture"
    set ylabel "death of the servo to force, ms"
    plot csv using 1:3 every ::1 with linespoints lw 3 pt 7 title "median", csv using 1:4 every ::1 with linespoints lw 1.5 pt 5 title "90 of 100", \
        500 with lines lw 2 dt 2 lc rgb "#888888" title "bar"
}
if (chart eq "use") {
    set terminal svg size 1100,480 font "DejaVu Sans,13" background "white"
    row(state) = sprintf("< awk -F, '$1 == \"%s\"' %s", state, csv)
    set xlabel "megapixels of the screen"
    set multiplot layout 1,2
    set ylabel "share of a core, %"
    plot row("idle") using ($2 * $3 / 1e6):4 with linespoints lw 3 pt 7 title "nobody here", \
        row("in use") using ($2 * $3 / 1e6):4 with linespoints lw 3 pt 5 title "in use", \
        3 with lines lw 2 dt 2 lc rgb "#888888" title "bar, nobody here", 35 with lines lw 2 dt 3 lc rgb "#888888" title "bar, in use"
    set ylabel "memory of all processes, MB"
    plot row("idle") using ($2 * $3 / 1e6):6 with linespoints lw 3 pt 7 title "nobody here", \
        row("in use") using ($2 * $3 / 1e6):6 with linespoints lw 3 pt 5 title "in use", 250 with lines lw 2 dt 2 lc rgb "#888888" title "bar"
    unset multiplot
}

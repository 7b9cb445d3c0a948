# What the hand followed, and how much of each picture it found. Set data and results with gnuplot -e.
set datafile separator ","
set encoding utf8
set terminal pngcairo size 1400,1000 font "DejaVu Sans,10" background "white"
set output results."/tracing.png"
set multiplot layout 2,3 title "Gallery pictures traced by a simulated hand that feels only force and handle position"
set size ratio -1
set xlabel "mm"
set ylabel "mm"
set xrange [-60:60]
set yrange [-45:45]
set key outside below
set style line 1 lc rgb "#bbbbbb" pt 7 ps 0.35
set style line 2 lc rgb "#7799dd" lw 1
set style line 3 lc rgb "#cc2200" pt 7 ps 0.25
show(name, mode) = data."/".name.".".mode
do for [name in "02-star 06-fish 43-maze"] {
    set title name." in groove mode, in time"
    plot show(name, "outline.csv") with points ls 1 title "outline", \
        show(name, "groove.way.csv") with lines ls 2 title "searching and probing", \
        show(name, "groove.csv") with points ls 3 title "followed by feel"
}
set title "06-fish with forces off: nothing is found"
plot show("06-fish", "outline.csv") with points ls 1 title "outline", \
    show("06-fish", "off.way.csv") with lines ls 2 title "searching"
set title "06-fish in a tour"
plot show("06-fish", "outline.csv") with points ls 1 title "outline", \
    show("06-fish", "tour.way.csv") with lines ls 2 title "led, all the way", \
    show("06-fish", "tour.csv") with points ls 3 title "led along a line"
set size noratio
set title "Outline within 2 mm of the path, picture by picture"
set xlabel "picture of the gallery"
set ylabel "share of the length, %"
set xrange [0:57]
set yrange [0:105]
row(mode) = "< awk -F, '$1 == \"".mode."\" { print ++n \",\" 100 * $7 }' ".data."/tracing.csv"
plot row("groove") with points pt 7 lc rgb "#cc2200" title "groove", \
    row("tour") with points pt 4 ps 1.2 lc rgb "#2255bb" title "tour", \
    row("wall") with points pt 9 lc rgb "#888888" title "wall", \
    row("off") with points pt 2 lc rgb "#000000" title "forces off", \
    90 with lines dt 2 lc rgb "#000000" title "asked for"

# Errors, noise and times of the methods. Set results and work with gnuplot -e.
set datafile separator ","
set encoding utf8
methods = "13/7|Haar|5/3|9/7|subsampling|Douglas-Peucker|Visvalingam"
name(i) = system(sprintf("echo '%s' | cut -d'|' -f%d", methods, i))
row(file, i) = sprintf("< awk -F, '$1 == \"%s\"' %s/%s.csv", name(i), work, file)
noisy(i, noise) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\" && $3 != \"denoised\"' %s/curve_noise.csv", noise, name(i), work)
width(i) = i == 1 ? 3 : 1.5
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set xtics (4, 8, 16, 32, 64, 128, 256)
set xrange [3.5:300]

set terminal pngcairo size 1280,860 font "DejaVu Sans,9" background "white"
set output results."/curve_errors.png"
set multiplot layout 3,4 columnsfirst
do for [set in "pinned drawn traced noisy"] {
    set title set eq "pinned" ? "pieces between pins" : set eq "noisy" ? "drawn + 0.2 mm noise" : set." outlines"
    drawn = set eq "pinned" ? "1 3 4 5 6 7" : "1 2 3 4 5 6 7"
    set key off
    set xlabel ""
    set ylabel "RMS, ‰ of the diagonal"
    plot for [i in drawn] row("curve_errors_".set, int(i)) using 3:4 with linespoints lw width(int(i)) pt int(i) lc int(i) ps 0.7 title name(int(i))
    unset title
    set ylabel "slope RMS, degrees"
    plot for [i in drawn] row("curve_errors_".set, int(i)) using 3:6 with linespoints lw width(int(i)) pt int(i) lc int(i) ps 0.7 title name(int(i))
    set ylabel "mean half-width of boxes, ‰"
    set xlabel "segments"
    if (set eq "noisy") { set key bottom left }
    plot for [i in drawn] row("curve_errors_".set, int(i)) using 3:7 with linespoints lw width(int(i)) pt int(i) lc int(i) ps 0.7 title name(int(i))
}
unset multiplot

set terminal pngcairo size 1200,480 font "DejaVu Sans,10" background "white"
set output results."/curve_noise.png"
set multiplot layout 1,3
set xtics (8, 16, 32, 64, 128, 256, 512)
set xrange [6:700]
set yrange [0.04:4]
set xlabel "points"
set ylabel "RMS from the outline without noise, mm"
do for [noise in "0.1 0.2 0.3"] {
    set title "noise of ".noise." mm"
    if (noise eq "0.1") { set key top right } else { set key off }
    plot for [i = 1:7] noisy(i, noise) using 4:5 with linespoints lw width(i) pt i ps 0.7 title name(i)
}
unset multiplot

set terminal pngcairo size 1200,560 font "DejaVu Sans,10" background "white"
set output results."/curve_times.png"
set multiplot layout 1,2 title "The outline of a traced hand, 512 points; each line from 256 points (lowest) to 8"
unset title
set xtics auto
set xrange [0.3:3000]
set yrange [*:*]
set xlabel "time from the points to the coarse curve, microseconds"
set key off
set ylabel "RMS, ‰ of the diagonal"
plot for [i = 1:7] row("curve_times", i) using 4:5 with linespoints lw width(i) pt i ps 0.9 title name(i)
set key bottom right
set ylabel "mean half-width of boxes, ‰ of the diagonal"
set yrange [1e-4:1e2]
plot for [i = 1:7] row("curve_times", i) using 4:8 with linespoints lw width(i) pt i ps 0.9 title name(i)
unset multiplot

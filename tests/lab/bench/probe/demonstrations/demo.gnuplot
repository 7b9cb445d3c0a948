# A shape's way past lines, and the force and torque on the hand. Set scene, way, run, svg, name and window with gnuplot -e.
set terminal svg size 1200,520 font "DejaVu Sans,13" background "white"
set output svg
set multiplot
set size 0.46,1
set origin 0,0
set size ratio -1
set title name.": the shape ten times a second, light to dark"
set xlabel "mm"
set ylabel "mm"
set grid lc rgb "#eeeeee"
eval window
set palette defined (0 "#c6dbef", 1 "#08306b")
unset colorbox
plot way using 1:2:3 with lines lw 1.2 lc palette notitle, scene using 1:2 with lines lw 3 lc rgb "#d95f02" notitle
set size noratio
set autoscale
set datafile separator ","
set xlabel "s"
set size 0.54,0.5
set origin 0.46,0.5
set title "Force on the hand"
set ylabel "N"
set key bottom right
plot run using 1:6 with lines lw 1.5 lc rgb "#1b6ca8" title "right", run using 1:7 with lines lw 1.5 dt 2 lc rgb "#d95f02" title "up"
set origin 0.46,0
set title "Torque on the hand, counter-clockwise"
set ylabel "mNm"
plot run using 1:($19 * 1000) with lines lw 1.5 lc rgb "#444444" notitle
unset multiplot

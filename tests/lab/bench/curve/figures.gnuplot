# The paper's Figs. 1 to 4 from our code. Set results and work with gnuplot -e.
set encoding utf8
set border 0
unset key
unset tics
black = "#202020"

set terminal pngcairo size 1000,800 font "DejaVu Sans,11" background "white"
set output results."/fig1.png"
set multiplot layout 7,1 margins 0.09,0.98,0.02,0.96 spacing 0,0.02
set xrange [0:512]
set title "data, and its wavelet coefficients from level 1 (fine) to level 6 (coarse)"
set ylabel "data"
plot work."/fig2.dat" index 0 with lines lc rgb black
unset title
do for [level = 1:6] {
    set ylabel sprintf("level %d", level)
    plot work."/fig1.dat" index level - 1 with impulses lc rgb "#1060c0" lw 1.5, 0 lc rgb "#a0a0a0"
}
unset multiplot
unset ylabel

set terminal pngcairo size 1000,800 font "DejaVu Sans,11" background "white"
set output results."/fig2.png"
set multiplot layout 4,1 margins 0.09,0.98,0.02,0.98 spacing 0,0.02
do for [level in "0 2 4 6"] {
    set ylabel "level ".level
    plot work."/fig2.dat" index int(level) with linespoints pt 7 ps (int(level) > 2 ? 0.7 : 0) lc rgb black
}
unset multiplot
unset ylabel

set terminal pngcairo size 1350,400 font "DejaVu Sans,11" background "white"
set output results."/fig3.png"
set size ratio -1
set xrange [-54:54]
set yrange [-43:43]
set multiplot layout 1,3 margins 0.01,0.99,0.01,0.92 spacing 0.01,0
titles = "level 0: 512 points|level 2: 128 points|level 4: 32 points"
do for [i = 1:3] {
    set title system(sprintf("echo '%s' | cut -d'|' -f%d", titles, i))
    plot work."/fig3.dat" index i - 1 with linespoints pt 7 ps (i == 1 ? 0.25 : 0.6) lc rgb black
}
unset multiplot

set terminal pngcairo size 1100,840 font "DejaVu Sans,11" background "white"
set output results."/fig4.png"
set multiplot layout 2,2 margins 0.01,0.99,0.01,0.96 spacing 0.01,0.05
set xrange [-58:58]
set yrange [-42:42]
titles = "20 mm away|4 mm away|1 mm away|0.1 mm away"
do for [i = 1:4] {
    set title "the handle is ".system(sprintf("echo '%s' | cut -d'|' -f%d", titles, i))
    plot work."/fig4.dat" index 0 with lines lc rgb "#909090", \
         work."/fig4.dat" index 2 * i - 1 with lines lc rgb "#1060c0", \
         work."/fig4.dat" index 2 * i with points pt 7 ps 1.3 lc rgb "#d02020"
}
unset multiplot

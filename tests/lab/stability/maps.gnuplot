# The stability maps with the limits of theory drawn over them. Set results with gnuplot -e.
set terminal svg size 1200,860 font "DejaVu Sans,12" background "white"
set datafile separator ","
set datafile missing "inf"
set encoding utf8
set grid xtics ytics lc rgb "#dddddd"
set style line 1 lc rgb "#000000" lw 2 pt 4
set style line 2 lc rgb "#d55e00" lw 2 pt 5
set style line 3 lc rgb "#0072b2" lw 2 pt 7
set style line 4 lc rgb "#009e73" lw 2 pt 9
set style line 5 lc rgb "#cc79a7" lw 2 pt 11
set style line 6 lc rgb "#8c6d00" lw 2 pt 13
set style line 9 lc rgb "#777777" lw 1.5 dt 2
set style line 10 lc rgb "#777777" lw 1.5 dt 4
# Columns: 1 method, 2 hand, 4 period, 5 delay, 6 damping, 7 encoder, 8 friction, 9 knock, 10 limit, 13 linear, 14 passive, 15 quantiser, 16 exact, 17 calmed
rows(file, condition) = sprintf("< awk -F, 'FNR > 2 && (%s)' %s/%s.csv", condition, results, file)
word_of(names, i) = system(sprintf("echo '%s' | cut -d'|' -f%d", names, i))
is(column, value) = sprintf("$%d == \"%s\"", column, value)
set logscale y
set format y "%.0f"

methods = "spring|spring + LP100|spring + FOAW16|local model|energy observer|slope bound"
set output results."/period.svg"
set multiplot layout 2,2 title "Largest stiffness that comes to rest, by method"
set logscale x
set xtics (0.25, 0.5, 1, 2, 4)
set xrange [0.22:4.5]
set yrange [10:60000]
set xlabel "period, ms"
do for [hand in "none light"] { do for [delay in "0 1"] {
    set title (hand eq "none" ? "device alone" : "light hand").(delay eq "0" ? ", no delay" : ", a period of delay")
    set ylabel "N/m"
    unset key
    if (hand eq "none" && delay eq "0") { set key bottom left samplen 2 font ",9" }
    at(i) = rows("period", is(1, word_of(methods, i))." && ".is(2, hand)." && ".is(5, delay))
    plot for [i = 1:6] at(i) using 4:10 with linespoints ls i ps 0.8 title word_of(methods, i), \
         at(1) using 4:13 with lines ls 9 title "b/(T/2 + t_d)", at(2) using 4:13 with lines ls 10 title "(b + B)/(T/2 + t_d)"
} }
unset multiplot

filters = "spring + difference|spring + LP100|spring + FOAW16"
set output results."/damping.svg"
set multiplot layout 2,2 title "Largest stiffness that comes to rest against virtual damping, device alone, encoder 20 µm"
unset logscale x
set xtics auto
set xrange [0:31]
set yrange [30:40000]
set xlabel "virtual damping B, N s/m"
do for [period in "2 1"] { do for [delay in "0 1"] {
    set title "T = ".period." ms".(delay eq "0" ? ", no delay" : ", a period of delay")
    set ylabel "N/m"
    unset key
    if (period eq "2" && delay eq "0") { set key bottom right samplen 2 font ",9" }
    at(i) = rows("damping", is(1, word_of(filters, i))." && ".is(4, period)." && ".is(5, delay))
    plot for [i = 1:3] at(i) using 6:10 with linespoints ls i ps 0.8 title word_of(filters, i), \
         at(1) using 6:16 with lines ls 10 title "eigenvalues, difference", at(2) using 6:16 with lines ls 9 lc rgb "#d55e00" title "eigenvalues, LP100", \
         at(1) using 6:13 with lines ls 9 title "(b + B)/(T/2 + t_d)"
} }
unset multiplot

set output results."/encoder.svg"
set multiplot layout 1,2 title "Largest stiffness that comes to rest against encoder step, light hand, 1 kHz, no delay"
set xrange [0:155]
set yrange [200:20000]
set xlabel "encoder step at the tip, µm"
frictions = "0|0.02|0.05|0.15"
do for [m in "1 2"] {
    name = m eq "1" ? "spring" : "spring + FOAW16"
    set title name
    set ylabel "N/m"
    unset key
    if (m eq "1") { set key top right samplen 2 font ",9" }
    at(i) = rows("encoder", is(1, name)." && ".is(8, word_of(frictions, i)))
    plot for [i = 1:4] at(i) using 7:10 with linespoints ls i ps 0.8 title "friction ".word_of(frictions, i)." N", \
         for [i = 2:4] at(i) using 7:15 with lines ls i lw 1 dt 2 title (i == 2 ? "2 f_c/Δ of each" : ""), \
         at(1) using 7:13 with lines ls 9 title "(b + B)/(T/2 + t_d)"
}
unset multiplot

set output results."/hands.svg"
set xtics rotate by -18 font ",9"
set multiplot layout 2,1 title "Largest stiffness that comes to rest by hand, 1 kHz"
set xrange [-0.6:10.6]
set yrange [30:40000]
unset xlabel
delays = "0|0.5|1|2"
do for [m in "1 2"] {
    name = m eq "1" ? "spring" : "spring + FOAW16"
    set title name.(m eq "1" ? "" : ", B = 2 N s/m")
    set ylabel "N/m"
    unset key
    if (m eq "1") { set key bottom right samplen 2 font ",9" maxrows 3 }
    at(i) = rows("hands", is(1, name)." && ".is(5, word_of(delays, i)))
    plot at(1) using ($0):(1e-3):xtic(2) with points pt 0 notitle, \
         for [i = 1:4] at(i) using ($0 - 0.3 + 0.15 * i):10 with points ls i ps 1.1 title "delay ".word_of(delays, i)." T", \
         for [i = 1:4] at(i) using ($0 - 0.3 + 0.15 * i):16:(0.06) with xerrorbars ls i lw 1.5 pt 0 title (i == 1 ? "– eigenvalues" : ""), \
         for [i = 1:4] at(i) using ($0 - 0.3 + 0.15 * i):13 with points ls i pt 2 ps 0.6 title (i == 1 ? "× (b + min(b skin, b hand) + B)/(T/2 + t_d)" : "")
}
unset multiplot

set output results."/knock.svg"
set xtics norotate font ",10"
set multiplot layout 1,2 title "Spring alone, device alone, 1 kHz: a knock on a pressed tip grows above the points"
set logscale x
set xtics (0.05, 0.1, 0.2, 0.4, 0.8)
set xrange [0.045:0.9]
set yrange [50:10000]
set xlabel "speed of the knock, m/s"
slow = "0.02|0.05|0.15"
do for [delay in "0 1"] {
    set title delay eq "0" ? "no delay" : "a period of delay"
    set ylabel "N/m"
    unset key
    if (delay eq "0") { set key top right samplen 2 font ",9" }
    at(i) = rows("knock", is(5, delay)." && ".is(8, word_of(slow, i)))
    plot for [i = 1:3] at(i) using 9:10 with points ls i ps 1 title "friction ".word_of(slow, i)." N", \
         for [i = 1:3] at(i) using 9:17 with lines ls i lw 1 title (i == 1 ? "v* of theory" : ""), \
         at(1) using 9:13 with lines ls 9 title "b/(T/2 + t_d)"
}
unset multiplot

# Total felt error against servo rate, with the best of all levels and its least. Set results and dat with gnuplot -e.
set terminal svg size 1200,860 font "DejaVu Sans,12" background "white"
set datafile separator ","
set encoding utf8
set grid xtics ytics lc rgb "#dddddd"
set logscale xy
set xrange [120:40000]
set xtics (125, 250, 500, "1k" 1000, "2k" 2000, "4k" 4000, "8k" 8000, "16k" 16000, "32k" 32000)
set yrange [0.5:15]
set ytics (0.5, 1, 2, 5, 10)
set xlabel "servo rate, Hz"
set ylabel "felt error at 1 N and 0.1 m/s, mm"
set output results."/felt_error.svg"
at(p, s, l) = sprintf("< awk -F, '$1 == \"%s\" && $2 == %s && $4 == \"%s\"' %s", p, s, l, dat)
colours = "#000000 #0072b2 #009e73 #8c6d00"
set multiplot layout 2,2 title "What is felt is off by indentation, level, encoder and lag; a level's line ends where a step takes 0.3 of the period"
do for [p in "2diy-gen3.1 mk2"] { do for [s in "1 100"] {
    set title p.(s eq "1" ? ", this computer" : ", a computer 100 times slower")
    unset key
    if (p eq "2diy-gen3.1" && s eq "1") { set key top right samplen 2 }
    plot for [i = 1:4] at(p, s, word("0 1 2 4", i)) using 3:5 with lines lw 1.5 lc rgb word(colours, i) title "level ".word("0 1 2 4", i), \
         at(p, s, "-1") using 3:5 with lines lw 4 lc rgb "#66d55e00" title "the best of all levels", \
         at(p, s, "best") using 3:5 with points pt 7 ps 1.6 lc rgb "#d55e00" title "within 5 % of its least"
} }
unset multiplot

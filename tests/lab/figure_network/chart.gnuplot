# Overlap with held-out figures against hours of training, and what others reach on the same photographs. results is given.
set datafile separator ','
set terminal svg size 1000,520 font 'DejaVu Sans,13' background 'white'
set style line 1 lc rgb '#0072b2' pt 7 ps 0.8
set style line 2 lc rgb '#d55e00' pt 5 ps 0.8
set style line 3 lc rgb '#009e73' lw 2
set style line 4 lc rgb '#cc79a7' lw 2 dt 2
set style line 5 lc rgb '#000000' lw 2 dt 3
set grid lc rgb '#dddddd'
set output results . '/training.svg'
set title 'what the network alone reaches while it learns, on one thread, beside other ways on the same 24 photographs'
set xlabel 'hours'
set ylabel 'mean intersection over union'
set yrange [0:1]
set key bottom right box opaque
# of(way): its mean overlap with the held-out photographs.
of(way) = real(system("awk -F, '$1 == \"held_out\" && $2 == \"" . way . "\" { print $4 }' " . results . '/measured.csv'))
plot results . '/log.csv' using 2:6 skip 1 with linespoints ls 1 title 'held-out photographs', \
     '' using 2:5 skip 1 with linespoints ls 2 title 'held-out composed pictures', \
     of('small') with lines ls 3 title 'held-out photographs: the whole way, network and colours', \
     of('768') with lines ls 4 title 'held-out photographs: restricted network', \
     of('grabcut') with lines ls 5 title 'held-out photographs: colours alone (GrabCut)'

# Overlap with held-out figures against hours of training. results is given.
set datafile separator ','
set terminal svg size 1000,520 font 'DejaVu Sans,13' background 'white'
set style line 1 lc rgb '#0072b2' pt 7 ps 0.8
set style line 2 lc rgb '#d55e00' pt 5 ps 0.8
set grid lc rgb '#dddddd'
set output results . '/training.svg'
set title 'what the network alone reaches while it learns, on one thread'
set xlabel 'hours'
set ylabel 'mean intersection over union'
set yrange [0:1]
set key top left box opaque
plot results . '/log.csv' using 2:6 skip 1 with linespoints ls 1 title 'held-out photographs', \
     '' using 2:5 skip 1 with linespoints ls 2 title 'held-out composed pictures'

# The mean of the rings on the boundary against the share of pictures that are as sure. results and sure (its table) are given.
set datafile separator ','
set terminal svg size 1000,420 font 'DejaVu Sans,13' background 'white'
set style line 1 lc rgb '#0072b2' pt 7 ps 0.8
set style line 2 lc rgb '#d55e00' pt 5 ps 0.8
set grid lc rgb '#dddddd'
set output results . '/sure.svg'
set title 'how well the ring fits, if only so many of the pictures are called sure'
set xlabel 'per cent of the pictures, the surest first'
set ylabel 'per cent of the ring on the boundary'
set xrange [0:100]
set yrange [0:100]
set key bottom left box opaque
of(name) = stringcolumn(1) eq name ? column(3) : NaN
set datafile missing 'NaN'
plot sure using 2:(of('held_out')) with linespoints ls 1 title 'held-out photographs', \
     '' using 2:(of('hard')) with linespoints ls 2 title 'hard ones'

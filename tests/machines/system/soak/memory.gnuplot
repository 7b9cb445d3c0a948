# Memory of a long run over time: kiosk, servo, all processes. gnuplot -e "samples='...'; chart='...'"
set datafile separator ','
set terminal svg size 900,480 font 'sans,14' background rgb 'white'
set output chart
set xlabel 'minutes'
set ylabel 'MB of own memory'
set yrange [0:*]
set grid
set key outside top center horizontal
plot samples using ($1/60):7 every 2 skip 1 with lines lw 1 lc rgb '#999999' title 'all processes', \
     '' using ($1/60):4 every 2 skip 1 with lines lw 2 lc rgb '#0050a0' title 'kiosk', \
     '' using ($1/60):5 every 2 skip 1 with lines lw 2 dt 2 lc rgb '#c04000' title 'servo'

# F against milliseconds of each detector and setting; Hausdorff distance against milliseconds at each working size.
# results is given.
set datafile separator ','
set terminal svg size 1000,520 font 'DejaVu Sans,13' background 'white'
set style line 1 lc rgb '#0072b2' pt 7 ps 1.1
set style line 2 lc rgb '#d55e00' pt 5 ps 1.1
set style line 3 lc rgb '#009e73' pt 9 ps 1.3
set style line 4 lc rgb '#cc79a7' pt 13 ps 1.3
set style line 5 lc rgb '#000000' pt 3 ps 1.3
set grid lc rgb '#dddddd'
set logscale x
set xlabel 'milliseconds a picture (processor time, one thread)'

detectors = results . '/detectors.csv'
of(set_, name) = (stringcolumn(1) eq set_ && stringcolumn(2) eq name) ? column(4) : NaN
has_photos = int(system("grep -c '^photos' " . detectors)) > 0

set output results . '/detectors.svg'
set multiplot layout 1, (has_photos ? 2 : 1)
set ylabel 'boundary F, automatic setting'
set key bottom right box opaque
set xrange [0.6:60]
do for [pictures in (has_photos ? 'photos pictograms' : 'pictograms')] {
    set title pictures
    plot detectors using 8:(of(pictures, 'Canny on grey')) skip 1 ls 5 title 'Canny on grey', \
         '' using 8:(of(pictures, 'Canny on Lab')) skip 1 ls 2 title 'Canny on Lab', \
         '' using 8:(of(pictures, 'EdgeDrawing')) skip 1 ls 4 title 'EdgeDrawing', \
         '' using 8:(of(pictures, 'Touchline edges')) skip 1 ls 1 title 'Touchline edges', \
         '' using 8:(of(pictures, 'Touchline lines')) skip 1 ls 3 title 'Touchline lines'
}
unset multiplot

set output results . '/sizes.svg'
set title 'letters photographed with 3 megapixels, traced at several working sizes'
set ylabel 'millimetres at the handle'
set logscale y
set xrange [*:*]
set key top right box opaque
plot results . '/sizes.csv' using 4:3 skip 1 with linespoints ls 1 title 'Hausdorff distance', \
     '' using 4:2 skip 1 with linespoints ls 2 title 'RMS', \
     '' using 4:3:(sprintf('%g MP', column(1))) skip 1 with labels offset 0,1 notitle

set output results . '/figures.svg'
set title 'main things of 22 photographs, at several sizes of the picture that the network sees'
set xlabel 'milliseconds a picture (by the clock, two processors)'
set ylabel 'overlap with people'
unset logscale y
set xrange [*:*]
set key bottom right box opaque
of_size(at) = strstrt('0123456789', substr(stringcolumn(1), 1, 1)) > 0 ? column(at) : NaN
of_way(name, at) = stringcolumn(1) eq name ? column(at) : NaN
set datafile missing 'NaN'
plot results . '/figures.csv' using (of_size(8)):(of_size(3)) skip 1 with linespoints ls 1 title 'restricted network, by size: mean', \
     '' using (of_size(8)):(of_size(4)) skip 1 with linespoints ls 2 title 'median', \
     '' using (of_size(8)):(of_size(3)):1 skip 1 with labels offset 0,1 notitle, \
     '' using (of_way('small', 8)):(of_way('small', 3)) skip 1 with points ls 3 title 'small network, ships: mean', \
     '' using (of_way('small', 8)):(of_way('small', 4)) skip 1 with points ls 3 pt 8 title 'median', \
     '' using (of_way('grabcut', 8)):(of_way('grabcut', 3)) skip 1 with points ls 5 title 'colours alone (GrabCut): mean', \
     '' using (of_way('grabcut', 8)):(of_way('grabcut', 4)) skip 1 with points ls 5 pt 10 title 'median'

set output results . '/names.svg'
set title 'names of things, with all limits moved up and down together'
set xlabel 'percent of the pictures with a nameable thing that are named'
set ylabel 'wrong words in 100 pictures'
unset logscale
set xrange [*:*]
set key top left box opaque
of_looks(looks) = sprintf("< awk -F, 'NR > 1 && $2 == %d { all[$3] += $4; able[$3] += $5; wrong[$3] += $9; named[$3] += $10 } \
    END { for (h in all) print h \",\" 100 * named[h] / able[h] \",\" 100 * wrong[h] / all[h] }' %s/names.csv | sort -t, -g", looks, results)
plot of_looks(1) using 2:3 with linespoints ls 2 title 'one look', \
     of_looks(2) using 2:3 with linespoints ls 1 title 'two looks, the second in a mirror', \
     '' using (column(1) == 0 ? column(2) : NaN):3 with points pt 6 ps 2.5 lc rgb '#000000' title 'as it ships'
set logscale x

set output results . '/drawings.svg'
set title 'charts and plans, traced at several working sizes'
set xlabel 'milliseconds a picture (from the file to the map, by the clock)'
set ylabel 'percent of the line'
unset logscale y
set xrange [*:*]
set offsets 0, 0, graph 0.3, graph 0.2
set key bottom right box opaque
plot results . '/drawings_sizes.csv' using 4:(100 * column(2)) skip 1 with linespoints ls 1 title 'of what is seen, felt', \
     '' using 4:(100 * column(3)) skip 1 with linespoints ls 2 title 'of what is felt, seen', \
     '' using 4:(100 * column(2)):(sprintf('%g MP', column(1))) skip 1 with labels rotate by 60 left offset 0,0.6 notitle

#!/bin/sh
# The plots of docs/compare.md: plots.sh DAT DIR makes DIR/compare-area.png and
# DIR/compare-clock.png of what glint-compare tables has left (tables.h).
set -eu

dat=$1
dir=$2

# Error down to the left is better; those that no other beats in both are filled and joined.
plot() { # NAME TITLE AXIS COLUMN FRONT-COLUMN SORT KEY OFFSET (of every other label)
    # A column without numbers, when nothing has been measured yet, is no plot.
    awk -v at="$4" '$at != "nan" { found = 1 } END { exit !found }' "$dat" || return 0
    sort "$6" -k "$4,$4" "$dat" >"$dir/sorted.dat"
    awk -v at="$5" '$at == 1' "$dir/sorted.dat" >"$dir/front.dat"
    gnuplot >"$dir/compare-$1.png" <<END
set terminal pngcairo size 1100,700 font 'sans,14' background 'white'
set title '$2'
set xlabel 'largest difference from cosⁿ, n = 1…1000, in 1/255'
set ylabel '$3'
set logscale x
set xrange [0.1:300]
set yrange [0:*]
set offsets graph 0, graph 0, graph 0.08, graph 0
set grid
set key top $7
plot '$dir/front.dat' using 1:$4 with steps lw 2 lc '#5070b0' dt 2 title 'front', \
    '$dir/sorted.dat' using 1:$4 with points pt 6 ps 1.6 lw 2 lc '#404040' notitle, \
    '$dir/front.dat' using 1:$4 with points pt 7 ps 1.6 lc '#5070b0' notitle, \
    '$dir/sorted.dat' every 2 using 1:$4:(strcol(6)) with labels \
        offset 0,1.1 font ',11' notitle, \
    '$dir/sorted.dat' every 2::1 using 1:$4:(strcol(6)) with labels \
        offset 0,$8 font ',11' notitle
END
    rm "$dir/sorted.dat" "$dir/front.dat"
}

plot area 'Area against error, one lane, standard cells of 0.18 µm' \
    'gates (NAND2)' 2 4 -gr right 1.1
plot clock 'Clock rate against error, one lane, ECP5, median of three seeds' \
    'MHz' 3 5 -g left -1.1

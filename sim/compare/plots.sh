#!/bin/sh
# The plots of docs/compare.md: plots.sh DAT DIR makes DIR/compare-area.png and
# DIR/compare-clock.png of what glint-compare tables has left (tables.h).
set -eu

dat=$1
dir=$2

# Error down to the left is better; those that no other beats in both are filled and joined. What
# has its W rounded is a square without a name, near the unit's own; a unit for one n has one name.
# Names stand to the right, lower where they would meet, of accurate units above the front's line.
plot() { # NAME TITLE AXIS COLUMN FRONT-COLUMN SORT KEY
    # A column without numbers, when nothing has been measured yet, is no plot.
    awk -v at="$4" '$at != "nan" { found = 1 } END { exit !found }' "$dat" || return 0
    sort "$6" -k "$4,$4" "$dat" >"$dir/sorted.dat"
    awk -v at="$5" '$at == 1' "$dir/sorted.dat" >"$dir/front.dat"
    grep ', W U1' "$dir/sorted.dat" >"$dir/rounded.dat" || echo 'nan nan nan' >"$dir/rounded.dat"
    grep -v ', W U1' "$dir/sorted.dat" >"$dir/own.dat"
    sort -gr -k "$4,$4" "$dir/own.dat" | awk -v at="$4" '
        $at == "nan" { next }
        !most { most = $at }
        {
            name = $0
            sub(/^[^"]*"/, "", name)
            sub(/"$/, "", name)
            if (sub(/^bipartite.*/, "bipartite, one n", name) && seen++)
                next
            side = $1 < 5 ? -1 : int(log($1) / log(2.5))
            y = $at + ($1 < 5 ? most / 40 : 0)
            if (side in last && y > last[side] - most / 26)
                y = last[side] - most / 26
            last[side] = y
            printf "%g %g \"%s\"\n", 1.12 * $1, y, name
        }' >"$dir/names.dat"
    gnuplot >"$dir/compare-$1.png" <<END
set terminal pngcairo size 1100,700 font 'sans,14' background 'white'
set title '$2'
set xlabel 'largest difference from cosⁿ, n = 1…1000, in 1/255'
set ylabel '$3'
set logscale x
set xrange [0.1:500]
set yrange [0:*]
set offsets graph 0, graph 0, graph 0.08, graph 0
set grid
set key $7
plot '$dir/front.dat' using 1:$4 with steps lw 2 lc '#5070b0' dt 2 title 'front', \
    '$dir/rounded.dat' using 1:$4 with points pt 4 ps 1.2 lw 2 lc '#a0a0a0' title 'W rounded', \
    '$dir/own.dat' using 1:$4 with points pt 6 ps 1.6 lw 2 lc '#404040' notitle, \
    '$dir/front.dat' using 1:$4 with points pt 7 ps 1.6 lc '#5070b0' notitle, \
    '$dir/names.dat' using 1:2:3 with labels left font ',11' notitle
END
    for made in sorted front rounded own names; do
        rm "$dir/$made.dat"
    done
}

plot area 'Area against error, one lane, standard cells of 0.18 µm' \
    'gates (NAND2)' 2 4 -gr 'bottom right'
plot clock 'Clock rate against error, one lane, ECP5, median of three seeds' \
    'MHz' 3 5 -g 'bottom right'

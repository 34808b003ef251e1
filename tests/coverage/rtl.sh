#!/bin/sh
# Coverage of the Verilog: drives the counting circuits and prints the table with what is not
# covered and why.
#
#   tests/coverage/rtl.sh PROGRAM DIR
#
# PROGRAM  tests/coverage/drive.c with the circuits. DIR/counts gets what they count, DIR/rtl.txt
#          the
# table, DIR/annotated the sources with the count of each line in front.
set -eu

program=$1 dir=$2
begin=$(date +%s)
rm -rf "$dir/counts" "$dir/annotated"
mkdir -p "$dir/counts"
"$program" "$dir/counts"
status=0
awk -f tests/coverage/report.awk tests/coverage/impossible.txt \
    "$dir"/counts/*.dat >"$dir/rtl.txt" ||
    status=$?
cat "$dir/rtl.txt"
# The sources lay where they were built: named as those of rtl/, without the probe.
separator=$(printf '\001') equals=$(printf '\002')
mkdir -p "$dir/counts/named"
for counts in "$dir"/counts/*.dat; do
    sed "/${separator}f${equals}glint_probe\.v/d; s:${separator}f${equals}:&rtl/:" "$counts" \
        >"$dir/counts/named/${counts##*/}"
done
verilator_coverage --annotate "$dir/annotated" --annotate-all \
    "$dir"/counts/named/*.dat >"$dir/annotate.log"
echo "line by line: $dir/annotated"
seconds=$(($(date +%s) - begin))

note() { # lines or toggles
    counts=$(sed -n "s/^$1: \([0-9]*\) items, \([0-9]*\) failed\$/\1 \2/p" "$dir/rtl.txt")
    tests/verification/record.sh "coverage-$1" "every $2 of rtl/ is covered, or explained" \
        "Verilator's counters, with reasons" "${counts% *}" "$1" "${counts#* }" "$seconds" \
        'make coverage'
}
note lines line
note toggles toggle
exit "$status"

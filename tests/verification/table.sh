#!/bin/sh
# Writes the table of what was verified into a document, between the lines
#     <!-- verification table: begin -->  and  <!-- verification table: end -->
# from the notes that tests/verification/record.sh left.
#
#   tests/verification/table.sh RECORDS DOCUMENT
#
# Exit status 2, and the document as it was, when there are no notes or the two lines are not there
# once each.
set -eu

fail() {
    echo "tests/verification/table.sh: $*" >&2
    exit 2
}

[ $# -eq 2 ] || fail "usage: tests/verification/table.sh RECORDS DOCUMENT"
records=$1
document=$2
[ -f "$document" ] || fail "no file $document"
for mark in begin end; do
    [ "$(grep -c "^<!-- verification table: $mark -->\$" "$document")" = 1 ] ||
        fail "$document has not one line <!-- verification table: $mark -->"
done
set --
for kind in rtl model formal mutation netlist coverage fuzz abuse; do
    for note in "$records/$kind"-*.tsv; do
        [ ! -f "$note" ] || set -- "$@" "$note"
    done
done
[ $# -gt 0 ] || fail "no notes in $records; make verification makes them"

# The first line of what a tool says of its version.
version() {
    "$@" 2>/dev/null | head -n 1
}

# 268436480 is read more easily as 268 436 480.
table() {
    echo "<!-- verification table: begin -->"
    echo "From the last run of each check; written on $(date -u +%Y-%m-%d), on $(nproc) cores, with"
    echo "$(version verilator --version); $(version yosys -V | sed 's/ (.*//');" \
        "$(version iverilog -V | sed 's/ (.*//')."
    echo
    echo "| what | by | cases | failed | time | again |"
    echo "|---|---|--:|--:|--:|---|"
    cat "$@" | awk -F '\t' '
        function grouped(digits,    text) {
            while (length(digits) > 3) {
                text = " " substr(digits, length(digits) - 2) text
                digits = substr(digits, 1, length(digits) - 3)
            }
            return digits text
        }
        NF != 7 { bad = 1 }
        {
            gsub(/[|]/, "\\\\|") # in a row it would end the cell
            time = $6 < 100 ? sprintf("%.1f s", $6) : sprintf("%d min %02d s", $6 / 60, $6 % 60)
            printf "| %s | %s | %s %s | %s | %s | `%s` |\n",
                $1, $2, grouped($3), $4, grouped($5), time, $7
        }
        END { exit bad }' || fail "a note in $records has not seven fields"
    echo "<!-- verification table: end -->"
}

new=$document.new
trap 'rm -f "$new" "$new.table"' EXIT
table "$@" >"$new.table"
awk -v table="$new.table" '
    /^<!-- verification table: begin -->$/ {
        while ((getline line < table) > 0) print line
        inside = 1
    }
    !inside { print }
    /^<!-- verification table: end -->$/ { inside = 0 }' "$document" >"$new"
mv "$new" "$document"

#!/bin/sh
# Puts the tables, numbers and plots that make compare has left in DIR into docs/: page.sh DIR.
# The page's own words stay; what is between its marks is new.
set -eu

awk -v tables="$1/compare.md" '
    /^<!-- end -->/ { inside = 0 }
    !inside
    /^<!-- tables -->/ { inside = 1; print ""; while ((getline line <tables) > 0) print line }
' docs/compare.md >"$1/page"
cat "$1/page" >docs/compare.md
rm "$1/page"
cp "$1"/compare-*.png docs/images/
cp "$1/compare.csv" docs/compare.csv

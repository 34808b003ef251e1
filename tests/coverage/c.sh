#!/bin/sh
# Coverage of the C after the tests of a build that counts for gcov: prints a line a folder.
#
#   tests/coverage/c.sh DIR
#
# DIR/c is the build. DIR/html gets each source, line by line; DIR/c.csv a row a file.
set -eu

fail() {
    echo "tests/coverage/c.sh: $*" >&2
    exit 1
}

dir=$1
rm -rf "$dir/html"
mkdir -p "$dir/html"
gcovr --root . --object-directory "$dir/c" --filter 'cmodel/' --filter 'sim/' \
    --html-details "$dir/html/index.html" --csv "$dir/c.csv" "$dir/c" >"$dir/gcovr.log" 2>&1 || {
    cat "$dir/gcovr.log"
    fail "gcovr failed"
}

awk -F, '
NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
{
    folder = $at["filename"]
    sub(/\/[^\/]*$/, "", folder)
    for (name in at)
        sum[folder, name] += $at[name]
    folders[folder] = 1
    lines += $at["line_total"]; covered += $at["line_covered"]
    functions += $at["function_total"]; entered += $at["function_covered"]
}
END {
    printf "%-16s %16s %16s\n", "", "lines", "branches"
    order = "sort"
    fflush()
    for (folder in folders)
        printf "%-16s %6d of %6d %6d of %6d\n", folder, sum[folder, "line_covered"],
               sum[folder, "line_total"], sum[folder, "branch_covered"],
               sum[folder, "branch_total"] | order
    close(order)
    printf "C: %d of %d lines, %d of %d functions\n", covered, lines, entered, functions
    exit lines == 0
}' "$dir/c.csv" | tee "$dir/c.txt"
echo "line by line: $dir/html/index.html"

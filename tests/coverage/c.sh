#!/bin/sh
# Coverage of the C after the tests of a build that counts for gcov: prints a line a folder.
#
#   tests/coverage/c.sh DIR SECONDS
#
# DIR/c is the build, SECONDS what the tests took. DIR/html gets each source, line by line;
# DIR/c.csv a row a file. Then the functions that no test enters: exit status 1 when one of them has
# no reason in tests/coverage/unentered.txt.
set -eu

fail() {
    echo "tests/coverage/c.sh: $*" >&2
    exit 2
}

dir=$1 seconds=$2
rm -rf "$dir/html"
mkdir -p "$dir/html"
gcovr --root . --object-directory "$dir/c" --filter 'cmodel/' --filter 'sim/' \
    --html-details "$dir/html/index.html" --csv "$dir/c.csv" --json "$dir/c.json" \
    "$dir/c" >"$dir/gcovr.log" 2>&1 || {
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
}' "$dir/c.csv" >"$dir/c.txt" || fail "no line was counted"
cat "$dir/c.txt"
echo "line by line: $dir/html/index.html"

status=0
awk -f tests/coverage/functions.awk tests/coverage/unentered.txt "$dir/c.json" \
    >"$dir/functions.txt" || status=$?
cat "$dir/functions.txt"
counts=$(sed -n 's/^functions: \([0-9]*\) items, \([0-9]*\) failed$/\1 \2/p' "$dir/functions.txt")
tests/verification/record.sh coverage-c \
    'every function of cmodel/ and sim/ is entered by a test or has a stated reason' gcov \
    "${counts% *}" functions "${counts#* }" "$seconds" 'make coverage'
exit "$status"

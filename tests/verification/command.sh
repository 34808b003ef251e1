#!/bin/sh
# Runs `GLINT ARGUMENT... --json` and notes its "mismatches", "comparisons" and "seconds".
#
#   tests/verification/command.sh NAME WHAT METHOD GLINT ARGUMENT...
#
# The exit status is the command's; with GLINT_RECORDS unset it runs all the same.
set -eu

[ $# -ge 5 ] || {
    echo "usage: tests/verification/command.sh NAME WHAT METHOD GLINT ARGUMENT..." >&2
    exit 2
}
name=$1
what=$2
method=$3
shift 3

json=$(mktemp)
trap 'rm -f "$json"' EXIT
status=0
"$@" --json >"$json" || status=$?

# A number of the outermost object: those are indented by one tab.
field() {
    sed -n "s/^	\"$1\":	\([0-9.]*\).*/\1/p" "$json"
}
mismatches=$(field mismatches)
echo "$what: $mismatches mismatches of $(field comparisons), $(field seconds) s"
"$(dirname "$0")"/record.sh "$name" "$what" "$method" "$(field comparisons)" comparisons \
    "$mismatches" \
    "$(field seconds)" "$*" || status=1
exit "$status"

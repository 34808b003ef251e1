#!/bin/sh
# Notes one result for the table in docs/verified.md. `make verification` collects them.
#
#   tests/verification/record.sh NAME WHAT METHOD CASES UNIT FAILED SECONDS COMMAND
#
# NAME     lower-case name, the same for each run of the same check: a later run replaces it; begins
#          with rtl- model- formal- mutation- netlist- coverage- fuzz- or abuse-, the order of the
#          table
# WHAT     what is shown, a short phrase; METHOD by what (lockstep, exhaustion, SAT, …)
# CASES    how many, a whole number above 0, of UNIT (points, mutants, …); FAILED of them
# SECONDS  elapsed; COMMAND what repeats it
#
# Written to the directory GLINT_RECORDS; without it nothing is noted. Exit status 2 when a field is
# not as said here: a check over zero cases proves nothing.
set -eu

fail() {
    echo "tests/verification/record.sh: $*" >&2
    exit 2
}

[ $# -eq 8 ] || fail "eight fields, not $#: NAME WHAT METHOD CASES UNIT FAILED SECONDS COMMAND"
case $1 in
'' | *[!a-z0-9_-]*) fail "NAME \"$1\" is not of a-z 0-9 _ -" ;;
rtl-* | model-* | formal-* | mutation-* | netlist-* | coverage-* | fuzz-* | abuse-*) ;;
*) fail "NAME \"$1\" begins with no kind of check" ;;
esac
case $4 in
'' | 0* | *[!0-9]*) fail "$1: CASES \"$4\" is no whole number above 0" ;;
esac
case $6 in
'' | *[!0-9]*) fail "$1: FAILED \"$6\" is no whole number" ;;
esac
case $7 in
'' | *[!0-9.]*) fail "$1: SECONDS \"$7\" is not a number" ;;
esac

[ -n "${GLINT_RECORDS:-}" ] || exit 0
mkdir -p "$GLINT_RECORDS"
name=$1
shift
printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$@" >"$GLINT_RECORDS/$name.new"
mv "$GLINT_RECORDS/$name.new" "$GLINT_RECORDS/$name.tsv"

#!/bin/sh
# The style that a tool can see, over every file that git knows: style.sh
#
# C and C++ as .clang-format has them; an include guard is the file's path; a .c file opens with
# what it is for; no line of C, Verilog, make or shell that someone wrote is longer than 100
# columns. Exit status 0: all of it, 1: a line for each place that is not so.
set -u
found=$(mktemp) || exit 2
trap 'rm -f "$found"' EXIT

# The licence to write as they like: files made by a program, and examples of what a user writes.
generated='^tests/reflectance/reference\.h$'
users='^(docs/examples|tests/circuit/own)/'

# shellcheck disable=SC2046 # none of these names has a blank
clang-format --dry-run -Werror $(git ls-files '*.c' '*.h' '*.cpp' | grep -vE "$generated") 2>>"$found"

for header in $(git ls-files '*.h' | grep -vE "$generated|$users"); do
    name=$(basename "$header")
    guard=GLINT_$(printf %s "$(dirname "$header")/${name#glint_}" | tr -c 'A-Za-z0-9' _ | tr a-z A-Z)
    grep -q "^#ifndef $guard\$" "$header" && grep -q "^#define $guard\$" "$header" ||
        echo "$header: its include guard is not $guard" >>"$found"
done

for file in $(git ls-files '*.c' '*.cpp'); do
    case $(head -c 2 "$file") in
    '/*' | //) ;;
    *) echo "$file:1: does not open with a comment on what it is for" >>"$found" ;;
    esac
done

git ls-files '*.c' '*.h' '*.cpp' '*.v' '*.vh' '*.sh' '*.mk' Makefile | grep -vE "$generated" |
    LC_ALL=C.UTF-8 xargs awk 'length($0) > 100 { print FILENAME ":" FNR ": " length($0) " columns" }' >>"$found"

cat "$found"
[ ! -s "$found" ]

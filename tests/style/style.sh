#!/bin/sh
# The style that a tool can check, in every file that git tracks: style.sh
#
#   - C and C++ are formatted as .clang-format says
#   - an include guard is the file's path
#   - a C or C++ file opens with a comment on what it is for
#   - no line of C, Verilog, make or shell has more than 100 columns, unless it is a single word
#
# Run it from the top of the tree. Exit status 0: no fault found; 1: a line for each fault;
# 2: git or clang-format does not work.
set -u

fail() {
    echo "style.sh: $*" >&2
    exit 2
}

found=$(mktemp) || fail "cannot make a temporary file"
trap 'rm -f "$found"' EXIT

generated='^tests/reflectance/reference\.h$'
examples='^(docs/examples|tests/circuit/own)/' # what a user writes: no guard of ours

tracked() { # PATTERN...
    git ls-files "$@" | grep -vE "$generated"
}

git rev-parse 2>/dev/null || fail "not in a git work tree"
clang-format --version >/dev/null || fail "no clang-format: sim/deps.sh lint installs it"
tracked '*.c' '*.h' '*.cpp' | xargs clang-format --dry-run -Werror 2>>"$found"

for header in $(tracked '*.h' | grep -vE "$examples"); do
    name=$(basename "$header")
    path=$(dirname "$header")/${name#glint_}
    guard=GLINT_$(printf %s "${path#./}" | tr -c 'A-Za-z0-9' _ | tr a-z A-Z)
    grep -q "^#ifndef $guard\$" "$header" && grep -q "^#define $guard\$" "$header" ||
        echo "$header: its include guard is not $guard" >>"$found"
done

for file in $(tracked '*.c' '*.cpp'); do
    case $(head -c 2 "$file") in
    '/*' | //) ;;
    *) echo "$file:1: does not open with a comment on what it is for" >>"$found" ;;
    esac
done

# By characters, not bytes: awk and length differ on that, grep with this locale does not.
tracked '*.c' '*.h' '*.cpp' '*.v' '*.vh' '*.sh' '*.mk' Makefile |
    LC_ALL=C.UTF-8 xargs grep -nE '^.{101,}$' /dev/null |
    grep -vE '^[^:]*:[0-9]+:[[:space:]]*[^[:space:]]*( \\)?$' |
    sed -E 's/^([^:]*:[0-9]+):.*/\1: more than 100 columns/' >>"$found"

cat "$found"
[ ! -s "$found" ]

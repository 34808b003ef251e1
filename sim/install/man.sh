#!/bin/sh
# Writes the manual pages of the command and of its subcommands, made of what their --help says.
#
#   sim/install/man.sh GLINT VERSION DOCUMENTATION DIRECTORY
#
# DOCUMENTATION: where the pages say docs/ is, or a placeholder for it. Exit status 0, or 2 with one
# line of trouble.
set -eu

glint=$1
version=$2
documentation=$3
directory=$4

fail() {
    echo "sim/install/man.sh: $*" >&2
    exit 2
}

command -v help2man >/dev/null 2>&1 || fail "no help2man; sim/deps.sh install installs it"
mkdir -p "$directory"
work=$(mktemp -d) || fail "cannot make a temporary directory"
trap 'rm -rf "$work"' EXIT
mkdir "$work/made"

# "name  what it does" of each subcommand.
subcommands() {
    "$glint" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\)  *\(.*\)/\1 \2/p'
}

see_also() {
    printf '[SEE ALSO]\n'
    for page in "$@"; do printf '.BR %s (1),\n' "$page"; done
    printf 'the documentation in \\fI%s\\fP, which names like docs/waveforms.md are below\n' \
        "$documentation"
}

# page NAME WHAT-IT-DOES COMMAND-LINE
page() {
    help2man --no-info --version-string="glint $version" --name="$2" --include="$work/also" \
        --output="$work/page" "$3" || fail "help2man cannot make the page $1"
    # Its name, which help2man takes from the program's; examples line by line.
    sed -e "1,/^\.TH /s/^\.TH GLINT /.TH $(echo "$1" | tr a-z A-Z) /" \
        -e "s/^glint \\\\- /$1 \\\\- /" \
        -e 's/^\.SS "Exit status:"/.SH "EXIT STATUS"/' \
        -e '/^\.SH EXAMPLES/,/^\.SH "SEE/{s/^\.SH EXAMPLES/&\n.nf/;s/^\.SH "SEE/.fi\n&/;/^\.IP/d}' \
        "$work/page" >"$work/made/$1.1"
}

names=$(subcommands | cut -d ' ' -f 1)
[ -n "$names" ] || fail "$glint --help lists no subcommands"
# shellcheck disable=SC2046,SC2086  # lists of words
see_also $(for name in $names; do echo "glint-$name"; done) >"$work/also"
page glint "a specular-colour device and a divider, in C and in Verilog" "$glint"
see_also glint >"$work/also"
subcommands >"$work/list"
while read -r name what; do
    page "glint-$name" "$what" "$glint $name"
done <"$work/list"
rm -f "$directory"/*.1
mv "$work"/made/*.1 "$directory/"

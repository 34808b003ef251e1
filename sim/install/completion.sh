#!/bin/sh
# Writes the completions of the command for bash, zsh and fish, made of what its --help says.
#
#   sim/install/completion.sh GLINT DIRECTORY
#
# Exit status 0, or 2 with one line of trouble.
set -eu

glint=$1
directory=$2
here=$(dirname "$0")

fail() {
    echo "sim/install/completion.sh: $*" >&2
    exit 2
}

work=$(mktemp -d) || fail "cannot make a temporary directory"
trap 'rm -rf "$work"' EXIT

"$glint" --help |
    sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\)  *\(.*\)/\1\t\2/p' >"$work/subcommands"
[ -s "$work/subcommands" ] || fail "$glint --help lists no subcommands"

# A line for each option of each subcommand, as options.awk has it, behind the subcommand's name;
# those of verify --exhaustive are verify's too.
cut -f 1 "$work/subcommands" | while read -r name; do
    {
        "$glint" "$name" --help
        [ "$name" != verify ] || "$glint" verify --exhaustive --help
    } | awk -f "$here/options.awk" |
        awk -F '\t' -v name="$name" '!seen[$1]++ { print name "\t" $0 }'
done >"$work/options"

mkdir -p "$directory"
for shell in bash zsh fish; do
    awk -v shell="$shell" -f "$here/completion.awk" "$work/subcommands" "$work/options" \
        >"$work/$shell" || fail "cannot make the completion for $shell"
done
mv "$work/bash" "$directory/glint.bash"
mv "$work/zsh" "$directory/_glint"
mv "$work/fish" "$directory/glint.fish"

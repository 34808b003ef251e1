#!/bin/sh
# Draws the committed drawings anew: docs/images/NAME.svg and NAME.png, for each line "NAME OPTIONS"
# of docs/images/drawings.txt. What stays the same is not touched.
#
#   sim/draw/drawings.sh GLINT     from the root of the tree
set -eu

glint=$1
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT

while read -r name options; do
    # shellcheck disable=SC2086  # a list of words
    "$glint" draw $options --out "$fresh/$name.svg" >"$fresh/said" </dev/null
    committed=docs/images/$name
    cmp -s "$fresh/$name.svg" "$committed.svg" && [ -e "$committed.png" ] && continue
    rsvg-convert --zoom 1.5 "$fresh/$name.svg" -o "$fresh/$name.png"
    cp "$fresh/$name.svg" "$fresh/$name.png" docs/images/
    echo "$committed.svg and $committed.png are new"
done <docs/images/drawings.txt

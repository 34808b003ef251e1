#!/bin/sh
# Puts the command, the library and what belongs to them below a prefix, or takes them away again.
#
#   PREFIX=DIR [DESTDIR=DIR] sim/install/install.sh check
#   PREFIX=DIR [DESTDIR=DIR] sim/install/install.sh install|uninstall BUILD VERSION
#
# check: only whether the two can be used. DESTDIR is where a package is put together: it comes
# before every path, but what is installed does not know of it. Exit status 0, or 2 with one line of
# trouble.
set -eu

fail() {
    echo "make install: $*" >&2
    exit 2
}

check() {
    case $PREFIX$DESTDIR in
    *'
'*) fail "a line break in PREFIX or DESTDIR" ;;
    esac
    case $DESTDIR in
    '~'*) fail "DESTDIR=$DESTDIR: the shell has left the ~ as it is: write \$HOME" ;;
    esac
    case $PREFIX in
    '~'*) fail "PREFIX=$PREFIX: the shell has left the ~ as it is: write \$HOME" ;;
    *[!A-Za-z0-9/._+@%,=~-]*) 
        fail "PREFIX=$PREFIX: pkg-config cannot handle these characters" ;;
    /*/../* | /../* | */..) fail "PREFIX=$PREFIX: without .., please" ;;
    /*) ;;
    *) fail "PREFIX=$PREFIX is no absolute path: for here, PREFIX=\"\$PWD/$PREFIX\"" ;;
    esac
}

# What is installed, a line each: mode, file, place below the prefix. A link's file is what it
# names; pc, man and example are written, not copied. No name here has a blank.
list() {
    soname=libglint.so.${version%%.*}
    echo "755 $build/glint bin/glint"
    echo "644 $build/libglint.a lib/libglint.a"
    echo "755 $build/libglint.so.$version lib/libglint.so.$version"
    echo "link libglint.so.$version lib/$soname"
    echo "link $soname lib/libglint.so"
    echo "pc - lib/pkgconfig/libglint.pc"
    below 644 include/glint cmodel/glint*.h
    below 644 share/glint/rtl rtl/*.v rtl/*.vh
    below 644 share/glint/sim sim/rtl/shim.cpp sim/rtl/shim.h \
        sim/rtl/specular_batch.cpp sim/rtl/points.h sim/rtl/bits.h
    below 644 share/doc/glint README.md LICENSE
    below 644 share/doc/glint/docs docs/*.md
    below 644 share/doc/glint/docs/images docs/images/*.png docs/images/*.svg
    below 644 share/doc/glint/docs/examples/saturating_mac docs/examples/saturating_mac/*
    echo "example docs/library.md share/doc/glint/examples/example.c"
    below man share/man/man1 "$build"/install/man/*.1
    echo "644 $build/install/completion/glint.bash share/bash-completion/completions/glint"
    echo "644 $build/install/completion/_glint share/zsh/site-functions/_glint"
    echo "644 $build/install/completion/glint.fish share/fish/vendor_completions.d/glint.fish"
}

# below MODE DIRECTORY FILE...
below() {
    mode=$1
    place=$2
    shift 2
    for file in "$@"; do echo "$mode $file $place/${file##*/}"; done
}

pkg_config_file() {
    cat <<END
prefix=$PREFIX
includedir=\${prefix}/include/glint
libdir=\${prefix}/lib
rtldir=\${prefix}/share/glint/rtl
docdir=\${prefix}/share/doc/glint

Name: glint
Description: bit-exact models of a specular-colour device and a shift-accumulate divider
Version: $version
Cflags: -I\${includedir}
Libs: -L\${libdir} -lglint
Libs.private: -lm
END
}

put() {
    target=$root/$3
    mkdir -p "${target%/*}"
    case $1 in
    link) ln -sf "$2" "$target" ;;
    pc) pkg_config_file >"$target" ;;
    man) sed "s|@docdir@|$PREFIX/share/doc/glint|" "$2" >"$target" ;;
    example) sed -n '/^```c$/,/^```$/{/^```/d;p}' "$2" >"$target" ;; # that page has the one copy
    *) install -m "$1" "$2" "$target" ;;
    esac
}

# take_away PLACE: with the directories above it where nothing else is in them; the system's stay.
take_away() {
    rm -f "$root/$1"
    directory=${1%/*}
    while :; do
        case $PREFIX/$directory in
        /usr/*/glint | /usr/*/glint/*) ;;
        /usr/*) break ;;
        esac
        rmdir "$root/$directory" 2>/dev/null || break
        case $directory in
        */*) directory=${directory%/*} ;;
        ?*) directory= ;;
        *) break ;;
        esac
    done
}

# What an install has put there is noted there, so that another version can take it away.
install_all() {
    work=$(mktemp -d) || fail "cannot make a temporary directory"
    trap 'rm -rf "$work"' EXIT
    list >"$work/list"
    { cut -d ' ' -f 3 "$work/list" && echo "$note"; } >"$work/files"
    while read -r mode file place; do
        put "$mode" "$file" "$place"
    done <"$work/list"
    if [ -f "$root/$note" ]; then
        grep -vxF -f "$work/files" "$root/$note" | while read -r place; do take_away "$place"; done
    fi
    install -m 644 "$work/files" "$root/$note"
}

uninstall_all() {
    [ -f "$root/$note" ] || fail "nothing to take away: there is no $root/$note"
    files=$(cat "$root/$note")
    for place in $files; do take_away "$place"; done
}

PREFIX=${PREFIX:-}
DESTDIR=${DESTDIR:-}
check
[ "${1:-}" != check ] || exit 0
[ $# -eq 3 ] || fail "usage: sim/install/install.sh check|install|uninstall BUILD VERSION"
build=$2
version=$3
while [ "${PREFIX%/}" != "$PREFIX" ]; do PREFIX=${PREFIX%/}; done
root=$DESTDIR$PREFIX

note=share/glint/files

case $1 in
install) install_all ;;
uninstall) uninstall_all ;;
*) fail "$1: neither install nor uninstall" ;;
esac

# So that programs find the shared library in a directory of the system's.
if [ "$1" = install ] && [ -z "$DESTDIR" ] && [ "$(id -u)" -eq 0 ] &&
    command -v ldconfig >/dev/null 2>&1; then
    ldconfig
fi

#!/bin/sh
# Tests style.sh on a small tree: it must pass a clean one and notice a planted fault of each kind:
# notices.sh
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"
git init -q

begin() {
    mkdir -p sim/a
    cp "$here/../../.clang-format" .
    printf '/* What it is for. */\nint a(void)\n{\n    return 0;\n}\n' >sim/a/a.c
    printf '#ifndef GLINT_SIM_A_A_H\n#define GLINT_SIM_A_A_H\nint a(void);\n#endif\n' \
        >sim/a/glint_a.h
    printf '# %098d\n' 0 >rules.mk
    printf '// %s\n' "$(printf '%097d' 0 | sed 's/0/é/g')" >a.v # 100 characters, 197 bytes
    git add -A
}

fault() { # WHAT FILE LINE-OF-OUTPUT: after the file was spoilt
    if "$here/style.sh" >said 2>&1; then
        echo "notices.sh: style.sh does not notice $1" >&2
        exit 1
    fi
    grep -q "$3" said || {
        echo "notices.sh: style.sh does not say of $1 \"$3\" but:" >&2
        cat said >&2
        exit 1
    }
    begin
}

begin
"$here/style.sh" || {
    echo "notices.sh: style.sh finds fault with a tree that has none" >&2
    exit 1
}
printf '/* For. */\nint a(void)\n{\n  return 0;\n}\n' >sim/a/a.c
fault 'two columns of indentation' sim/a/a.c 'a.c:.*clang-format'
printf '/* For. */\nint a(int b)\n{\n    if (b) {\n        b = 1;\n    }\n    return b;\n}\n' \
    >sim/a/a.c
fault 'braces around a body of one line' sim/a/a.c 'a.c:.*clang-format'
sed -i 's/SIM_A_A_H/A_H/' sim/a/glint_a.h
fault 'a guard that is not the path' sim/a/glint_a.h \
    'glint_a.h: its include guard is not GLINT_SIM_A_A_H'
sed -i 1d sim/a/a.c
fault 'a file without its purpose' sim/a/a.c 'a.c:1: does not open'
printf '// a %098d\n' 0 >a.v
fault 'a line of Verilog of 103 columns' a.v 'a.v:1: more than 100 columns'
printf '# a %097d\n' 0 >rules.mk
fault 'a line of make of 101 columns' rules.mk 'rules.mk:1: more than 100 columns'

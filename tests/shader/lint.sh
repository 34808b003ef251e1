#!/bin/sh
# Validates the programs of sim/shader with glslang, each put together as sim/gl/program.c does:
#
#   lint.sh DIR     the programs are written below DIR
#
# Every model with every stage that lights by it, linked with the other stages of its program. Exit
# status 0: all are valid; 1: what glslang says of one that is not; 2: trouble.
set -u

out=$1
shaders=sim/shader

fail() {
    echo "lint.sh: $*" >&2
    exit 2
}

command -v glslangValidator >/dev/null || fail "no glslangValidator: sim/deps.sh lint installs it"
mkdir -p "$out" || exit 2

# stage FILE.EXTENSION INTERPOLATION FILE...
stage() {
    target=$out/$1
    {
        echo '#version 330 core'
        [ -z "$2" ] || echo "#define INTERPOLATION $2"
        shift 2
        for file in "$@"; do cat "$shaders/$file" || exit 2; done
    } >"$target" || fail "cannot write $target"
}

# valid FILE...: one program
valid() {
    glslangValidator -l "$@" >"$out/log" 2>&1 || {
        cat "$out/log"
        exit 1
    }
}

count=0
for model in "$shaders"/*.glsl; do
    model=${model##*/}
    case $model in surface.glsl | light.glsl | camera.glsl | frame.glsl) continue ;; esac
    light="surface.glsl $model light.glsl"
    # shellcheck disable=SC2086  # a list of files
    {
        stage phong.vert '' camera.glsl phong.vert
        stage phong.frag '' $light frame.glsl phong.frag
        valid "$out/phong.vert" "$out/phong.frag"
        for interpolation in noperspective smooth; do
            stage gouraud.vert $interpolation $light camera.glsl gouraud.vert
            stage gouraud.frag $interpolation frame.glsl gouraud.frag
            valid "$out/gouraud.vert" "$out/gouraud.frag"
        done
        stage flat.vert '' camera.glsl flat.vert
        stage flat.geom '' $light flat.geom
        stage flat.frag '' frame.glsl flat.frag
        valid "$out/flat.vert" "$out/flat.geom" "$out/flat.frag"
    }
    count=$((count + 1))
done
stage gold.vert '' camera.glsl gold.vert
stage gold.frag '' frame.glsl gold.frag
valid "$out/gold.vert" "$out/gold.frag"
[ "$count" -gt 0 ] || fail "no model in $shaders"

#!/bin/sh
# Sees that the Debian packages a goal needs are there, and installs the missing ones.
#
#   sim/deps.sh GOAL...     goals: the names in the table below
#   NO_INSTALL=1 sim/deps.sh GOAL...     only says what to install
#
# Exit status 0: all is there; 1: something is missing (NO_INSTALL=1); 2: trouble, such as a package
# that cannot be installed. Silent when nothing is missing. Installs with apt-get, through sudo when
# not root.
set -u

build='gcc g++ make pkg-config verilator zlib1g-dev libpng-dev libfreetype-dev'
build="$build fonts-dejavu-core libassimp-dev libjansson-dev libcmark-gfm-dev"
build="$build libcmark-gfm-extensions-dev nettle-dev libegl-dev libgl-dev libembree-dev"
checks="$build libcmocka-dev libgmp-dev bc musl-tools help2man iverilog yosys clang valgrind"
view='gtkwave xvfb xauth imagemagick'
meshes='assimp-testmodels glmark2-data lib3ds-dev'
plots='gnuplot-nox'
opengl='libegl1 libgl1-mesa-dri'
solver='z3'
drawing='graphviz librsvg2-bin fonts-dejavu-core'
foreign='gcc-s390x-linux-gnu libc6-dev-s390x-cross qemu-user-static'

# The one table: what each goal needs.
packages_of() {
    case $1 in
    build | demo | bench | wave) echo "$build" ;;
    check) echo "$build libcmocka-dev" ;;
    install) echo "$build help2man" ;;
    lint) echo "$checks clang-format clang-tidy glslang-tools" ;;
    mutation | netlist | formats) echo "$checks" ;;
    formal) echo "yosys $solver make" ;;
    coverage) echo "$checks gcovr $view $meshes $plots $drawing $opengl" ;;
    fuzz) echo "$checks" ;;
    draw) echo "$drawing" ;;
    report) echo "$build $plots" ;;
    test) echo "$checks $view $meshes $plots $solver $drawing $opengl" ;;
    portability) echo "$checks $foreign" ;;
    newest) echo "$build libcmocka-dev python3-venv python3-pip liblz4-dev" ;;
    compare) echo "$build yosys opensta qflow-tech-osu018 python3-venv python3-pip $plots" ;;
    gtkwave) echo "$view" ;;
    *) return 1 ;;
    esac
}

fail() {
    echo "sim/deps.sh: $*" >&2
    exit 2
}

# Prints the packages of the list that are not installed. dpkg-query fails for names it has never
# heard of, so what counts is what it lists as installed.
missing_of() {
    # shellcheck disable=SC2086  # a list of words
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $1 2>/dev/null)
    for package in $1; do
        case "
$installed
" in
        *"
installed $package
"*) ;;
        *) echo "$package" ;;
        esac
    done
}

[ $# -gt 0 ] || fail "usage: sim/deps.sh GOAL... (build check demo bench wave draw report install \
lint test gtkwave mutation netlist formal coverage fuzz portability formats newest compare)"

needed=
for goal in "$@"; do
    packages=$(packages_of "$goal") || fail "unknown goal \"$goal\""
    needed="$needed $packages"
done

command -v dpkg-query >/dev/null 2>&1 ||
    fail "this is no Debian system (no dpkg-query); install the equivalents of:$needed"

missing=$(missing_of "$needed" | sort -u | tr '\n' ' ')
missing=${missing% }
[ -n "$missing" ] || exit 0

as_root=
ask='missing packages; run'
if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null 2>&1; then
        as_root='sudo '
    else
        ask='missing packages and no sudo; as root run'
    fi
fi
ask="$ask: ${as_root}apt-get update && ${as_root}apt-get install --no-install-recommends $missing"
if [ "${NO_INSTALL:-}" = 1 ]; then
    echo "sim/deps.sh: $ask" >&2
    exit 1
fi
[ "$(id -u)" -eq 0 ] || [ -n "$as_root" ] || fail "$ask"

echo "sim/deps.sh: installing $missing" >&2
log=$(mktemp) || fail "cannot make a temporary file"
trap 'rm -f "$log"' EXIT

# apt-get's many lines are shown only when it fails.
apt() {
    # shellcheck disable=SC2086  # sudo or nothing
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q "$@" >>"$log" 2>&1 </dev/null
}

apt update # where one of several sources does not answer, the packages may still be there
# shellcheck disable=SC2086  # a list of words
if ! apt install -y --no-install-recommends $missing; then
    cat "$log" >&2
    fail "apt-get could not install: $missing (its output is above)"
fi

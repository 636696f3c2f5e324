#!/usr/bin/env bash
# setup-packages.sh run|test|long: installs the Debian packages that building (testing, fuzzing) needs and that are missing.
# Says nothing when none is missing. Exit 2 when packages are missing and cannot be installed from here.
set -euo pipefail
export LC_ALL=C

build_packages=(
    g++ cmake ninja-build pkg-config ccache git
    libimgui-dev libstb-dev libglfw3-dev libglm-dev libtbb-dev libhwy-dev
    libegl-dev libegl1 libegl-mesa0 libgl-dev libgl1-mesa-dri
    libtinygltf-dev nlohmann-json3-dev libcli11-dev libfmt-dev libpng-dev libtinyexr-dev
    fonts-inter fonts-dejavu-core gnuplot-nox
    libosmesa6-dev libosmesa6)
test_packages=(
    libgtest-dev librapidcheck-dev libembree-dev assimp-testmodels
    xvfb xauth xdotool imagemagick python3 clang-format-14)
fuzz_packages=(clang libclang-rt-14-dev)
# Not every distribution has these; the program and its tests do without.
optional=" libosmesa6-dev libosmesa6 libembree-dev assimp-testmodels fonts-inter fonts-dejavu-core gnuplot-nox ccache"
optional+=" clang libclang-rt-14-dev clang-format-14 "

case "${1:-run}" in
    run) wanted=("${build_packages[@]}") ;;
    test) wanted=("${build_packages[@]}" "${test_packages[@]}") ;;
    long) wanted=("${build_packages[@]}" "${test_packages[@]}" "${fuzz_packages[@]}") ;;
    *) echo "usage: setup-packages.sh run|test|long" >&2; exit 2 ;;
esac

say() { echo "setup: $*" >&2; }

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    if ! command -v cmake >/dev/null || ! command -v ninja >/dev/null; then
        say "not a Debian system; install the equivalents of: ${wanted[*]}"
        exit 2
    fi
    exit 0 # CMake names what it cannot find
fi

# missing NAMES...: those that are not installed
missing() {
    local installed name
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
    for name in "$@"; do
        grep -qxF "installed $name" <<<"$installed" || echo "$name"
    done
}

mapfile -t packages < <(missing "${wanted[@]}")
[[ ${#packages[@]} -gt 0 ]] || exit 0

essential=()
for name in "${packages[@]}"; do
    [[ $optional == *" $name "* ]] || essential+=("$name")
done
# Optional packages that could not be had are not asked for again.
stamp=$(dirname -- "$0")/../build/.packages-left-out
if [[ ${#essential[@]} -eq 0 && -f $stamp ]] && [[ $(<"$stamp") == "${packages[*]}" ]]; then
    exit 0
fi
leave_out() {
    mkdir -p "$(dirname -- "$stamp")"
    missing "${wanted[@]}" | paste -sd ' ' >"$stamp"
}

as_root=()
if [[ $(id -u) -ne 0 ]]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
        as_root=(sudo -n)
    elif command -v sudo >/dev/null && [[ -t 0 && ${#essential[@]} -gt 0 ]] && sudo -p 'setup: password of %p, to install packages: ' true; then
        as_root=(sudo -n) # it remembers the password for some minutes
    elif [[ ${#essential[@]} -eq 0 ]]; then
        say "going on without: ${packages[*]}"
        leave_out
        exit 0
    else
        say "missing packages; as root: apt-get install --no-install-recommends ${packages[*]}"
        exit 2
    fi
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
    ${as_root[@]+"${as_root[@]}"} env DEBIAN_FRONTEND=noninteractive \
        apt-get -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3 "$@" >"$log" 2>&1 </dev/null
}

say "installing ${#packages[@]} packages: ${packages[*]}"
# A failed update is not final: the lists at hand may do.
apt update || say "apt-get update failed: $(grep -m1 '^[EW]:' "$log" || echo 'no message')"

known=()
for name in "${packages[@]}"; do
    policy=$(apt-cache policy "$name" 2>/dev/null || true)
    if [[ $policy == *"Candidate: "* && $policy != *"Candidate: (none)"* ]]; then
        known+=("$name")
    elif [[ $optional == *" $name "* ]]; then
        say "$name is not available here; going on without it"
    else
        say "apt knows no package $name, which is needed"
        exit 2
    fi
done

if [[ ${#known[@]} -gt 0 ]] && ! apt install -y --no-install-recommends "${known[@]}"; then
    tail -n 20 "$log" >&2
    say "apt-get install failed for: ${known[*]}"
    [[ ${#essential[@]} -eq 0 ]] || exit 2
fi
leave_out

# Sourced by `run` and `test` from the repository root: configure and build, quietly when there is little to do.
# shellcheck shell=bash
set -o pipefail

# locked COMMAND...: one configure or build at a time in this checkout
locked() {
    mkdir -p build
    if command -v flock >/dev/null; then
        (
            if ! flock --nonblock 9; then
                echo "waiting for another build in this folder" >&2
                flock 9
            fi
            "$@" 9>&-
        ) 9>build/.lock
    else
        "$@"
    fi
}

# quietly LOG COMMAND...: output into LOG, shown only when the command fails
quietly() {
    local log=$1
    shift
    if ! "$@" >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        return 1
    fi
}

# configure_preset PRESET
configure_preset() {
    local dir=build/$1 fresh=()
    mkdir -p "$dir"
    # A checkout that moved, or a folder that another generator used, starts afresh.
    if [[ -f $dir/CMakeCache.txt ]] &&
        ! { grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$dir/CMakeCache.txt" &&
            grep -qx 'CMAKE_GENERATOR:INTERNAL=Ninja' "$dir/CMakeCache.txt"; }; then
        fresh=(--fresh)
    fi
    quietly "$dir/configure.log" cmake --preset "$1" ${fresh[@]+"${fresh[@]}"} && touch "$dir/.configured"
}

# progress PRESET: reads Ninja's output; of a long build it reports every tenth part
progress() {
    local line next=0 percent
    while IFS= read -r line; do
        if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] && ((BASH_REMATCH[2] > 8)); then
            percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
            if ((percent >= next)); then
                echo "building kdscope ($1): ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}" >&2
                next=$((percent + 10))
            fi
        fi
    done
}

# build_preset PRESET [TARGET]: shows what the compiler said only when the build fails
build_preset() {
    local log=build/$1/build.log
    if ! cmake --build --preset "$1" ${2:+--target "$2"} 2>&1 </dev/null | tee "$log" | progress "$1"; then
        if grep -q '^FAILED' "$log"; then
            sed -n '/^FAILED/,$p' "$log" >&2
        else
            cat "$log" >&2
        fi
        return 1
    fi
}

# Benchmarks as tests. Sourced.

# bench NAME ARGUMENTS...: runs one, which judges itself by its exit code. Without Embree 3 those with a rival are not built.
bench() {
    local program
    program=$(dirname -- "$KDSCOPE")/tests/$1
    [[ -x $program ]] || { echo "$1 is not built: it needs Embree 3" && exit 77; }
    "$program" "${@:2}" || { echo "FAIL: $1 ended with $?" && exit 1; }
}

# Times of an instrumented build are those of the sanitizer.
skip_where_instrumented() {
    [[ -z ${KD_PATIENCE:-} ]] || { echo "times are not measured under sanitizers" && exit 77; }
}

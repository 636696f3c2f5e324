#!/usr/bin/env bash
# run.sh [SECONDS]: builds the fuzzing programs (preset `fuzz`: clang, libFuzzer, AddressSanitizer, UBSan) and runs each for
# so many seconds, 600 unless given. Findings are written to build/fuzz/findings; how to go on from there: CONTRIBUTING.md.
# Exit code 0 where nothing was found, 1 where something was. As a test it runs with ./test --long only.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
cd "$root"
seconds=${1:-600}
if [[ ! $seconds =~ ^[1-9][0-9]*$ ]]; then
    echo "usage: tests/fuzz/run.sh [SECONDS]" >&2
    exit 2
fi
if [[ -n ${KD_AS_TEST:-} && -z ${KD_TEST_LONG:-} ]]; then
    echo "runs with ./test --long"
    exit 77
fi
if ! command -v clang++ >/dev/null; then
    echo "fuzzing needs clang with libFuzzer: packages clang and libclang-rt-14-dev" >&2
    exit 77
fi

# shellcheck source=cmake/build.sh
source cmake/build.sh
locked configure_preset fuzz
locked build_preset fuzz

export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=0
export UBSAN_OPTIONS=print_stacktrace=1
export LSAN_OPTIONS=suppressions=$root/tests/lsan.supp:print_suppressions=0
status=0
for target in gltf rays_csv session; do
    grown=build/fuzz/corpus/$target   # kept from run to run
    found=build/fuzz/findings/$target
    log=build/fuzz/$target.log
    mkdir -p "$grown" "$found"
    code=0
    "build/fuzz/fuzz_$target" -max_total_time="$seconds" -max_len=16384 -timeout=10 -rss_limit_mb=2048 \
        -dict="tests/fuzz/$target.dict" -artifact_prefix="$found/" -print_final_stats=1 -verbosity=1 \
        "$grown" "tests/fuzz/corpus/$target" "tests/fuzz/regressions/$target" >"$log" 2>&1 </dev/null || code=$?
    executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    if [[ $code -ne 0 ]]; then
        status=1
        tail -n 40 "$log"
        echo "fuzz_$target: FOUND something (exit code $code); the input lies in $found, the whole log in $log"
    else
        echo "fuzz_$target: ${executions:-?} executions in $seconds s, nothing found"
    fi
done
exit "$status"

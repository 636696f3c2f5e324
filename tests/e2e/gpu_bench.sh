#!/usr/bin/env bash
# The archive of tools/gpu-bench runs in an empty folder and environment, and its report is JSON that holds every part.
set -euo pipefail

fail() { echo "FAIL: $*" && exit 1; }

libraries=$(PATH=$PATH:/usr/sbin:/sbin ldconfig -p)
[[ $libraries == *libOSMesa.so.8* ]] || { echo "no OSMesa here" && exit 77; }
command -v python3 >/dev/null || { echo "no python3 here to read the report with" && exit 77; }
rm -rf elsewhere bench.tar.xz
export XZ_OPT=-0 # the archive is tried, not kept
"$KD_SOURCE_DIR/tools/gpu-bench" pack bench.tar.xz "$KDSCOPE"
[[ ! -e bench.tar.xz.part ]] || fail "half an archive is left"
mkdir elsewhere && cd elsewhere
tar xf ../bench.tar.xz
clean() { env -i PATH=/usr/bin:/bin ASAN_OPTIONS="${ASAN_OPTIONS:-}" "$@"; }
tiny=(--context osmesa --scenes ball:100,cornell --checked ball:100 --size 24x16 --rounds 2 --quick)
clean gpu-bench/gpu-bench out "${tiny[@]}" >said.txt || fail "$(cat said.txt; tail -n3 out/logs/*)"
python3 - out <<'PY' || exit 1
import json, os, sys
out = sys.argv[1]
report = json.load(open(os.path.join(out, "report.json")))
assert report["passed"] is True
assert [run["name"] for run in report["verify"]] == ["ball:100"]
assert [run["name"] for run in report["bench"]] == ["ball:100", "cornell"]
for part in ("machine", "verify", "stability", "bench"):
    for run in report[part]:
        assert run["exit_code"] == 0 and run["seconds"] > 0 and run["report"], (part, run["name"])
assert report["machine"][0]["report"]["contexts"]
for context in report["machine"][0]["report"]["contexts"]:
    assert "unavailable" in context or "multiprocessors" in context, context
# Tracers that the suite leaves out have a run each.
assert [run["name"] for run in report["stability"]] == ["suite", "suite-gl-compute", "suite-gl-wavefront"]
for run, tracer in zip(report["stability"][1:], ("gl-compute", "gl-wavefront")):
    assert {row["tracer"] for row in run["report"]["cases"]} - {"-"} == {tracer}, run["report"]["cases"]
for run in report["stability"]:
    assert run["report"]["cases_run"] == 1
tracers = {"cpu", "cpu-wide", "cpu-packet", "gl-fragment", "gl-compute", "gl-wavefront"}
for run in report["bench"]:
    assert {row["tracer"] for row in run["report"]} == tracers, run["report"]
    assert {row["traversal"] for row in run["report"]} == {"stack"}
assert len(report["pictures"]) == 6, report["pictures"]
for picture in report["pictures"]:
    with open(os.path.join(out, picture), "rb") as file:
        assert file.read(4) == b"\x89PNG", picture
PY
# What follows -- goes to every bench, and to nothing else.
clean gpu-bench/gpu-bench chosen "${tiny[@]}" -- --traversal stack --nodes 8 --builder exact >said.txt || fail "$(cat said.txt)"
python3 - <<'PY' || exit 1
import json
report = json.load(open("chosen/report.json"))
rows = [row for run in report["bench"] for row in run["report"]]
assert rows and all(row["nodes"] == 8 and row["builder"] == "exact" for row in rows), rows
assert report["stability"][0]["report"]["measured_on"]["settings"]["builder"] == "paper"
PY
# A GPU whose place software OpenGL took has not been measured.
mkdir -p ../with_gpu
printf '#!/bin/sh\necho "A GPU, 1.0"\n' >../with_gpu/nvidia-smi
chmod +x ../with_gpu/nvidia-smi
clean PATH="$PWD/../with_gpu:/usr/bin:/bin" gpu-bench/gpu-bench stood_in "${tiny[@]:2}" >said.txt || true
python3 - "$(cat said.txt)" <<'PY' || exit 1
import json, sys
report = json.load(open("stood_in/report.json"))
assert report["gpu"] == "A GPU, 1.0"
renderers = {row["renderer"] for run in report["bench"] for row in run["report"] if row["tracer"].startswith("gl-")}
software = any("llvmpipe" in renderer for renderer in renderers)
assert report["passed"] is not software, renderers
assert ("A GPU, 1.0 is here, but OpenGL came from " in sys.argv[1]) is software, sys.argv[1]
PY
# A program that breaks is told, and the report is JSON all the same.
printf '#!/bin/sh\necho "driver \\"gone\\"" >&2\nexit 3\n' >gpu-bench/start
if clean gpu-bench/gpu-bench broken "${tiny[@]}" >said.txt; then fail "a broken program passes"; fi
python3 -c '
import json
report = json.load(open("broken/report.json"))
assert report["passed"] is False
assert report["bench"][0]["exit_code"] == 3 and report["bench"][0]["report"] is None
assert report["bench"][0]["said"] == "driver \"gone\"", report["bench"][0]["said"]
assert report["pictures"] == []' || fail "the report of a broken program"
status=0
clean gpu-bench/gpu-bench out --rays 5 2>/dev/null || status=$?
((status == 2)) || fail "an unknown option is exit code $status"
status=0
"$KD_SOURCE_DIR/tools/gpu-bench" pack x.tar.xz /nowhere 2>said.txt || status=$?
grep -q 'no program /nowhere' said.txt && ((status == 1)) || fail "a missing program is told"
while IFS='|' read -r words reason; do
    status=0
    # shellcheck disable=SC2086 # words
    "$KD_SOURCE_DIR/tools/gpu-bench" $words 2>said.txt || status=$?
    head -1 said.txt | grep -qF "gpu-bench: $reason" && ((status == 2)) || fail "gpu-bench $words: $status, $(cat said.txt)"
done <<'USAGE'
|say what to do
pak x.tar.xz|'pak' is unknown
pack|pack takes an archive
over rsh there out|over goes by ssh alone
over ssh there|over ssh takes a host and a folder
USAGE
# Over ssh: the same, there and back. A stand-in runs on this machine what it is asked to run on another.
mkdir -p ../stand_in
printf '#!/usr/bin/env bash\nshift\nexec bash -c "$*"\n' >../stand_in/ssh
printf '#!/usr/bin/env bash\nargs=()\nfor a; do [[ $a == -* ]] || args+=("${a#there:}"); done\nexec cp -r "${args[@]}"\n' >../stand_in/scp
chmod +x ../stand_in/ssh ../stand_in/scp
PATH=$PWD/../stand_in:$PATH "$KD_SOURCE_DIR/tools/gpu-bench" over ssh there fetched "${tiny[@]}" >said.txt || fail "over ssh: $(cat said.txt)"
python3 -c 'import json; assert json.load(open("fetched/report.json"))["passed"] is True' || fail "the report over ssh"
# Without an option none is passed on. A run that fails there leaves its exit code here, and no folder there.
printf '#!/usr/bin/env bash\nshift\necho "$*" >>words.txt\n[[ "$*" == *gpu-bench\\ out* ]] && exit 2\nexec bash -c "$*"\n' >../stand_in/ssh
status=0
PATH=$PWD/../stand_in:$PATH "$KD_SOURCE_DIR/tools/gpu-bench" over ssh there nothing >said.txt 2>&1 || status=$?
((status == 2)) || fail "a failed run over ssh is exit code $status: $(cat said.txt)"
grep -q 'gpu-bench/gpu-bench out$' words.txt || fail "words over ssh: $(cat words.txt)"
grep -q 'there has nothing to bring back' said.txt || fail "said of a run without files: $(cat said.txt)"
[[ $(tail -1 words.txt) == "rm -rf /"* && ! -e $(sed -n '$s/^rm -rf //p' words.txt) ]] || fail "left behind: $(tail -1 words.txt)"

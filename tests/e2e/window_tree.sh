#!/usr/bin/env bash
# TREE: a slider is dragged and tree, counters and picture follow; presets bring constants back; only binned has bins; a long build is cancelled.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000
nodes=$(value tree.nodes)
tests=$(value counters.primary.triangle_tests)
see_picture before.png
drag_slider "TREE/leaf size" 0.05 0.9
wait_for '^settings.build.leaf_size=(2[0-9]|3[0-2])$'
holds "$(value tree.nodes) < $nodes / 2" || fail "$(value tree.nodes) nodes with large leaves, $nodes with small ones"
holds "$(value counters.primary.triangle_tests) > 1.5 * $tests" || fail "large leaves cost no tests"
see_picture after.png
holds "$(difference before.png after.png) > 0.003" || fail "the picture did not follow: $(difference before.png after.png)"

click_on "TREE/default"
wait_for '^settings.build.leaf_size=2$'
[[ $(value tree.nodes) == "$nodes" ]] || fail "the constants of the start make another tree"
click_on "TREE/paper's"
wait_for '^settings.build.trim_leaves=false$'
wait_for '^settings.build.empty_bonus_gate=0(\.0)?$'
click_on "TREE/default"
[[ -z $(place "TREE/bins") ]] || fail "builder paper has no bins"
press b && wait_for '^settings.build.builder=paper-cycle$'
press b && wait_for '^settings.build.builder=exact$'
press b && wait_for '^settings.build.builder=binned$'
nodes=$(value tree.nodes)
drag_slider "TREE/bins" 0.1 0.02
wait_for '^settings.build.bins=4$'
holds "$(value tree.nodes) > 1.2 * $nodes" || fail "$(value tree.nodes) nodes with 4 bins, $nodes with 32"
stop_window

# A build that takes some times as long as finding its button and pressing it.
start_window scatter:1000000 --builder paper-cycle --threads 1
nodes=$(value tree.nodes)
press b
wait_for '^building=true$'
click_on "status/cancel"
wait_for '^building=false$'
[[ $(value settings.build.builder) == paper-cycle ]] || fail "the build went on: $(value settings.build.builder)"
[[ $(value tree.nodes) == "$nodes" ]] || fail "the tree before is gone"
echo "passed"

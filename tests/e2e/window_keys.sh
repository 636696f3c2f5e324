#!/usr/bin/env bash
# Keys: T switches the traversal, H the map, D to divergence, S the splits, B the builder; the counters follow.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000
[[ $(value settings.traversal) == stack ]] || fail "starts with $(value settings.traversal)"
[[ $(value counters.primary.restarts) == 0 ]] || fail "a stack restarts"
stack_tests=$(value counters.primary.triangle_tests)
see_picture heat.png

# All walks in the order of the table, from the stack's round to it; the naive one is no step of T.
all=$("$KDSCOPE" info | sed -n 's/^traversals *//p' | sed 's/,//g; s/\bnaive\b//')
read -r -a walks <<<"${all#*stack} ${all%%stack*} stack"
((${#walks[@]} > 3)) || fail "kdscope info names no traversals: ${walks[*]}"
for walk in "${walks[@]}"; do
    press t
    wait_for "^settings.traversal=$walk\$"
    case $walk in
    restart)
        wait_for '^counters.primary.restarts=[1-9]'
        [[ $(value counters.primary.triangle_tests) == "$stack_tests" ]] || fail "the leaves visited depend on the traversal"
        ;;
    backtrack) wait_for '^counters.primary.backtracks=[1-9]' ;;
    esac
done

press h
wait_for '^settings.view.map.shown=false$'
see_picture beauty.png
holds "$(difference heat.png beauty.png) > 0.02" || fail "the map did not go: $(difference heat.png beauty.png)"
press F9
wait_for '^settings.view.map.shown=true$'

press d
wait_for '^settings.view.map.name=divergence$'
press d
wait_for '^settings.view.map.name=nodes$'
press d
wait_for '^settings.view.map.name=divergence$'
press h
press h
wait_for '^settings.view.map.name=nodes$'

see_picture before.png
press s
wait_for '^settings.view.overlay.shown=true$'
see_picture splits.png
holds "$(difference before.png splits.png) > 0.005" || fail "the splits are not on the screen"
press bracketright
wait_for '^settings.view.overlay.depth=7$'

nodes=$(value tree.nodes)
press b
wait_for '^settings.build.builder=paper-cycle$'
[[ $(value tree.nodes) != "$nodes" ]] || fail "another builder, the same tree"
echo "passed"

// kd-backtrack (Foley & Sugerman, Graphics Hardware 2005): no stack; after each leaf the walk climbs parent links until a
// far child is still to be visited. Needs the box of every node. Progress is by child identity: a node is entered from
// its parent, then left through its near child, then through its far child, and never again.

KD_FN void traverse_backtrack(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    real root_begin;
    real root_end;
    int top = entry_node();
    if (!enter_at(s, top, root_begin, root_end)) return;

    real t_begin = root_begin;
    real t_end = root_end;
    int node = top;
    int budget = step_budget();

    while (true) {
        KdNode n = fetch_node(node);

        // Descend to a leaf.
        while (n.flag != KD_LEAF && !KD_OUT_OF_STEPS(budget)) {
            --budget;
            on_interior(node, false);
            bool below_first;
            real near_end;
            real far_begin;
            int visit = visit_children(s, n.flag, n.split, t_begin, t_end, below_first, near_end, far_begin);
            if (visit == KD_VISIT_BOTH) t_end = near_end;
            node = child_of(node, n, below_first != (visit == KD_VISIT_FAR));
            n = fetch_node(node);
        }

        if (!enter_leaf(node, n, budget)) return;
        KD_TEST_LEAF(s, n, hit);
        if (any_hit && hit.triangle >= 0) break;
        if (node == top) break;

        // Climb until a far child's box still meets the ray before the nearest hit.
        on_backtrack();
        bool found = false;
        while (node != top && !found && !KD_OUT_OF_STEPS(budget)) {
            --budget;
            int child = node;
            node = n.parent;
            n = fetch_node(node);
            on_interior(node, true);
            bool below_first = below_comes_first(s, n.flag, n.split);
            if (child == child_of(node, n, below_first)) {
                int far_child = child_of(node, n, !below_first);
                real3 lower;
                real3 upper;
                fetch_node_box(far_child, lower, upper);
                t_begin = root_begin;
                t_end = root_end;
                if (clip_to_box(s, lower, upper, t_begin, t_end) && !beyond_hit(hit, t_begin)) {
                    node = far_child;
                    found = true;
                }
            }
        }
        if (!found) {
            if (KD_RARE(KD_OUT_OF_STEPS(budget))) {
                on_exit(KD_EXIT_STEP_CAP);
                return;
            }
            break;
        }
    }
    finish_walk(hit);
}

// Depth-first, near child first, far children on a stack: the paper's CPURT.

/// Visits what lies below `node`, over the part of the ray inside of its cell.
KD_FN void walk_subtree(IN(RaySetup) s, int node, real t_begin, real t_end, bool any_hit, INOUT(Hit) hit)
{
    int stack_node[KD_STACK_SIZE];
    real stack_begin[KD_STACK_SIZE];
    real stack_end[KD_STACK_SIZE];
    int depth = 0;
    int budget = step_budget();

    while (true) {
        KdNode n = fetch_node(node);

        // Descend to a leaf, leaving far children on the stack.
        while (n.flag != KD_LEAF && !KD_OUT_OF_STEPS(budget)) {
            --budget;
            on_interior(node, false);
            bool below_first;
            real near_end;
            real far_begin;
            int visit = visit_children(s, n.flag, n.split, t_begin, t_end, below_first, near_end, far_begin);
            if (visit == KD_VISIT_BOTH) {
                if (depth == KD_STACK_SIZE) {
                    on_exit(KD_EXIT_STACK_OVERFLOW);
                    return;
                }
                stack_node[depth] = child_of(node, n, !below_first);
                stack_begin[depth] = far_begin;
                stack_end[depth] = t_end;
                ++depth;
                on_push(depth);
                t_end = near_end;
            }
            node = child_of(node, n, below_first != (visit == KD_VISIT_FAR));
            n = fetch_node(node);
        }

        // Test it.
        if (!enter_leaf(node, n, budget)) return;
        KD_TEST_LEAF(s, n, hit);
        if (any_hit && hit.triangle >= 0) break;

        // Take the next pending cell that can still hold a nearer hit. Pending cells are not sorted by t where a ray
        // runs inside a plane, so a far one is passed over, never a reason to stop.
        bool found = false;
        while (depth > 0 && !found) {
            --depth;
            found = !beyond_hit(hit, stack_begin[depth]);
        }
        if (!found) break;
        node = stack_node[depth];
        t_begin = stack_begin[depth];
        t_end = stack_end[depth];
    }
    finish_walk(hit);
}

KD_FN void traverse_stack(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    real t_begin;
    real t_end;
    int node = entry_node();
    if (enter_at(s, node, t_begin, t_end)) walk_subtree(s, node, t_begin, t_end, any_hit, hit);
}

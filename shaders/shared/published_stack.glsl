// The stack traversal as printed: the paper's section 2.3.2, "on the CPU, we would keep a stack of secondChild nodes".

KD_FN void published_stack(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    real3 inverse;
    real t_begin;
    real t_end;
    if (!enter_as_published(s, inverse, t_begin, t_end)) return;

    int stack_node[KD_STACK_SIZE];
    real stack_end[KD_STACK_SIZE];
    int depth = 0;
    int node = 0;
    int budget = min(step_budget(), KD_PUBLISHED_BUDGET);

    while (true) {
        KdNode n = fetch_node(node);
        while (n.flag != KD_LEAF && !KD_OUT_OF_STEPS(budget)) {
            --budget;
            on_interior(node, false);
            bool below_first;
            real t_plane;
            int visit = visit_as_published(s, inverse, n.flag, n.split, t_begin, t_end, below_first, t_plane);
            if (visit == KD_VISIT_BOTH) {
                if (depth == KD_STACK_SIZE) {
                    on_exit(KD_EXIT_STACK_OVERFLOW);
                    return;
                }
                stack_node[depth] = child_of(node, n, !below_first);
                stack_end[depth] = t_end;
                ++depth;
                on_push(depth);
                t_end = t_plane;
            }
            node = child_of(node, n, below_first != (visit == KD_VISIT_FAR));
            n = fetch_node(node);
        }

        if (!enter_leaf(node, n, budget)) return;
        if (finish_leaf_as_published(s, n, t_end, hit)) break;
        if (any_hit && hit.triangle >= 0) break;

        // The next cell begins where this one ends.
        if (depth == 0) break;
        --depth;
        node = stack_node[depth];
        t_begin = t_end;
        t_end = stack_end[depth];
    }
    finish_walk(hit);
}

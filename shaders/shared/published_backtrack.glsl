// kd-backtrack as printed (Foley & Sugerman, Graphics Hardware 2005): after each leaf, up the parent links to the first node
// whose box holds a part of the ray beyond the leaf, and down again from there.

KD_FN void published_backtrack(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    real3 inverse;
    real t_begin;
    real root_end;
    if (!enter_as_published(s, inverse, t_begin, root_end)) return;

    real t_end = root_end;
    int node = 0;
    int last_leaf = -1;
    int budget = min(step_budget(), KD_PUBLISHED_BUDGET);

    while (true) {
        KdNode n = descend_as_published(s, inverse, t_begin, t_end, last_leaf, node, budget);

        if (!enter_leaf(node, n, budget)) return;
        if (finish_leaf_as_published(s, n, t_end, hit)) break;
        if (any_hit && hit.triangle >= 0) break;
        if (is_at_most(root_end, t_end)) break;
        t_begin = t_end;
        last_leaf = node;

        // Climb to a box that the ray has not left at t_begin; it is counted when it is descended from.
        on_backtrack();
        bool found = false;
        int parent = n.parent;
        while (parent >= 0 && !found && !KD_OUT_OF_STEPS(budget)) {
            --budget;
            node = parent;
            real3 lower;
            real3 upper;
            fetch_node_box(node, lower, upper);
            real t_enter = t_begin;
            t_end = root_end;
            found = clip_as_published(s, inverse, lower, upper, t_enter, t_end) && is_less(t_begin, t_end);
            if (!found) on_interior(node, true);
            parent = fetch_node(node).parent;
        }
        if (!found) {
            if (KD_RARE(parent >= 0)) {
                on_exit(KD_EXIT_STEP_CAP); // the budget ended on the way up
                return;
            }
            break;
        }
    }
    finish_walk(hit);
}

// kd-restart as printed (Foley & Sugerman, Graphics Hardware 2005): after each leaf, back to the root with the part of the
// ray that begins where the leaf ended. Progress hangs on that t being beyond the next plane.

KD_FN void published_restart(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    real3 inverse;
    real t_begin;
    real root_end;
    if (!enter_as_published(s, inverse, t_begin, root_end)) return;

    int last_leaf = -1;
    int budget = min(step_budget(), KD_PUBLISHED_BUDGET);

    while (true) {
        real t_end = root_end;
        int node = 0;
        KdNode n = descend_as_published(s, inverse, t_begin, t_end, last_leaf, node, budget);

        if (!enter_leaf(node, n, budget)) return;
        if (finish_leaf_as_published(s, n, t_end, hit)) break;
        if (any_hit && hit.triangle >= 0) break;
        if (is_at_most(root_end, t_end)) break;
        t_begin = t_end;
        last_leaf = node;
        on_restart();
    }
    finish_walk(hit);
}

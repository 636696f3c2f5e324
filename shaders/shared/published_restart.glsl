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
        bool again = last_leaf >= 0; // nodes on the way to the last leaf have been seen
        KdNode n = fetch_node(node);
        while (n.flag != KD_LEAF && budget > 0) {
            --budget;
            on_interior(node, again);
            bool below_first;
            real t_plane;
            int visit = visit_as_published(s, inverse, n.flag, n.split, t_begin, t_end, below_first, t_plane);
            if (visit == KD_VISIT_BOTH) t_end = t_plane;
            bool below = below_first != (visit == KD_VISIT_FAR);
            again = again && on_way_to(last_leaf, n, below);
            node = child_of(node, n, below);
            n = fetch_node(node);
        }

        budget -= n.flag == KD_LEAF ? 1 + n.count : 0;
        if (KD_RARE(budget <= 0)) {
            on_exit(KD_EXIT_STEP_CAP);
            return;
        }
        on_leaf(node);
        if (finish_leaf_as_published(s, n, t_end, hit)) break;
        if (any_hit && hit.triangle >= 0) break;
        if (is_at_most(root_end, t_end)) break;
        t_begin = t_end;
        last_leaf = node;
        on_restart();
    }
    finish_walk(hit);
}

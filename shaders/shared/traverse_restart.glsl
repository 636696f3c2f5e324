// kd-restart (Foley & Sugerman, Graphics Hardware 2005): no stack; after each leaf the walk begins again at the root.
// Where to go next is kept as a restart trail (Laine, "Restart Trail for Stackless BVH Traversal", HPG 2010): one bit per
// level, set once the far child is taken. The trail only grows as a binary number, so every walk ends.

/// One bit per level of the tree: 0..63, or 0..31 where no tree is deeper.
struct Trail {
    uint low;
#if KD_LONG_TRAIL
    uint high;
#endif
};

/// Every far child is still to come.
KD_FN Trail new_trail()
{
    Trail trail;
    trail.low = 0u;
#if KD_LONG_TRAIL
    trail.high = 0u;
#endif
    return trail;
}

KD_FN bool trail_bit(IN(Trail) trail, int level)
{
#if KD_LONG_TRAIL
    if (level >= 32) return (trail.high >> uint(level - 32) & 1u) != 0u;
#endif
    return (trail.low >> uint(level) & 1u) != 0u;
}

/// Sets the bit of `level` and clears those of all deeper levels.
KD_FN Trail advance_trail(IN(Trail) trail, int level)
{
    Trail next;
#if KD_LONG_TRAIL
    if (level >= 32) {
        uint high_bit = 1u << uint(level - 32);
        next.low = trail.low;
        next.high = (trail.high & (high_bit - 1u)) | high_bit;
        return next;
    }
    next.high = 0u;
#endif
    uint bit = 1u << uint(level);
    next.low = (trail.low & (bit - 1u)) | bit;
    return next;
}

KD_FN void traverse_restart(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    real root_begin;
    real root_end;
    if (!enter_tree(s, root_begin, root_end)) return;

    Trail trail = new_trail();
    int turned_at = -1; // level of the last change of the trail; nodes down to it have been seen before
    int budget = step_budget();

    while (true) {
        real t_begin = root_begin;
        real t_end = root_end;
        real pending_begin = KD_T_LIMIT; // nearest begin over all pending far cells of this path
        int pending_level = -1;          // deepest of them
        int level = 0;
        int node = 0;
        bool dead_end = false;
        KdNode n = fetch_node(node);

        // Follow the trail, then descend near-first.
        while (n.flag != KD_LEAF && !dead_end && budget > 0) {
            --budget;
            on_interior(node, level <= turned_at);
            bool below_first;
            real near_end;
            real far_begin;
            int visit = visit_children(s, n.flag, n.split, t_begin, t_end, below_first, near_end, far_begin);
            bool take_far = visit == KD_VISIT_FAR;
            if (visit == KD_VISIT_BOTH) {
                bool pruned = beyond_hit(hit, far_begin);
                if (trail_bit(trail, level)) {
                    take_far = true;
                    dead_end = pruned;
                    t_begin = far_begin;
                } else {
                    t_end = near_end;
                    if (!pruned) {
                        pending_level = level;
                        pending_begin = min(pending_begin, far_begin);
                    }
                }
            }
            if (!dead_end) {
                node = child_of(node, n, below_first != take_far);
                n = fetch_node(node);
                ++level;
            }
        }

        if (!dead_end) {
            budget -= n.flag == KD_LEAF ? 1 + n.count : 0;
            if (KD_RARE(budget <= 0)) {
                on_exit(KD_EXIT_STEP_CAP);
                return;
            }
            on_leaf(node);
            test_leaf(s, n, hit);
            if (any_hit && hit.triangle >= 0) break;
        }
        if (pending_level < 0 || beyond_hit(hit, pending_begin)) break;
        trail = advance_trail(trail, pending_level);
        turned_at = pending_level;
        on_restart();
    }
    finish_walk(hit);
}

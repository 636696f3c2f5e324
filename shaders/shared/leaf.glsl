// Leaves, and how a walk begins.

/// Whether a walk's steps are used up. A host that defines it otherwise, as false, counts none.
#ifndef KD_OUT_OF_STEPS
#define KD_OUT_OF_STEPS(budget) ((budget) <= 0)
#endif

/// Counts a visit of the leaf that a descent has ended in. False, with the exit reason told, where the steps were used up, in
/// the leaf or on the way to it.
KD_FN bool enter_leaf(int node, IN(KdNode) leaf, INOUT(int) budget)
{
    budget -= leaf.flag == KD_LEAF ? 1 + leaf.count : 0;
    if (KD_RARE(KD_OUT_OF_STEPS(budget))) {
        on_exit(KD_EXIT_STEP_CAP);
        return false;
    }
    on_leaf(node);
    return true;
}

/// Tests every triangle of a leaf, one by one. A hit outside the leaf's cell is kept: the nearest over all leaves wins.
KD_FN void test_leaf(IN(RaySetup) s, IN(KdNode) leaf, INOUT(Hit) hit)
{
    for (int i = 0; i < leaf.count; ++i) {
        int slot = leaf.link + i;
        on_triangle(slot);
        intersect_triangle(s, slot, fetch_reference(slot), hit);
    }
}

/// Cuts the ray to a node's cell, the tree's bounds for the root. False, with the exit reason told, where the ray is invalid
/// or misses them.
KD_FN bool enter_at(IN(RaySetup) s, int node, OUT(real) t_begin, OUT(real) t_end)
{
    t_begin = s.ray.t_min;
    t_end = s.ray.t_max;
    if (!valid_ray(s.ray)) {
        on_exit(KD_EXIT_INVALID_RAY);
        return false;
    }
    real3 lower;
    real3 upper;
    if (node == 0)
        fetch_bounds(lower, upper);
    else
        fetch_node_box(node, lower, upper);
    bool empty = !(lower.x <= upper.x);
    if (empty || !clip_to_box(s, lower, upper, t_begin, t_end)) {
        on_exit(KD_EXIT_MISS);
        return false;
    }
    return true;
}

KD_FN bool enter_tree(IN(RaySetup) s, OUT(real) t_begin, OUT(real) t_end)
{
    return enter_at(s, 0, t_begin, t_end);
}

KD_FN void finish_walk(IN(Hit) hit)
{
    on_exit(hit.triangle >= 0 ? KD_EXIT_HIT : KD_EXIT_MISS);
}

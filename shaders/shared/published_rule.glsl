// Walks as they were printed, kept to be looked at: they lose rays that touch planes, and some of them never end.
// Compared to the robust rule: no slack, division by zero components, hits outside the leaf's cell are lost, and kd-restart
// and kd-backtrack go on from where t ended, not from the child that they left.

/// Steps after which an endless walk is ended and flagged; far above any walk that ends on the scenes of the paper.
KD_CONST(int) KD_PUBLISHED_BUDGET = 32768;

/// a < b and a <= b that are false where either is not a number, as in C++: GLSL may turn a comparison around.
KD_FN bool is_less(real a, real b)
{
    return !(IS_NAN(a) || IS_NAN(b)) && a < b;
}
KD_FN bool is_at_most(real a, real b)
{
    return !(IS_NAN(a) || IS_NAN(b)) && a <= b;
}

/// Which child is "first", and what part of the ray lies where: the paper's section 2.3.2 (below is first where the origin
/// is below, `<`; both bounds belong to one side), or the first edition of Physically Based Rendering, section 4.4 (`<=`;
/// both children are visited where the plane is met at a bound). Planes that the ray is parallel to are met at infinity,
/// or at NaN where the origin lies in them.
KD_FN int visit_as_published(IN(RaySetup) s, IN(real3) inverse, int axis, real split, real t_begin, real t_end,
                             OUT(bool) below_first, OUT(real) t_plane)
{
    real origin = AXIS(s.ray.origin, axis);
    PRECISE real t = (split - origin) * AXIS(inverse, axis);
    t_plane = t;
    if (KD_RULES == KD_RULES_FIRST_EDITION) {
        below_first = origin <= split;
        if (is_less(t_end, t) || is_less(t, real(0))) return KD_VISIT_NEAR;
        if (is_less(t, t_begin)) return KD_VISIT_FAR;
        return KD_VISIT_BOTH;
    }
    below_first = origin < split;
    if (is_at_most(t_end, t) || is_less(t, real(0))) return KD_VISIT_NEAR;
    if (is_at_most(t, t_begin)) return KD_VISIT_FAR;
    return KD_VISIT_BOTH;
}

/// The slab test without padding.
KD_FN bool clip_as_published(IN(RaySetup) s, IN(real3) inverse, real3 lower, real3 upper, INOUT(real) t_begin,
                             INOUT(real) t_end)
{
    for (int axis = 0; axis < 3; ++axis) {
        PRECISE real t_lower = (AXIS(lower, axis) - AXIS(s.ray.origin, axis)) * AXIS(inverse, axis);
        PRECISE real t_upper = (AXIS(upper, axis) - AXIS(s.ray.origin, axis)) * AXIS(inverse, axis);
        bool turned = is_less(t_upper, t_lower);
        real t_near = turned ? t_upper : t_lower;
        real t_far = turned ? t_lower : t_upper;
        t_begin = is_less(t_begin, t_near) ? t_near : t_begin;
        t_end = is_less(t_far, t_end) ? t_far : t_end;
        if (is_less(t_end, t_begin)) return false;
    }
    return true;
}

/// Cuts the ray to the tree's bounds. False, with the exit reason told, where the ray is invalid or misses them.
KD_FN bool enter_as_published(IN(RaySetup) s, OUT(real3) inverse, OUT(real) t_begin, OUT(real) t_end)
{
    inverse = real3(quotient(real(1), s.ray.direction.x), quotient(real(1), s.ray.direction.y), quotient(real(1), s.ray.direction.z));
    t_begin = s.ray.t_min;
    t_end = s.ray.t_max;
    if (!valid_ray(s.ray)) {
        on_exit(KD_EXIT_INVALID_RAY);
        return false;
    }
    real3 lower;
    real3 upper;
    fetch_bounds(lower, upper);
    bool empty = !(lower.x <= upper.x);
    if (empty || !clip_as_published(s, inverse, lower, upper, t_begin, t_end)) {
        on_exit(KD_EXIT_MISS);
        return false;
    }
    return true;
}

/// Tests the leaf whose cell ends at `t_end`. True where the walk is over: under the paper's rule once something is hit
/// "within the active part of the ray" (its section 2.3.2), and hits beyond it are lost; under the first edition's once the
/// cells to come begin behind the nearest hit so far.
KD_FN bool finish_leaf_as_published(IN(RaySetup) s, IN(KdNode) leaf, real t_end, INOUT(Hit) hit)
{
    Hit found = hit;
    KD_TEST_LEAF(s, leaf, found);
    bool within = found.triangle >= 0 && is_at_most(found.t, t_end);
    if (KD_RULES == KD_RULES_FIRST_EDITION) {
        hit = found;
        return found.triangle >= 0 && is_less(found.t, t_end);
    }
    if (within) hit = found;
    return within;
}

/// Whether the child that is gone to holds this leaf, given that its parent `n` does.
KD_FN bool on_way_to(int leaf, IN(KdNode) n, bool below)
{
    return (leaf < n.link) == below;
}

/// Goes down from `node` to the leaf where the ray is at `t_begin`, and cuts `t_end` to the leaf's cell. Nodes on the way to
/// `last_leaf` (-1: none yet) have been seen. An interior node where the budget ran out.
KD_FN KdNode descend_as_published(IN(RaySetup) s, IN(real3) inverse, real t_begin, INOUT(real) t_end, int last_leaf,
                                  INOUT(int) node, INOUT(int) budget)
{
    bool again = last_leaf >= 0;
    KdNode n = fetch_node(node);
    while (n.flag != KD_LEAF && !KD_OUT_OF_STEPS(budget)) {
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
    return n;
}

// Which children of an interior node a ray visits, and over which part of its interval. The one rule that every
// traversal shares. It never leaves out a child that the exact ray touches, whatever the rounding.

/// Whether the child below the plane comes first along the ray: the origin's side, or, with the origin on the plane, the
/// side the ray leaves.
KD_FN bool below_comes_first(IN(RaySetup) s, int axis, real split)
{
    real origin = AXIS(s.ray.origin, axis);
    return origin < split || (origin == split && AXIS(s.ray.direction, axis) > real(0));
}

/// Near child (the one that comes first), far child or both. `near_end` and `far_begin` cut [t_begin, t_end] where both
/// are visited. Rays inside the plane visit both children over the full interval: there, t carries no order. Progress in
/// the traversals is therefore by child, never by t.
KD_FN int visit_children(IN(RaySetup) s, int axis, real split, real t_begin, real t_end,
                         OUT(bool) below_first, OUT(real) near_end, OUT(real) far_begin)
{
    real origin = AXIS(s.ray.origin, axis);
    below_first = origin < split;
    near_end = t_end;
    far_begin = t_begin;

    PRECISE real t_plane = (split - origin) * AXIS(s.inverse, axis);
    if (KD_RARE(t_plane == real(0))) {
        real direction = AXIS(s.ray.direction, axis);
        if (direction == real(0)) return origin == split ? KD_VISIT_BOTH : KD_VISIT_NEAR;
        if (origin != split) return KD_VISIT_BOTH; // the product underflowed and tells nothing
        below_first = direction > real(0);
    }
    PRECISE real t_low = t_plane * (real(1) - KD_T_PADDING);
    PRECISE real t_high = t_plane * (real(1) + KD_T_PADDING);
    if (t_plane < real(0) || t_low > t_end) return KD_VISIT_NEAR;
    if (t_high < t_begin) return KD_VISIT_FAR;
    near_end = min(t_high, t_end);
    far_begin = max(t_low, t_begin);
    return KD_VISIT_BOTH;
}

KD_FN int child_of(int node, IN(KdNode) n, bool below)
{
    return below ? node + 1 : n.link;
}

// Which children of an interior node a ray visits, and over which part of its interval. The one rule that every
// traversal shares. It never leaves out a child that the exact ray touches, whatever the rounding.

/// Near child, far child or both. The near child is the one on the origin's side; with the origin on the plane, the side
/// travelled into. `near_end` and `far_begin` cut [t_begin, t_end] where both are visited.
///
/// Rays that start on the plane or run inside it visit both children over the full interval: a product of zero distance
/// and any reciprocal carries no order. Progress in the traversals is therefore by child, never by t.
KD_FN int visit_children(RaySetup s, int axis, real split, real t_begin, real t_end,
                         OUT(bool) below_first, OUT(real) near_end, OUT(real) far_begin)
{
    real origin = s.ray.origin[axis];
    below_first = origin < split;
    near_end = t_end;
    far_begin = t_begin;

    // 0 where the direction is 0, the origin lies on the plane, or the product underflows.
    PRECISE real t_plane = (split - origin) * s.inverse[axis];
    if (KD_RARE(t_plane == real(0))) {
        if (origin == split) below_first = s.ray.direction[axis] <= real(0);
        else if (s.ray.direction[axis] == real(0)) return KD_VISIT_NEAR;
        return KD_VISIT_BOTH;
    }
    PRECISE real t_low = t_plane * (real(1) - KD_T_PADDING);
    PRECISE real t_high = t_plane * (real(1) + KD_T_PADDING);
    if (t_plane < real(0) || t_low > t_end) return KD_VISIT_NEAR;
    if (t_high < t_begin) return KD_VISIT_FAR;
    near_end = min(t_high, t_end);
    far_begin = max(t_low, t_begin);
    return KD_VISIT_BOTH;
}

KD_FN int child_of(int node, KdNode n, bool below)
{
    return below ? node + 1 : n.link;
}

// Which children of an interior node a ray visits, and over which part of its interval. The one rule that every
// traversal shares. It never leaves out a child that the ray comes within its slack of: what the triangle test may call a
// hit, the walk must reach (a ray through a vertex may exactly pass outside the cell that ends there).

/// Whether the child below the plane comes first along the ray. A ray parallel to the plane begins on its origin's side.
KD_FN bool below_comes_first(IN(RaySetup) s, int axis, real split)
{
    real inverse = AXIS(s.inverse, axis);
    return inverse == real(0) ? AXIS(s.ray.origin, axis) < split : inverse > real(0);
}

/// The child that comes first (near), the other (far), or both. `near_end` and `far_begin` cut [t_begin, t_end] where both
/// are visited. Rays inside the plane visit both children over the full interval: there, t carries no order. Progress in
/// the traversals is therefore by child, never by t.
KD_FN int visit_children(IN(RaySetup) s, int axis, real split, real t_begin, real t_end,
                         OUT(bool) below_first, OUT(real) near_end, OUT(real) far_begin)
{
    real inverse = AXIS(s.inverse, axis);
    real distance_ahead = split - AXIS(s.ray.origin, axis);
    near_end = t_end;
    far_begin = t_begin;
    if (KD_RARE(inverse == real(0))) {
        below_first = distance_ahead > real(0);
        return abs(distance_ahead) <= s.slack ? KD_VISIT_BOTH : KD_VISIT_NEAR;
    }
    below_first = inverse > real(0);
    PRECISE real t_plane = distance_ahead * inverse;
    PRECISE real t_low = t_plane - AXIS(s.t_slack, axis);
    PRECISE real t_high = t_plane + AXIS(s.t_slack, axis);
    if (t_low > t_end) return KD_VISIT_NEAR;
    if (t_high < t_begin) return KD_VISIT_FAR;
    near_end = min(t_high, t_end);
    far_begin = max(t_low, t_begin);
    return KD_VISIT_BOTH;
}

KD_FN int child_of(int node, IN(KdNode) n, bool below)
{
    return below ? node + 1 : n.link;
}

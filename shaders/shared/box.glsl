// Ray against an axis-aligned box, conservative: never misses a box that the ray comes within its slack of.

/// Cuts [t_begin, t_end] to the part inside the closed box widened by the slack; false where nothing is left.
KD_FN bool clip_to_box(IN(RaySetup) s, real3 lower, real3 upper, INOUT(real) t_begin, INOUT(real) t_end)
{
    for (int axis = 0; axis < 3; ++axis) {
        real origin = AXIS(s.ray.origin, axis);
        real inverse = AXIS(s.inverse, axis);
        if (inverse == real(0)) {
            if (origin < AXIS(lower, axis) - s.slack || origin > AXIS(upper, axis) + s.slack) return false;
        } else {
            PRECISE real t_lower = (AXIS(lower, axis) - origin) * inverse;
            PRECISE real t_upper = (AXIS(upper, axis) - origin) * inverse;
            PRECISE real t_near = min(t_lower, t_upper) - AXIS(s.t_slack, axis);
            PRECISE real t_far = max(t_lower, t_upper) + AXIS(s.t_slack, axis);
            t_begin = max(t_begin, t_near);
            t_end = min(t_end, t_far);
        }
    }
    return t_begin <= t_end;
}

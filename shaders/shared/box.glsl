// Ray against an axis-aligned box, conservative: never misses a box that the exact ray touches.

/// Cuts [t_begin, t_end] to the part inside the closed box; false where nothing is left. The interval is padded
/// outwards as in Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013; a zero component of the direction has its own branch.
KD_FN bool clip_to_box(IN(RaySetup) s, real3 lower, real3 upper, INOUT(real) t_begin, INOUT(real) t_end)
{
    for (int axis = 0; axis < 3; ++axis) {
        real origin = AXIS(s.ray.origin, axis);
        if (AXIS(s.ray.direction, axis) == real(0)) {
            if (origin < AXIS(lower, axis) || origin > AXIS(upper, axis)) return false;
        } else {
            PRECISE real t_lower = (AXIS(lower, axis) - origin) * AXIS(s.inverse, axis);
            PRECISE real t_upper = (AXIS(upper, axis) - origin) * AXIS(s.inverse, axis);
            PRECISE real t_near = min(t_lower, t_upper);
            PRECISE real t_far = max(t_lower, t_upper);
            PRECISE real near_padded = t_near - abs(t_near) * KD_T_PADDING;
            PRECISE real far_padded = t_far + abs(t_far) * KD_T_PADDING;
            t_begin = max(t_begin, near_padded);
            t_end = min(t_end, far_padded);
        }
    }
    return t_begin <= t_end;
}

// Stackless walk by ropes (Popov, Guenther, Seidel, Slusallek, Computer Graphics Forum 26(3), 2007; neighbour links:
// MacDonald & Booth 1990): every face of a leaf has a link to the smallest cell beyond it. The walk leaves each leaf through
// the face that the ray leaves by and never goes up.
//
// Published, it follows one path. A ray that passes an edge or a face of a cell closer than its slack touches cells beside
// that path, and what the triangle test may call a hit can lie in these. Such a ray is walked by kd-restart instead, with
// the hit found so far.

/// Where a walk by ropes is. `entered` is the axis of the face that the ray came through, -1 where it began inside.
struct RopeWalk {
    int node;
    real t;
    int entered;
    bool certain;
};

KD_FN real rope_margin(IN(RaySetup) s, int entered)
{
    return entered < 0 ? real(0) : AXIS(s.t_slack, entered);
}

/// On which side of a plane the walk is at its t. `certain` turns false within the slack.
KD_FN bool below_at(IN(RaySetup) s, int axis, real split, INOUT(RopeWalk) walk)
{
    real inverse = AXIS(s.inverse, axis);
    real distance_ahead = split - AXIS(s.ray.origin, axis);
    // Right behind a face, the cell that begins there.
    if (axis == walk.entered) return inverse > real(0);
    if (inverse == real(0)) {
        walk.certain = walk.certain && abs(distance_ahead) > s.slack;
        return distance_ahead > real(0);
    }
    PRECISE real t_plane = distance_ahead * inverse;
    real margin = AXIS(s.t_slack, axis) + rope_margin(s, walk.entered);
    walk.certain = walk.certain && !(abs(t_plane - walk.t) <= margin);
    return (t_plane > walk.t) == (inverse > real(0));
}

/// Moves the walk behind the face that the ray leaves the cell by, -1 where there is nothing. `certain` turns false where
/// the ray comes within its slack of any other face.
KD_FN void leave_cell(IN(RaySetup) s, real3 lower, real3 upper, INOUT(RopeWalk) walk)
{
    real3 t_near = real3(real(0), real(0), real(0));
    real3 t_far = real3(KD_T_LIMIT, KD_T_LIMIT, KD_T_LIMIT);
    int leaving = 0;
    for (int axis = 0; axis < 3; ++axis) {
        real inverse = AXIS(s.inverse, axis);
        real origin = AXIS(s.ray.origin, axis);
        if (inverse == real(0)) {
            walk.certain = walk.certain && origin > AXIS(lower, axis) + s.slack && origin < AXIS(upper, axis) - s.slack;
        } else {
            PRECISE real t_lower = (AXIS(lower, axis) - origin) * inverse;
            PRECISE real t_upper = (AXIS(upper, axis) - origin) * inverse;
            AXIS(t_near, axis) = min(t_lower, t_upper);
            AXIS(t_far, axis) = max(t_lower, t_upper);
        }
        if (AXIS(t_far, axis) < AXIS(t_far, leaving)) leaving = axis;
    }
    real t_out = AXIS(t_far, leaving);
    for (int axis = 0; axis < 3; ++axis) {
        if (AXIS(s.inverse, axis) != real(0)) {
            real slack = AXIS(s.t_slack, axis);
            bool apart = axis == walk.entered || AXIS(t_near, axis) + slack + rope_margin(s, walk.entered) < walk.t;
            apart = apart && (axis == leaving || AXIS(t_far, axis) - slack - AXIS(s.t_slack, leaving) > t_out);
            walk.certain = walk.certain && apart;
        }
    }
    if (leaving != walk.entered)
        walk.certain = walk.certain && walk.t + rope_margin(s, walk.entered) + AXIS(s.t_slack, leaving) < t_out;
    walk.node = fetch_rope(walk.node, 2 * leaving + (AXIS(s.inverse, leaving) > real(0) ? 1 : 0));
    walk.t = t_out;
    walk.entered = leaving;
}

/// Where the walk begins: in the leaf of the ray's origin where that is known, else so far behind the origin that a plane
/// it lies on, such as the wall that it starts from, is crossed like any other. False where the ray misses the tree.
KD_FN bool begin_ropes(IN(RaySetup) s, OUT(RopeWalk) walk, OUT(real) t_end)
{
    real t_begin;
    walk.node = entry_node();
    walk.entered = -1;
    walk.certain = true;
    walk.t = s.ray.t_min;
    if (!enter_tree(s, t_begin, t_end)) return false;
    if (walk.node != 0) return true;
    real3 lower;
    real3 upper;
    fetch_bounds(lower, upper);
    real begin = s.ray.t_min - real(4) * max_component(s.t_slack);
    walk.t = begin;
    real end = t_end;
    clip_to_box(s, lower, upper, walk.t, end);
    if (walk.t > begin) {
        // Outside: it enters by the face that it meets last.
        real latest = begin;
        for (int axis = 0; axis < 3; ++axis) {
            real inverse = AXIS(s.inverse, axis);
            if (inverse != real(0)) {
                real face = inverse > real(0) ? AXIS(lower, axis) : AXIS(upper, axis);
                PRECISE real t = (face - AXIS(s.ray.origin, axis)) * inverse;
                if (t > latest) {
                    latest = t;
                    walk.entered = axis;
                }
            }
        }
        walk.t = latest;
    }
    return true;
}

KD_FN void traverse_ropes(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    RopeWalk walk;
    real t_end;
    if (!begin_ropes(s, walk, t_end)) return;
    int budget = step_budget();

    bool done = false;
    while (!done) {
        KdNode n = fetch_node(walk.node);
        while (n.flag != KD_LEAF && walk.certain && !KD_OUT_OF_STEPS(budget)) {
            --budget;
            on_interior(walk.node, false);
            bool below = below_at(s, n.flag, n.split, walk);
            walk.node = child_of(walk.node, n, below);
            n = fetch_node(walk.node);
        }
        if (!walk.certain) break;
        if (!enter_leaf(walk.node, n, budget)) return;
        KD_TEST_LEAF(s, n, hit);
        done = any_hit && hit.triangle >= 0;
        if (!done) {
            real3 lower;
            real3 upper;
            fetch_node_box(walk.node, lower, upper);
            leave_cell(s, lower, upper, walk);
            PRECISE real next_begin = walk.t - AXIS(s.t_slack, walk.entered);
            done = walk.certain && (walk.node < 0 || next_begin > t_end || beyond_hit(hit, next_begin));
            if (!walk.certain) break;
        }
    }
    if (walk.certain) {
        finish_walk(hit);
        return;
    }
    on_restart();
    walk_from_top(s, any_hit, 0, false, 0, budget, hit);
}

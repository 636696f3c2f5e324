// shared/traverse_ropes.glsl, step by step, with kd-restart for the rays that ropes hand over.

#include "from_top_steps.glsl"

RopeWalk walk_ropes;
real walk_out = 0.0; // where the ray leaves the tree
bool handed_over = false;

/// Goes on from the root, with the hit and the budget that are left.
void hand_over(IN(RaySetup) s)
{
    handed_over = true;
    on_restart();
    if (enter_tree(s, walk_begin, walk_end))
        begin_from_top();
    else
        walking = false;
}

void begin_walk(IN(RaySetup) s)
{
    walking = begin_ropes(s, walk_ropes, walk_out);
    walk_budget = step_budget();
    if (!walking) return;
    go_to(walk_ropes.node);
    arrive();
}

void step_down(IN(RaySetup) s, IN(Hit) hit)
{
    if (handed_over) {
        step_down_from_top(s, hit);
        return;
    }
    --walk_budget;
    on_interior(walk_at, false);
    bool below = below_at(s, walk_node.flag, walk_node.split, walk_ropes);
    walk_ropes.node = child_of(walk_at, walk_node, below);
    if (!walk_ropes.certain) {
        hand_over(s);
        return;
    }
    go_to(walk_ropes.node);
    arrive();
}

void leave_leaf(IN(RaySetup) s, IN(Hit) hit)
{
    if (handed_over) {
        leave_leaf_from_top(hit);
        return;
    }
    real3 lower;
    real3 upper;
    fetch_node_box(walk_at, lower, upper);
    leave_cell(s, lower, upper, walk_ropes);
    if (!walk_ropes.certain) {
        hand_over(s);
        return;
    }
    PRECISE real next_begin = walk_ropes.t - AXIS(s.t_slack, walk_ropes.entered);
    if (walk_ropes.node < 0 || next_begin > walk_out || beyond_hit(hit, next_begin)) {
        complete_walk(hit);
        return;
    }
    go_to(walk_ropes.node);
    arrive();
}

// shared/traverse_backtrack.glsl, step by step. Climbing is made of interior steps too.

real walk_root_begin = 0.0;
real walk_root_end = 0.0;
bool walk_climbs = false; // the next interior step is that of the parent of walk_below
int walk_below = -1;

void begin_walk(IN(RaySetup) s)
{
    if (!enter_walk(s)) return;
    walk_root_begin = walk_begin;
    walk_root_end = walk_end;
    arrive();
}

void climb_to(int parent)
{
    walk_below = walk_at;
    walk_climbs = true;
    go_to(parent);
}

void leave_leaf(IN(RaySetup) s, IN(Hit) hit)
{
    if (walk_at == walk_first) {
        complete_walk(hit);
        return;
    }
    on_backtrack();
    climb_to(walk_node.parent);
}

void step_up(IN(RaySetup) s, IN(Hit) hit)
{
    --walk_budget;
    on_interior(walk_at, true);
    bool below_first = below_comes_first(s, walk_node.flag, walk_node.split);
    if (walk_below == child_of(walk_at, walk_node, below_first)) {
        int far_child = child_of(walk_at, walk_node, !below_first);
        real3 lower;
        real3 upper;
        fetch_node_box(far_child, lower, upper);
        walk_begin = walk_root_begin;
        walk_end = walk_root_end;
        if (clip_to_box(s, lower, upper, walk_begin, walk_end) && !beyond_hit(hit, walk_begin)) {
            walk_climbs = false;
            go_to(far_child);
            arrive();
            return;
        }
    }
    if (KD_OUT_OF_STEPS(walk_budget)) {
        end_walk(KD_EXIT_STEP_CAP);
    } else if (walk_at == walk_first) {
        complete_walk(hit);
    } else {
        climb_to(walk_node.parent);
    }
}

void step_down(IN(RaySetup) s, IN(Hit) hit)
{
    if (walk_climbs) {
        step_up(s, hit);
        return;
    }
    --walk_budget;
    on_interior(walk_at, false);
    bool below_first;
    real near_end;
    real far_begin;
    int visit =
        visit_children(s, walk_node.flag, walk_node.split, walk_begin, walk_end, below_first, near_end, far_begin);
    if (visit == KD_VISIT_BOTH) walk_end = near_end;
    go_to(child_of(walk_at, walk_node, below_first != (visit == KD_VISIT_FAR)));
    arrive();
}

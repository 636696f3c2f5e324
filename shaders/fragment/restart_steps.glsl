// shared/traverse_restart.glsl, step by step. The way back to the root is no step of its own.

Trail walk_trail;
int walk_turned_at = -1;
int walk_level = 0;
int walk_pending_level = -1;
real walk_pending_begin = KD_T_LIMIT;
real walk_root_begin = 0.0;
real walk_root_end = 0.0;

void begin_at_root()
{
    walk_begin = walk_root_begin;
    walk_end = walk_root_end;
    walk_pending_begin = KD_T_LIMIT;
    walk_pending_level = -1;
    walk_level = 0;
    go_to(0);
    arrive();
}

void begin_walk(IN(RaySetup) s)
{
    walk_trail = new_trail();
    if (!enter_walk(s)) return;
    walk_root_begin = walk_begin;
    walk_root_end = walk_end;
    begin_at_root();
}

void leave_leaf(IN(RaySetup) s, IN(Hit) hit)
{
    if (walk_pending_level < 0 || beyond_hit(hit, walk_pending_begin)) {
        complete_walk(hit);
        return;
    }
    walk_trail = advance_trail(walk_trail, walk_pending_level);
    walk_turned_at = walk_pending_level;
    on_restart();
    begin_at_root();
}

void step_down(IN(RaySetup) s, IN(Hit) hit)
{
    --walk_budget;
    on_interior(walk_at, walk_level <= walk_turned_at);
    bool below_first;
    real near_end;
    real far_begin;
    int visit =
        visit_children(s, walk_node.flag, walk_node.split, walk_begin, walk_end, below_first, near_end, far_begin);
    bool take_far = visit == KD_VISIT_FAR;
    if (visit == KD_VISIT_BOTH) {
        bool pruned = beyond_hit(hit, far_begin);
        if (trail_bit(walk_trail, walk_level)) {
            take_far = true;
            walk_begin = far_begin;
            // A dead end: what lies there begins behind the hit.
            if (pruned) {
                leave_leaf(s, hit);
                return;
            }
        } else {
            walk_end = near_end;
            if (!pruned) {
                walk_pending_level = walk_level;
                walk_pending_begin = min(walk_pending_begin, far_begin);
            }
        }
    }
    go_to(child_of(walk_at, walk_node, below_first != take_far));
    ++walk_level;
    arrive();
}

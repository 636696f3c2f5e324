// shared/walk_from_top.glsl, step by step: kd-restart, push-down and short stack, by what of it is switched on. The way back
// to the top is no step of its own.

const bool top_sinks = KD_STEPS == 3 || KD_STEPS == 4;
const int entries_kept = KD_STEPS == 4 ? KD_SHORT_STACK : 0;

int walk_top = 0;
int walk_top_level = 0;
real walk_top_begin = 0.0;
real walk_top_end = 0.0;
int walk_level = 0;
Trail walk_trail;
int walk_turned_at = -1;
Forgotten walk_forgotten;
ShortStack walk_kept;

void begin_at_top()
{
    walk_begin = walk_top_begin;
    walk_end = walk_top_end;
    walk_level = walk_top_level;
    walk_forgotten.level = -1;
    walk_forgotten.begin = KD_T_LIMIT;
    go_to(walk_top);
    arrive();
}

/// The ray is cut to the tree's bounds already.
void begin_from_top()
{
    walk_top_begin = walk_begin;
    walk_top_end = walk_end;
    walk_trail = new_trail();
    walk_kept.newest = 0;
    walk_kept.held = 0;
    begin_at_top();
}

/// Goes on at the newest of what was kept and can still hold a nearer hit; false where there is none.
bool take_kept(IN(Hit) hit)
{
    int kept = take_newest(walk_kept, entries_kept, hit);
    // No early return: where nothing is kept NVIDIA's compiler would find the index -1 behind it.
    if (kept >= 0) {
        walk_begin = walk_kept.begin[kept];
        walk_end = walk_kept.end[kept];
        walk_trail = advance_trail(walk_trail, walk_kept.level[kept]);
        walk_level = walk_kept.level[kept] + 1;
        walk_turned_at = -1;
        go_to(walk_kept.node[kept]);
    }
    return kept >= 0;
}

void leave_leaf_from_top(IN(Hit) hit)
{
    if (take_kept(hit)) {
        arrive();
        return;
    }
    if (walk_forgotten.level < 0 || beyond_hit(hit, walk_forgotten.begin)) {
        complete_walk(hit);
        return;
    }
    walk_trail = advance_trail(walk_trail, walk_forgotten.level);
    walk_turned_at = walk_forgotten.level;
    on_restart();
    begin_at_top();
}

/// Keeps or forgets a far child that is left behind.
void leave_far_child(bool below, real begin)
{
    if (entries_kept > 0)
        push_short(walk_kept, entries_kept, child_of(walk_at, walk_node, below), begin, walk_end, walk_level, walk_forgotten);
    else
        forget(walk_forgotten, walk_level, begin);
}

void step_down_from_top(IN(RaySetup) s, IN(Hit) hit)
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
                leave_leaf_from_top(hit);
                return;
            }
        } else {
            if (!pruned) leave_far_child(!below_first, far_begin);
            walk_end = near_end;
        }
    }
    go_to(child_of(walk_at, walk_node, below_first != take_far));
    ++walk_level;
    if (top_sinks && walk_forgotten.level < 0 && walk_kept.held == 0) {
        walk_top = walk_at;
        walk_top_level = walk_level;
        walk_top_begin = walk_begin;
        walk_top_end = walk_end;
    }
    arrive();
}

#if KD_STEPS != 5
void begin_walk(IN(RaySetup) s)
{
    if (!enter_walk(s)) return;
    walk_top = walk_first;
    begin_from_top();
}

void step_down(IN(RaySetup) s, IN(Hit) hit) { step_down_from_top(s, hit); }

void leave_leaf(IN(RaySetup) s, IN(Hit) hit) { leave_leaf_from_top(hit); }
#endif

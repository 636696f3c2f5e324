// The variables of steps/..., kept behind ray and hit. RayWords in renderer/gl/ray_queues.h leaves room for them.

#if KD_STEPS == 1 || KD_STEPS == 3 || KD_STEPS == 4 || KD_STEPS == 5
void keep_from_top()
{
    keep(walk_top);
    keep(walk_top_level);
    keep(walk_top_begin);
    keep(walk_top_end);
    keep(walk_level);
    keep(walk_trail.low);
#if KD_LONG_TRAIL
    keep(walk_trail.high);
#endif
    keep(walk_turned_at);
    keep(walk_forgotten.level);
    keep(walk_forgotten.begin);
    keep(walk_kept.newest);
    keep(walk_kept.held);
    for (int i = 0; i < entries_kept; ++i) {
        keep(walk_kept.node[i]);
        keep(walk_kept.begin[i]);
        keep(walk_kept.end[i]);
        keep(walk_kept.level[i]);
    }
}
#endif

void keep_steps()
{
#if KD_STEPS == 0
    keep(stack_depth);
#elif KD_STEPS == 2
    keep(walk_root_begin);
    keep(walk_root_end);
    keep(walk_climbs);
    keep(walk_below);
#elif KD_STEPS == 5
    keep(walk_ropes.node);
    keep(walk_ropes.t);
    keep(walk_ropes.entered);
    keep(walk_ropes.certain);
    keep(walk_out);
    keep(handed_over);
    keep_from_top();
#else
    keep_from_top();
#endif
}

void keep_walk(int slot, bool save)
{
    begin_state(slot, KD_WALK_WORD, save);
    keep(walk_first);
    keep(walk_at);
    keep(walk_budget);
    keep(walk_begin);
    keep(walk_end);
    keep_steps();
}

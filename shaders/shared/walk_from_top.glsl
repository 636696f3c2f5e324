// Walks that forget where they could go on, and find it again from the top: kd-restart, push-down and short stack are this
// text with parts of it switched off. The choices are constants wherever it is called.

/// The last few far children of the path, the newest on top; older ones are forgotten where there is no room.
struct ShortStack {
    int node[KD_SHORT_STACK];
    real begin[KD_SHORT_STACK];
    real end[KD_SHORT_STACK];
    int level[KD_SHORT_STACK];
    int newest; // its place
    int held;
};

/// What a path has left behind and not kept: the deepest such level, -1 for none, and the least t at which any of it begins.
struct Forgotten {
    int level;
    real begin;
};

KD_FN void forget(INOUT(Forgotten) forgotten, int level, real begin)
{
    forgotten.level = level;
    forgotten.begin = min(forgotten.begin, begin);
}

/// Keeps a far child; what has to give way is forgotten. It lies deeper than all that was forgotten before.
KD_FN void push_short(INOUT(ShortStack) stack, int entries, int node, real begin, real end, int level,
                      INOUT(Forgotten) forgotten)
{
    int place = stack.newest + 1 == entries ? 0 : stack.newest + 1;
    if (stack.held == entries)
        forget(forgotten, stack.level[place], stack.begin[place]);
    else
        ++stack.held;
    stack.node[place] = node;
    stack.begin[place] = begin;
    stack.end[place] = end;
    stack.level[place] = level;
    stack.newest = place;
    on_push(stack.held);
}

/// Takes the newest entries off until one can still hold a nearer hit; its place, -1 where none can.
KD_FN int take_newest(INOUT(ShortStack) stack, int entries, IN(Hit) hit)
{
    while (entries > 0 && stack.held > 0) {
        int place = stack.newest;
        --stack.held;
        stack.newest = place == 0 ? entries - 1 : place - 1;
        if (!beyond_hit(hit, stack.begin[place])) return place;
    }
    return -1;
}

/// `entry`: the node to begin at. `entries`: 0 to KD_SHORT_STACK far children that are kept. With `push_down` the top sinks
/// to the deepest cell outside of which nothing is left to visit. `budget`: steps.
KD_FN void walk_from_top(IN(RaySetup) s, bool any_hit, int entry, bool push_down, int entries, int budget,
                         INOUT(Hit) hit)
{
    real top_begin;
    real top_end;
    if (!enter_at(s, entry, top_begin, top_end)) return;

    int top = entry;
    int top_level = 0;
    int node = top;
    int level = top_level;
    real t_begin = top_begin;
    real t_end = top_end;
    Trail trail = new_trail();
    int turned_at = -1; // level of the last change of the trail; nodes down to it have been seen before
    Forgotten forgotten;
    forgotten.level = -1;
    forgotten.begin = KD_T_LIMIT;
    ShortStack stack;
    stack.newest = 0;
    stack.held = 0;

    while (true) {
        bool dead_end = false;
        KdNode n = fetch_node(node);

        // Follow the trail, then descend near-first.
        while (n.flag != KD_LEAF && !dead_end && !KD_OUT_OF_STEPS(budget)) {
            --budget;
            on_interior(node, level <= turned_at);
            bool below_first;
            real near_end;
            real far_begin;
            int visit = visit_children(s, n.flag, n.split, t_begin, t_end, below_first, near_end, far_begin);
            bool take_far = visit == KD_VISIT_FAR;
            if (visit == KD_VISIT_BOTH) {
                bool pruned = beyond_hit(hit, far_begin);
                if (trail_bit(trail, level)) {
                    take_far = true;
                    dead_end = pruned;
                    t_begin = far_begin;
                } else {
                    if (!pruned) {
                        if (entries > 0)
                            push_short(stack, entries, child_of(node, n, !below_first), far_begin, t_end, level, forgotten);
                        else
                            forget(forgotten, level, far_begin);
                    }
                    t_end = near_end;
                }
            }
            if (!dead_end) {
                node = child_of(node, n, below_first != take_far);
                n = fetch_node(node);
                ++level;
                if (push_down && forgotten.level < 0 && stack.held == 0) {
                    top = node;
                    top_level = level;
                    top_begin = t_begin;
                    top_end = t_end;
                }
            }
        }

        if (!dead_end) {
            if (!enter_leaf(node, n, budget)) return;
            KD_TEST_LEAF(s, n, hit);
            if (any_hit && hit.triangle >= 0) break;
        }

        int kept = take_newest(stack, entries, hit);
        if (kept >= 0) {
            node = stack.node[kept];
            t_begin = stack.begin[kept];
            t_end = stack.end[kept];
            trail = advance_trail(trail, stack.level[kept]);
            level = stack.level[kept] + 1;
            turned_at = -1;
        } else {
            // Find the deepest of what was forgotten.
            if (forgotten.level < 0 || beyond_hit(hit, forgotten.begin)) break;
            trail = advance_trail(trail, forgotten.level);
            turned_at = forgotten.level;
            on_restart();
            node = top;
            level = top_level;
            t_begin = top_begin;
            t_end = top_end;
            forgotten.level = -1;
            forgotten.begin = KD_T_LIMIT;
        }
    }
    finish_walk(hit);
}

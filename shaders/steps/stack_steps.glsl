// shared/traverse_stack.glsl, step by step. Where the entries are kept stands in front of it: steps/local_stack.glsl or another.

int stack_depth = 0;

void begin_walk(IN(RaySetup) s)
{
    if (enter_walk(s)) arrive();
}

void step_down(IN(RaySetup) s, IN(Hit) hit)
{
    --walk_budget;
    on_interior(walk_at, false);
    bool below_first;
    real near_end;
    real far_begin;
    int visit =
        visit_children(s, walk_node.flag, walk_node.split, walk_begin, walk_end, below_first, near_end, far_begin);
    if (visit == KD_VISIT_BOTH) {
        if (stack_depth == KD_STACK_SIZE) {
            end_walk(KD_EXIT_STACK_OVERFLOW);
            return;
        }
        set_entry_of_stack(stack_depth, StackEntry(child_of(walk_at, walk_node, !below_first), far_begin, walk_end));
        ++stack_depth;
        on_push(stack_depth);
        walk_end = near_end;
    }
    go_to(child_of(walk_at, walk_node, below_first != (visit == KD_VISIT_FAR)));
    arrive();
}

void leave_leaf(IN(RaySetup) s, IN(Hit) hit)
{
    bool found = false;
    StackEntry entry;
    while (stack_depth > 0 && !found) {
        --stack_depth;
        entry = entry_of_stack(stack_depth);
        found = !beyond_hit(hit, entry.begin);
    }
    if (!found) {
        complete_walk(hit);
        return;
    }
    walk_begin = entry.begin;
    walk_end = entry.end;
    go_to(entry.node);
    arrive();
}

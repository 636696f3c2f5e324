// The stack of steps/stack_steps.glsl in variables.

struct StackEntry {
    int node;
    real begin;
    real end;
};

int stack_node[KD_STACK_SIZE];
real stack_begin[KD_STACK_SIZE];
real stack_end[KD_STACK_SIZE];

StackEntry entry_of_stack(int place)
{
    return StackEntry(stack_node[place], stack_begin[place], stack_end[place]);
}

void set_entry_of_stack(int place, StackEntry entry)
{
    stack_node[place] = entry.node;
    stack_begin[place] = entry.begin;
    stack_end[place] = entry.end;
}

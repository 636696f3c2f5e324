// The stack of steps/stack_steps.glsl in the ray's state, behind all else.

struct StackEntry {
    int node;
    real begin;
    real end;
};

int stack_slot = 0;

int word_of_stack(int place)
{
    return (KD_STACK_WORD + 3 * place) * frame.wave.x + stack_slot;
}

StackEntry entry_of_stack(int place)
{
    int at = word_of_stack(place);
    return StackEntry(int(kd_state[at]), uintBitsToFloat(kd_state[at + frame.wave.x]),
                      uintBitsToFloat(kd_state[at + 2 * frame.wave.x]));
}

void set_entry_of_stack(int place, StackEntry entry)
{
    int at = word_of_stack(place);
    kd_state[at] = uint(entry.node);
    kd_state[at + frame.wave.x] = floatBitsToUint(entry.begin);
    kd_state[at + 2 * frame.wave.x] = floatBitsToUint(entry.end);
}

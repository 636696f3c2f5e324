// Every ray's state between kernels (Purcell, Buck, Mark, Hanrahan 2002): words in a storage buffer, word by word over all rays,
// so that neighbours read neighbours. A ray's number in it is its slot.

layout(std430, binding = 5) restrict buffer RayStates { uint kd_state[]; };

bool state_saving = false; // else loading
int state_word = 0;        // where the next value lies

void begin_state(int slot, int word, bool save)
{
    state_saving = save;
    state_word = word * frame.wave.x + slot;
}

void keep(inout uint x)
{
    if (state_saving)
        kd_state[state_word] = x;
    else
        x = kd_state[state_word];
    state_word += frame.wave.x;
}

void keep(inout int x)
{
    uint bits = uint(x);
    keep(bits);
    x = int(bits);
}

void keep(inout real x)
{
    uint bits = floatBitsToUint(x);
    keep(bits);
    x = uintBitsToFloat(bits);
}

void keep(inout bool x)
{
    uint bits = x ? 1u : 0u;
    keep(bits);
    x = bits != 0u;
}

void keep(inout real3 x)
{
    keep(x.x);
    keep(x.y);
    keep(x.z);
}

/// What a ray is asked for.
struct AskedRay {
    Ray ray;
    bool any_hit;
    bool begun;
    int entry; // the node that its walk begins at
};

void keep_asked(int slot, inout AskedRay asked, bool save)
{
    begin_state(slot, 0, save);
    keep(asked.ray.origin);
    keep(asked.ray.direction);
    keep(asked.ray.t_min);
    keep(asked.ray.t_max);
    keep(asked.ray.source);
    keep(asked.any_hit);
    keep(asked.entry);
    keep(asked.begun);
}

/// What has been found so far; at the end, the answer. Behind the ray.
void keep_found(int slot, inout Hit hit, inout RayCounters counted, bool save)
{
    begin_state(slot, KD_FOUND_WORD, save);
    keep(hit.triangle);
    keep(hit.t);
    keep(hit.u);
    keep(hit.v);
#if KD_COUNTERS
    keep(counted.interior_first);
    keep(counted.interior_again);
    keep(counted.leaves);
    keep(counted.triangle_tests);
    keep(counted.restarts);
    keep(counted.backtracks);
    keep(counted.stack_depth);
    keep(counted.exit_reason);
#endif
}

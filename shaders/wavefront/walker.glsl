// What the kernels that walk have in common: a ray is taken from a queue with all that is known of it, and put back.

#include "compute/tracer.glsl"
#include "ray_states.glsl"
#include "queues.glsl"
#include "steps/stepper.glsl"
#include "stored_stack.glsl"
#include "steps/steps.glsl"
#include "keep_walk.glsl"

layout(local_size_x = KD_GROUP_X, local_size_y = KD_GROUP_Y) in;

int slot = 0;
AskedRay asked;
RaySetup s;
Hit hit;

/// False where this invocation has no ray of the queue.
bool take_ray(int queue)
{
    uint place = gl_WorkGroupID.x * uint(KD_GROUP_X * KD_GROUP_Y) + gl_LocalInvocationIndex;
    if (place >= kd_counts[queue].taken) return false;
    slot = kd_queue[queue * frame.wave.x + int(place)];
    stack_slot = slot;
    keep_asked(slot, asked, false);
    s = setup_ray(asked.ray);
    if (!asked.begun) return true;
    keep_found(slot, hit, counters, false);
    keep_walk(slot, false);
    walking = true;
    walk_node = fetch_node(walk_at);
    return true;
}

/// The answer where the walk has ended; else on to the next kernel.
void put_ray(int next_queue)
{
    check_loops();
    if (!walking) {
        // As traverse() does.
        real limit = no_hit(asked.ray).t;
        hit.t = hit.triangle >= 0 ? hit.t + s.t_shift : limit;
        keep_found(slot, hit, counters, true);
        return;
    }
    keep_found(slot, hit, counters, true);
    keep_walk(slot, true);
    push_ray(next_queue, slot);
}

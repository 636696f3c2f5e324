// shared/kernel.glsl with rays that are put into a queue and answered later. The passes ask twice: first for their rays, all
// of which find nothing, and again when these have walked.

#include "shared/vector.glsl"
#include "shared/texture.glsl"
#include "shared/ray.glsl"
#include "ray_states.glsl"
#include "queues.glsl"

int next_slot = 0; // of this pixel's next ray

void traverse(IN(Ray) ray, bool any_hit, INOUT(Hit) hit)
{
    int slot = next_slot++;
#if KD_PHASE == 1
    AskedRay asked = AskedRay(ray, any_hit, false, entry_node());
    keep_asked(slot, asked, true);
    push_ray(0, slot);
#else
    RayCounters counted;
    keep_found(slot, hit, counted, false);
    counted.rays = 1u;
#if KD_COUNTERS
    add_counters(counted);
#endif
#endif
}

#include "shared/camera.glsl"
#include "shared/surface.glsl"
#include "shared/samples.glsl"
#include "shared/path.glsl"
#include "shared/lighting.glsl"
#include "shared/scatter.glsl"
#include "shared/passes.glsl"

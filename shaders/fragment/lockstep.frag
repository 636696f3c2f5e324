// Rays from a table, walked by one of two loops that count their own lanes: what a machine with such groups really does,
// to be held against what is computed (docs/divergence.md). A ray without a direction is a lane that stays idle.

#include "ballots.glsl"
// The extensions come first.
#include "tracer.glsl"
#include "hit_target.glsl"
#include "opengl/ray_io.glsl"
#include "steps/stepper.glsl"
#include "steps/local_stack.glsl"
#include "steps/steps.glsl"

layout(location = 3) out uvec4 out_ballots; // led iterations, led lanes: of each first at interior nodes, then at leaves
layout(location = 4) out uvec4 out_place;   // group (number of a pixel in it), lane, multiprocessor, lanes of a group

/// One step at a leaf: its visit, or the test of one of its triangles; then on to the next cell where that was the last.
void step_leaf(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    if (walk_left < 0) {
        on_leaf(walk_at);
        walk_slot = walk_node.link;
        walk_left = walk_node.count;
    } else {
        on_triangle(walk_slot);
        intersect_triangle(s, walk_slot, fetch_reference(walk_slot), hit);
        ++walk_slot;
        --walk_left;
    }
    if (walk_left > 0) return;
    if (any_hit && hit.triangle >= 0) {
        complete_walk(hit);
        return;
    }
    leave_leaf(s, hit);
}

void run_walk(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    while (walking) {
#if KD_IF_IF
        if (at_interior()) {
            count_lanes(0);
            step_down(s, hit);
        } else {
            count_lanes(1);
            step_leaf(s, any_hit, hit);
        }
#else
        while (at_interior()) {
            count_lanes(0);
            step_down(s, hit);
        }
        while (at_leaf()) {
            count_lanes(1);
            step_leaf(s, any_hit, hit);
        }
#endif
    }
}

void main()
{
    int2 pixel = this_pixel();
    int index = pixel.y * frame.rays.z + pixel.x;
    Hit hit = nothing_found();
    uvec2 group = uvec2(0u);
    if (!gl_HelperInvocation && index < frame.rays.y) {
        group = uvec2(of_first_lane(uint(index)), this_lane());
        Ray ray = fetch_ray(index);
        hit = no_hit(ray);
        // As traverse() does.
        RaySetup s = setup_ray(ray);
        real limit = hit.t;
        hit.t = limit - s.t_shift;
        begin_walk(s);
        run_walk(s, frame.rays.x != 0, hit);
        hit.t = hit.triangle >= 0 ? hit.t + s.t_shift : limit;
    }
    leave_hit(pixel, hit);
    out_ballots = uvec4(led_iterations[0], led_iterations[1], led_lanes[0], led_lanes[1]);
    out_place = uvec4(group, this_multiprocessor(), lane_count());
    leave_counters(pixel);
}

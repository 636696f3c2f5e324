// Traces rays from a table instead of a camera's.

#include "tracer.glsl"
#include "pixel_io.glsl"
#include "ray_io.glsl"

void main()
{
    Hit hit = nothing_found();
    int2 pixel = this_pixel();
    int index = pixel.y * frame.rays.z + pixel.x;
    // The last row may be longer than what is left.
    if (index < frame.rays.y) {
        Ray ray = fetch_ray(index);
        hit = no_hit(ray);
        traverse(ray, frame.rays.x != 0, hit);
    }
    out_hit = pack_hit(hit);
    write_counters();
}

// Traces rays from a table instead of a camera's: three texels of bits per ray.

#include "tracer.glsl"
#include "pixel_io.glsl"

layout(binding = 10) uniform usamplerBuffer kd_rays; // origin, t_min | direction, t_max | source

Ray fetch_ray(int index)
{
    uvec4 first = texelFetch(kd_rays, 3 * index);
    uvec4 second = texelFetch(kd_rays, 3 * index + 1);
    uvec4 third = texelFetch(kd_rays, 3 * index + 2);
    return Ray(uintBitsToFloat(first.xyz), uintBitsToFloat(second.xyz), uintBitsToFloat(first.w),
               uintBitsToFloat(second.w), int(third.x));
}

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

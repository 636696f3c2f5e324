// Rays from a table: three texels of bits each.

layout(binding = 10) uniform usamplerBuffer kd_rays; // origin, t_min | direction, t_max | source

Ray fetch_ray(int index)
{
    uvec4 first = texelFetch(kd_rays, 3 * index);
    uvec4 second = texelFetch(kd_rays, 3 * index + 1);
    uvec4 third = texelFetch(kd_rays, 3 * index + 2);
    return Ray(uintBitsToFloat(first.xyz), uintBitsToFloat(second.xyz), uintBitsToFloat(first.w),
               uintBitsToFloat(second.w), int(third.x));
}

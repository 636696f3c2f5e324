// The path that a pass continues or shades. The ray's origin is not kept: once its hit is known only its direction counts.

layout(binding = 10) uniform usampler2D kd_path_hit;
layout(binding = 11) uniform sampler2D kd_path_direction;
layout(binding = 12) uniform sampler2D kd_path_weight;

/// The primary ray's path, from RTPrim's hit.
Path primary_path(int2 pixel)
{
    Path path = primary_leg(frame_camera(), pixel, frame.image.xy);
    path.hit = unpack_hit(texelFetch(kd_path_hit, pixel, 0));
    return path;
}

/// A path after at least one bounce, from RTRefl or RTIndirect. Its weight is zero where that pass had nothing to trace.
Path reflected_path(int2 pixel)
{
    Path path;
    path.ray.origin = real3(0, 0, 0);
    vec4 direction = texelFetch(kd_path_direction, pixel, 0);
    path.ray.direction = direction.xyz;
    path.ray.t_min = 0.0;
    path.ray.t_max = KD_T_LIMIT;
    path.ray.source = -1;
    path.hit = unpack_hit(texelFetch(kd_path_hit, pixel, 0));
    vec4 weight = texelFetch(kd_path_weight, pixel, 0);
    path.weight = weight.xyz;
    path.pixel = pixel;
    path.leg = int(weight.w);
    path.width = direction.w;
    path.spread = path.leg == KD_LEG_INDIRECT ? 0.0 : pixel_spread(frame_camera(), frame.image.xy);
    return path;
}

/// The path that RTRefl goes on from.
Path path_before_bounce(int2 pixel)
{
#if KD_LATER_BOUNCE
    return reflected_path(pixel);
#else
    return primary_path(pixel);
#endif
}

/// True where the path has a ray worth tracing.
bool goes_on(Path path)
{
#if KD_SCATTER
    return scatters(path);
#else
    return reflection_counts(reflected_weight(path), frame.criteria.x);
#endif
}

Path go_on(Path path)
{
#if KD_SCATTER
    return trace_indirect(path);
#else
    return trace_reflection(path);
#endif
}

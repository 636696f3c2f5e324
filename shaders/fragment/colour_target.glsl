// The picture, and what a shading pass of a later bounce goes on from.

layout(location = 3) out vec4 out_colour;
#if KD_LATER_BOUNCE && KD_SHADOWS
layout(binding = 15) uniform usampler2D kd_earlier_hit;
#endif

/// The first occluder that earlier bounces have found.
Hit earlier_hit(int2 pixel)
{
#if KD_LATER_BOUNCE && KD_SHADOWS
    return unpack_hit(texelFetch(kd_earlier_hit, pixel, 0));
#else
    return nothing_found();
#endif
}

void leave_colour(int2 pixel, real3 colour)
{
    out_colour = vec4(colour, 1.0);
}

/// Blending adds it.
void add_colour(int2 pixel, real3 colour)
{
    out_colour = vec4(colour, 0.0);
}

// The picture, and what a shading pass of a later bounce goes on from: it reads and writes the same texels.

layout(rgba32f, binding = 3) restrict uniform image2D kd_colour;

/// The first occluder that earlier bounces have found.
Hit earlier_hit(int2 pixel)
{
#if KD_LATER_BOUNCE && KD_SHADOWS
    return unpack_hit(imageLoad(kd_hit, pixel));
#else
    return nothing_found();
#endif
}

void leave_colour(int2 pixel, real3 colour)
{
    KD_STORE(kd_colour, pixel, vec4(colour, 1.0));
}

void add_colour(int2 pixel, real3 colour)
{
    KD_STORE(kd_colour, pixel, imageLoad(kd_colour, pixel) + vec4(colour, 0.0));
}

// The path that a bounce leaves.

layout(rgba32f, binding = 3) restrict writeonly uniform image2D kd_direction;
layout(rgba32f, binding = 4) restrict writeonly uniform image2D kd_weight;

void leave_path(int2 pixel, Path path)
{
    leave_hit(pixel, path.hit);
    KD_STORE(kd_direction, pixel, vec4(path.ray.direction, path.width));
    KD_STORE(kd_weight, pixel, vec4(path.weight, float(path.leg)));
}

/// The weight of two bounces before stands there still.
void end_path(int2 pixel)
{
#if KD_LATER_BOUNCE
    KD_STORE(kd_weight, pixel, vec4(0.0));
#endif
}

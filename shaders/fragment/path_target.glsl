// The path that a bounce leaves.

layout(location = 3) out vec4 out_direction;
layout(location = 4) out vec4 out_weight;

/// Where leave_path() need not be called.
void end_path(int2 pixel) {}

void leave_path(int2 pixel, Path path)
{
    leave_hit(pixel, path.hit);
    out_direction = vec4(path.ray.direction, path.width);
    out_weight = vec4(path.weight, float(path.leg));
}

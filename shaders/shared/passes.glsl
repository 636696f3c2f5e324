// The paper's four passes (its section 3.2) for one pixel: RTPrim, ShadePrim, and RTRefl, ShadeRefl once per bounce.

/// A path after some bounces: the ray last traced, its hit, and how much of what it finds reaches the pixel.
struct Path {
    Ray ray;
    Hit hit;
    real3 weight;
};

/// RTPrim: trace the primary ray of a pixel.
KD_FN Path trace_primary(IN(PinholeCamera) camera, int2 pixel, int2 size)
{
    Path path;
    path.ray = camera_ray(camera, pixel, size);
    path.hit = no_hit(path.ray);
    path.weight = real3(1, 1, 1);
    traverse(path.ray, false, path.hit);
    return path;
}

/// ShadePrim and ShadeRefl: light that this path adds to the pixel; `first_blocked` as in light_surface.
KD_FN real3 shade_path(IN(Path) path, INOUT(Hit) first_blocked)
{
    if (path.hit.triangle < 0) return path.weight * scene_background();
    return path.weight * light_surface(path.ray, surface_at(path.ray, path.hit), first_blocked);
}

/// How much a mirror ray from this hit would count, zero where the surface reflects nothing or nothing was hit.
KD_FN real3 reflected_weight(IN(Path) path)
{
    if (path.hit.triangle < 0) return real3(0, 0, 0);
    return path.weight * fetch_material(fetch_material_index(path.hit.triangle)).reflectance;
}

/// The paper's second termination criterion (its section 2.2): follow a reflection only while it can still count.
KD_FN bool reflection_counts(real3 weight, real least_contribution)
{
    real largest = max_component(weight);
    return largest > real(0) && largest >= least_contribution;
}

/// The ray that the surface at a path's hit mirrors its ray into.
KD_FN Ray mirror_ray(IN(Path) path)
{
    Surface s = surface_at(path.ray, path.hit);
    real3 d = normalise3(path.ray.direction);
    real3 mirrored = add_scaled3(d, s.shading, real(-2) * dot3(d, s.shading));
    // An interpolated normal can send the ray below the surface; lift it back to the tangent plane.
    real below = dot3(mirrored, s.geometric);
    if (below < real(0)) mirrored = add_scaled3(mirrored, s.geometric, real(-1.001) * below);
    return leave_surface(s, normalise3(mirrored), KD_T_LIMIT);
}

/// RTRefl: trace the mirror ray of a path whose reflection counts.
KD_FN Path trace_reflection(IN(Path) path)
{
    Path next;
    next.ray = mirror_ray(path);
    next.hit = no_hit(next.ray);
    next.weight = reflected_weight(path);
    traverse(next.ray, false, next.hit);
    return next;
}

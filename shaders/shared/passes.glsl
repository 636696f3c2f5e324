// The passes for one pixel: the paper's four (its section 3.2), RTPrim, ShadePrim, and RTRefl, ShadeRefl once per bounce;
// and RTIndirect, ShadeIndirect where indirect light is sampled.

/// RTPrim: trace the primary ray of a pixel.
KD_FN Path trace_primary(IN(PinholeCamera) camera, int2 pixel, int2 size)
{
    Path path = primary_leg(camera, pixel, size);
    traverse(path.ray, false, path.hit);
    return path;
}

/// The shading passes: light that this path adds to the pixel; `first_blocked` as in light_surface.
KD_FN real3 shade_path(IN(Path) path, INOUT(Hit) first_blocked)
{
    if (path.hit.triangle < 0) return path.weight * scene_background();
    return path.weight * light_surface(path, surface_of(path), first_blocked);
}

/// Whether anything that the path finds can reach the pixel.
KD_FN bool path_counts(IN(Path) path)
{
    return max_component(path.weight) > real(0);
}

/// How much a reflection at this hit would count, zero where the surface reflects nothing or nothing was hit.
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

/// RTRefl before its ray is traced: the next leg of a path whose reflection counts.
KD_FN Path reflected_leg(IN(Path) path)
{
    Onward on = reflect_path(path);
    Path next = path;
    next.ray = on.ray;
    next.hit = no_hit(next.ray);
    next.weight = reflected_weight(path);
    // A share of 1 is none.
    if (on.share != real(1)) next.weight = scale3(next.weight, on.share);
    next.leg = path.leg + 1;
    next.width = width_at_hit(path);
    return next;
}

KD_FN Path trace_reflection(IN(Path) path)
{
    Path next = reflected_leg(path);
    traverse(next.ray, false, next.hit);
    return next;
}

/// Whether the surface at a primary ray's hit scatters light, its image aside.
KD_FN bool scatters(IN(Path) path)
{
    if (path.hit.triangle < 0) return false;
    return max_component(fetch_material(fetch_material_index(path.hit.triangle)).diffuse) > real(0);
}

/// RTIndirect before its ray is traced: the leg that light takes to a primary ray's hit from another surface.
KD_FN Path indirect_leg(IN(Path) path)
{
    Surface s = surface_of(path);
    Path next = path;
    next.leg = KD_LEG_INDIRECT;
    // Many such rays make up the cone that the pixel sees: each looks at what it meets as finely as there is.
    next.width = real(0);
    next.spread = real(0);
    next.ray = scattered_ray(s, path_key(next));
    next.hit = no_hit(next.ray);
    next.weight = path.weight * s.material.diffuse;
    return next;
}

KD_FN Path trace_indirect(IN(Path) path)
{
    Path next = indirect_leg(path);
    traverse(next.ray, false, next.hit);
    return next;
}

// Where a path goes on from a surface: mirrored, mirrored by facets of a rough surface, or scattered in all directions.

/// A ray that goes on, and the share that it carries of what the surface's colour lets pass.
struct Onward {
    Ray ray;
    real share;
};

/// A ray from `s` towards a direction that an interpolated normal may have sent below the surface: lifted back to the
/// tangent plane then.
KD_FN Ray leave_above(IN(Surface) s, real3 direction)
{
    real below = dot3(direction, s.geometric);
    if (below < real(0)) direction = add_scaled3(direction, s.geometric, real(-1.001) * below);
    return leave_surface(s, normalise3(direction), KD_T_LIMIT);
}

/// A facet that a viewer sees of a rough surface, in coordinates whose z is the surface's normal: a point of the visible
/// normals of Trowbridge & Reitz's distribution (Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018).
KD_FN real3 visible_facet(real3 viewer, real alpha, real2 disc)
{
    real3 stretched = normalise3(real3(alpha * viewer.x, alpha * viewer.y, viewer.z));
    real3 level = normalise3(real3(-stretched.y, stretched.x, 0));
    if (stretched.x == real(0) && stretched.y == real(0)) level = real3(1, 0, 0);
    real3 upward = cross3(stretched, level);
    PRECISE real share = real(0.5) * (real(1) + stretched.z);
    PRECISE real y = (real(1) - share) * height_over(real2(disc.x, 0)) + share * disc.y;
    real3 seen = add_scaled3(scale3(level, disc.x), upward, y);
    seen = add_scaled3(seen, stretched, height_over(real2(disc.x, y)));
    return normalise3(real3(alpha * seen.x, alpha * seen.y, max(seen.z, real(0))));
}

/// What facets between a direction and the surface leave of light along it (Smith's G1), by the cosine to the normal.
KD_FN real unmasked(real cosine, real alpha)
{
    if (!(cosine > real(0))) return real(0);
    PRECISE real a2 = alpha * alpha;
    PRECISE real slope = a2 + (real(1) - a2) * cosine * cosine;
    return quotient(cosine + cosine, cosine + square_root(slope));
}

/// The normal that a reflection of `d`, a unit vector, is mirrored about.
KD_FN real3 facet_normal(IN(Surface) s, real3 d, real alpha, uint key)
{
    real3 a;
    real3 b;
    basis_of(s.shading, a, b);
    real3 viewer = real3(-dot3(d, a), -dot3(d, b), max(-dot3(d, s.shading), real(0)));
    real3 facet = visible_facet(viewer, alpha, disc_of(sample_square(key)));
    return add_scaled3(add_scaled3(scale3(a, facet.x), b, facet.y), s.shading, facet.z);
}

/// The reflection of a path at its hit, mirrored or, where gloss is sampled, by a facet.
KD_FN Onward reflect_path(IN(Path) path)
{
    Surface s = surface_of(path);
    real3 d = normalise3(path.ray.direction);
    bool rough = scene_has_gloss() && s.material.roughness > real(0);
    PRECISE real alpha = s.material.roughness * s.material.roughness;
    real3 normal = s.shading;
    if (rough) normal = facet_normal(s, d, alpha, path_key(path));
    real3 mirrored = add_scaled3(d, normal, real(-2) * dot3(d, normal));
    Onward on;
    on.share = rough ? unmasked(dot3(mirrored, s.shading), alpha) : real(1);
    on.ray = leave_above(s, mirrored);
    return on;
}

/// A ray scattered from `s`, as many to a direction as its cosine to the normal.
KD_FN Ray scattered_ray(IN(Surface) s, uint key)
{
    real2 disc = disc_of(sample_square(key));
    return leave_above(s, around(s.shading, real3(disc.x, disc.y, height_over(disc))));
}

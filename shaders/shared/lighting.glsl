// The lighting equation of the fixed-function pipelines that the paper names (its section 3.2.2): ambient, Lambert
// diffuse, Blinn-Phong specular, emission; point, directional and spot lights; shadows by one ray per light.

/// A point of a disc of `radius` about the end of `towards`, at right angles to the unit vector `axis`.
KD_FN real3 off_centre(real3 towards, real3 axis, real2 disc, real radius)
{
    return towards + scale3(around(axis, real3(disc.x, disc.y, 0)), radius);
}

/// Where a light lies as seen from a point: unit direction towards it, distance, and colour reaching the point unshadowed.
struct LightSample {
    real3 direction;
    real distance;
    real3 colour;
};

/// Towards the light's middle, or where lights are sampled to a point of its disc, the one that `key` stands for.
KD_FN LightSample sample_light(IN(Light) light, real3 position, uint key)
{
    LightSample s;
    bool soft = scene_has_soft_shadows() && light.radius > real(0);
    real2 disc = soft ? disc_of(sample_square(key)) : real2(0, 0);
    // What the scene has not is not asked for.
    if (scene_has_directional_lights() && (light.kind == KD_LIGHT_DIRECTIONAL || !scene_has_placed_lights())) {
        s.direction = -light.direction;
        if (soft) s.direction = normalise3(off_centre(s.direction, s.direction, disc, light.radius));
        s.distance = KD_T_LIMIT;
        s.colour = light.colour;
        return s;
    }
    real3 towards = light.position - position;
    if (soft) towards = off_centre(towards, normalise3(towards), disc, light.radius);
    PRECISE real squared = dot3(towards, towards);
    s.distance = square_root(squared);
    s.direction = normalise3(towards);
    PRECISE real falloff = max(light.attenuation.x + light.attenuation.y * squared, KD_LEAST_FALLOFF);
    PRECISE real strength = real(1) / falloff;
    if (light.range > real(0) && s.distance > light.range) strength = real(0);
    if (scene_has_spot_lights() && light.kind == KD_LIGHT_SPOT) {
        real cosine = -dot3(s.direction, light.direction);
        real width = max(light.cos_inner - light.cos_outer, real(1e-6));
        real edge = min(max((cosine - light.cos_outer) / width, real(0)), real(1));
        strength = strength * edge * edge;
    }
    s.colour = scale3(light.colour, strength);
    return s;
}

/// From the surface towards the light; it ends short of it by its own rounding.
KD_FN Ray shadow_ray(IN(Surface) s, IN(LightSample) light)
{
    return leave_surface(s, light.direction, light.distance * (real(1) - real(8) * KD_T_PADDING));
}

/// Whether the light can reach the surface where nothing stands between them.
KD_FN bool faces_light(IN(Surface) s, IN(LightSample) light)
{
    return dot3(s.shading, light.direction) > real(0) && dot3(s.geometric, light.direction) > real(0) &&
           max_component(light.colour) > real(0);
}

/// What `s` sends towards the viewer of the light that reaches it.
KD_FN real3 reflected_light(IN(Surface) s, IN(LightSample) light, real3 to_viewer)
{
    real3 reflected = scale3(s.material.diffuse, dot3(s.shading, light.direction));
    if (scene_has_highlights()) {
        real3 halfway = normalise3(light.direction + to_viewer);
        real gloss = max(dot3(s.shading, halfway), real(0));
        real highlight = gloss > real(0) ? pow(gloss, s.material.shininess) : real(0);
        reflected = add_scaled3(reflected, s.material.specular, highlight);
    }
    return light.colour * reflected;
}

/// What `s` sends without any light: what is scattered of the light that is everywhere, and what it emits. Where indirect
/// light is sampled, that stands for the light that is everywhere.
KD_FN real3 own_light(IN(Surface) s, int leg)
{
    bool sampled = scene_has_indirect() && leg == KD_LEG_PRIMARY;
    real3 scattered = sampled ? real3(0, 0, 0) : s.material.diffuse * scene_ambient();
    return scene_has_emission() ? scattered + s.material.emission : scattered;
}

/// Light that `s`, at the end of a path, sends back along it. Traces one shadow ray for each light that faces the surface;
/// `first_blocked` receives the first one's hit that found an occluder.
KD_FN real3 light_surface(IN(Path) path, IN(Surface) s, INOUT(Hit) first_blocked)
{
    real3 total = own_light(s, path.leg);
    real3 to_viewer = -normalise3(path.ray.direction);
    int count = light_count();
    for (int i = 0; i < count; ++i) {
        LightSample light = sample_light(fetch_light(i), s.position, light_key(path, i));
        bool lit = faces_light(s, light);
        if (lit && shadows_enabled()) {
            Ray shadow = shadow_ray(s, light);
            Hit blocker = no_hit(shadow);
            traverse(shadow, true, blocker);
            if (blocker.triangle >= 0) {
                lit = false;
                if (first_blocked.triangle < 0) first_blocked = blocker;
            }
        }
        if (lit) total = total + reflected_light(s, light, to_viewer);
    }
    return total;
}

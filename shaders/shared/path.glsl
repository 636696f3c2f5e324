// A path of rays from the camera on, and the keys of what is sampled along it.

/// A path after some bounces: the ray last traced, its hit, and how much of what it finds reaches the pixel. `leg` counts
/// the reflections before that ray, or is KD_LEG_INDIRECT. What the pixel sees along the ray is a cone: `width` across where
/// the ray begins, and `spread` more for each unit of length (ray cones: Akenine-Moeller et al., "Texture Level of Detail
/// Strategies for Real-Time Ray Tracing", Ray Tracing Gems, 2019, section 20.3.4, with all surfaces taken as flat).
struct Path {
    Ray ray;
    Hit hit;
    real3 weight;
    int2 pixel;
    int leg;
    real width;
    real spread;
};

/// Of the cone that a pixel in the middle of the image sees, per unit of distance.
KD_FN real pixel_spread(IN(PinholeCamera) camera, int2 size)
{
    real distance = square_root(dot3(camera.forward, camera.forward));
    return quotient(real(2) * square_root(dot3(camera.up, camera.up)), distance * real(size.y));
}

/// The path of a pixel before its primary ray is traced.
KD_FN Path primary_leg(IN(PinholeCamera) camera, int2 pixel, int2 size)
{
    Path path;
    path.ray = camera_ray(camera, pixel, size);
    path.hit = no_hit(path.ray);
    path.weight = real3(1, 1, 1);
    path.pixel = pixel;
    path.leg = KD_LEG_PRIMARY;
    path.width = real(0);
    path.spread = pixel_spread(camera, size);
    return path;
}

/// The cone's width at the hit.
KD_FN real width_at_hit(IN(Path) path)
{
    PRECISE real width = path.width + path.spread * path.hit.t;
    return width;
}

KD_FN Surface surface_of(IN(Path) path)
{
    return surface_at(path.ray, path.hit, width_at_hit(path));
}

/// What sample_square() draws for this pixel on this leg: a key for each light, and one for the ray that goes on.
KD_FN uint path_key(IN(Path) path)
{
    uint row = mix_bits(uint(path.pixel.y) + mix_bits(sample_seed()));
    return mix_bits(uint(path.leg) + mix_bits(uint(path.pixel.x) + row));
}

KD_FN uint light_key(IN(Path) path, int light)
{
    return path_key(path) + 4u * uint(light + 1);
}

// A path of rays from the camera on, and the keys of what is sampled along it.

/// A path after some bounces: the ray last traced, its hit, and how much of what it finds reaches the pixel. `leg` counts
/// the reflections before that ray, or is KD_LEG_INDIRECT.
struct Path {
    Ray ray;
    Hit hit;
    real3 weight;
    int2 pixel;
    int leg;
};

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

// Holes that an image cuts into triangles.

/// Whether a ray passes through a triangle at this point: its image is more transparent there than its material's cutoff.
/// The image is not filtered over what a pixel covers, so that a hit hangs on the ray alone.
KD_CALL_FN bool cut_out(int triangle, real u, real v)
{
    Material material = fetch_material(fetch_material_index(triangle));
    if (!(material.alpha_cutoff > real(0))) return false;
    real alpha = real(1);
    if (material.texture >= 0) {
        real2 a;
        real2 b;
        real2 c;
        fetch_texture_coordinates(triangle, a, b, c);
        alpha = sample_texture(material.texture, blend2(a, b, c, u, v), real(0)).w;
    }
    return alpha < material.alpha_cutoff;
}

KD_FN bool masked_out(int triangle, real u, real v)
{
    return scene_has_masks() && cut_out(triangle, u, v);
}

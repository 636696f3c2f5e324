// Images on surfaces: which texels, how coarse, and what lies between them.

KD_FN int modulo(int i, int size)
{
    int m = i - (i / size) * size;
    return m < 0 ? m + size : m;
}

/// The texel that stands at place `i` of a row of `size`, which may lie beyond its ends.
KD_FN int wrap_texel(int i, int size, int wrap)
{
    if (scene_has_wraps() && wrap == KD_WRAP_CLAMP) return min(max(i, 0), size - 1);
    if (scene_has_wraps() && wrap == KD_WRAP_MIRROR) {
        int there = modulo(i, 2 * size);
        return there < size ? there : 2 * size - 1 - there;
    }
    return modulo(i, size);
}

/// Where in an image a coordinate lies: 0..1, or 0..2 with its mirror image; 0 for what is no place (infinities and NaN).
KD_FN real place_in_image(real coordinate, int wrap)
{
    real period = scene_has_wraps() && wrap == KD_WRAP_MIRROR ? real(2) : real(1);
    PRECISE real place = coordinate - period * floor(coordinate / period);
    if (scene_has_wraps() && wrap == KD_WRAP_CLAMP) place = min(max(coordinate, real(0)), real(1));
    return place >= real(0) && place <= period ? place : real(0);
}

/// Bilinear, in the image's whole size. Bytes, 0..255.
KD_FN real4 sample_bilinear(IN(TextureImage) image, real2 uv)
{
    PRECISE real x = place_in_image(uv.x, image.wrap_x) * real(image.width) - real(0.5);
    PRECISE real y = place_in_image(uv.y, image.wrap_y) * real(image.height) - real(0.5);
    int left = int(floor(x));
    int top = int(floor(y));
    PRECISE real fx = x - floor(x);
    PRECISE real fy = y - floor(y);
    int x0 = wrap_texel(left, image.width, image.wrap_x);
    int x1 = wrap_texel(left + 1, image.width, image.wrap_x);
    int upper = image.first + wrap_texel(top, image.height, image.wrap_y) * image.width;
    int lower = image.first + wrap_texel(top + 1, image.height, image.wrap_y) * image.width;
    real4 above = mix4(fetch_texel(upper + x0), fetch_texel(upper + x1), fx);
    real4 below = mix4(fetch_texel(lower + x0), fetch_texel(lower + x1), fx);
    return mix4(above, below, fy);
}

/// The image half as wide and high that follows this one.
KD_FN TextureImage coarser_image(IN(TextureImage) image)
{
    TextureImage next = image;
    next.first = image.first + image.width * image.height;
    next.width = max(image.width / 2, 1);
    next.height = max(image.height / 2, 1);
    next.levels = image.levels - 1;
    return next;
}

/// Colour and alpha, 0..1, of what a square of this area in texture coordinates sees: trilinear between the two levels whose
/// texels are next in size. The level between them is taken to go with the square's side, not its logarithm: at most 0.09 of
/// a level apart, and the same on every machine.
KD_CALL_FN real4 sample_texture(int index, real2 uv, real area)
{
    TextureImage image = fetch_texture(index);
    PRECISE real texels = scene_has_mip_maps() ? area * real(image.width) * real(image.height) : real(0);
    while (image.levels > 1 && texels >= real(4)) {
        image = coarser_image(image);
        texels = texels * real(0.25);
    }
    real4 bytes = sample_bilinear(image, uv);
    if (image.levels > 1 && texels > real(1)) {
        PRECISE real share = square_root(texels) - real(1);
        bytes = mix4(bytes, sample_bilinear(coarser_image(image), uv), share);
    }
    return scale4(bytes, real(0.00392156862745098));
}

KD_FN real2 blend2(real2 a, real2 b, real2 c, real u, real v)
{
    PRECISE real w = real(1) - u - v;
    PRECISE real x = a.x * w + b.x * u + c.x * v;
    PRECISE real y = a.y * w + b.y * u + c.y * v;
    return real2(x, y);
}

// The surface at a hit: position, normals, material, and where new rays may start.

/// `geometric` and `shading` are unit normals on the side the ray came from; `margin` is how far a new ray's origin must
/// move along `geometric` to be surely on that side.
struct Surface {
    real3 position;
    real3 geometric;
    real3 shading;
    real margin;
    int triangle;
    Material material;
};

KD_FN real3 blend3(real3 a, real3 b, real3 c, real u, real v)
{
    PRECISE real w = real(1) - u - v;
    return add_scaled3(add_scaled3(scale3(a, w), b, u), c, v);
}

KD_FN int wrap_texel(int i, int size)
{
    int m = i - (i / size) * size;
    return m < 0 ? m + size : m;
}

/// Where in a repeating image a coordinate lies, 0..1; 0 for what is no place (infinities and NaN).
KD_FN real place_in_image(real coordinate)
{
    PRECISE real place = coordinate - floor(coordinate);
    return place >= real(0) && place <= real(1) ? place : real(0);
}

/// Bilinear, repeating.
KD_FN real3 sample_texture(int texture_index, real2 uv)
{
    int2 size = fetch_texture_size(texture_index);
    PRECISE real x = place_in_image(uv.x) * real(size.x) - real(0.5);
    PRECISE real y = place_in_image(uv.y) * real(size.y) - real(0.5);
    int left = int(floor(x));
    int top = int(floor(y));
    PRECISE real fx = x - floor(x);
    PRECISE real fy = y - floor(y);
    int x0 = wrap_texel(left, size.x);
    int x1 = wrap_texel(left + 1, size.x);
    int y0 = wrap_texel(top, size.y);
    int y1 = wrap_texel(top + 1, size.y);
    real3 upper = add_scaled3(scale3(fetch_texel(texture_index, x0, y0), real(1) - fx), fetch_texel(texture_index, x1, y0), fx);
    real3 lower = add_scaled3(scale3(fetch_texel(texture_index, x0, y1), real(1) - fx), fetch_texel(texture_index, x1, y1), fx);
    return add_scaled3(scale3(upper, real(1) - fy), lower, fy);
}

KD_FN void tint_by_textures(IN(Hit) hit, INOUT(Material) material)
{
    bool glows = scene_has_emission() && material.emission_texture >= 0;
    if (material.texture < 0 && !glows) return;
    real2 uv = fetch_texture_coordinates(hit.triangle, hit.u, hit.v);
    if (material.texture >= 0) material.diffuse = material.diffuse * sample_texture(material.texture, uv);
    if (glows) material.emission = material.emission * sample_texture(material.emission_texture, uv);
}

/// Everything shading needs to know about a hit of `ray`.
KD_FN Surface surface_at(IN(Ray) ray, IN(Hit) hit)
{
    real3 a;
    real3 b;
    real3 c;
    fetch_corners(-1, hit.triangle, int3(0, 1, 2), a, b, c);
    Surface s;
    s.triangle = hit.triangle;
    s.position = blend3(a, b, c, hit.u, hit.v);
    s.geometric = normalise3(cross3(b - a, c - a));
    if (dot3(s.geometric, ray.direction) > real(0)) s.geometric = -s.geometric;

    // Rounding of the blend is below gamma(7) times the sum of magnitudes per axis; twice that also covers the addition.
    real3 magnitude = blend3(abs(a), abs(b), abs(c), abs(hit.u), abs(hit.v));
    s.margin = real(2) * KD_GAMMA_7 * dot3(abs(s.geometric), magnitude);

    s.material = fetch_material(fetch_material_index(hit.triangle));
    s.shading = s.geometric;
    if (scene_has_normals()) {
        real3 na;
        real3 nb;
        real3 nc;
        fetch_normals(hit.triangle, na, nb, nc);
        real3 blended = blend3(na, nb, nc, hit.u, hit.v);
        // A zero or undefined vertex normal leaves the geometric one in place.
        if (dot3(blended, blended) > real(1e-12)) {
            s.shading = normalise3(blended);
            if (dot3(s.shading, s.geometric) < real(0)) s.shading = -s.shading;
        }
    }
    if (scene_has_textures()) tint_by_textures(hit, s.material);
    return s;
}

/// A ray that leaves `s` towards `direction`, on the side that `direction` points to. The source triangle is excluded.
KD_FN Ray leave_surface(IN(Surface) s, real3 direction, real t_max)
{
    Ray ray;
    real side = dot3(direction, s.geometric) < real(0) ? -s.margin : s.margin;
    ray.origin = add_scaled3(s.position, s.geometric, side);
    ray.direction = direction;
    ray.t_min = real(0);
    ray.t_max = t_max;
    ray.source = s.triangle;
    return ray;
}

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

/// A triangle's edges from its first corner, in space and in texture coordinates, and twice its area in the latter, below 0
/// where it stands there mirrored.
struct TexturedEdges {
    real3 b;
    real3 c;
    real2 image_b;
    real2 image_c;
    real image_area;
};

/// Area, in texture coordinates, of the square around what a cone of this width sees of a triangle: texels per area of the triangle, and the cone's section stretched as the triangle leans (Akenine-Moeller et al., "Texture Level
/// of Detail Strategies for Real-Time Ray Tracing", Ray Tracing Gems, 2019, section 20.3.4). 0 where that says nothing.
KD_FN real seen_area(IN(TexturedEdges) edges, real cosine, real width)
{
    real3 across = cross3(edges.b, edges.c);
    real in_space = square_root(dot3(across, across));
    if (!(in_space > real(1e-30))) return real(0);
    real section = quotient(width, max(cosine, real(1e-3)));
    PRECISE real area = quotient(abs(edges.image_area), in_space) * section * section;
    return area;
}

KD_FN void tint_by_textures(real2 uv, real area, INOUT(Material) material)
{
    if (material.texture >= 0) {
        real4 tint = sample_texture(material.texture, uv, area);
        material.diffuse = material.diffuse * real3(tint.x, tint.y, tint.z);
    }
    if (scene_has_emission() && material.emission_texture >= 0) {
        real4 tint = sample_texture(material.emission_texture, uv, area);
        material.emission = material.emission * real3(tint.x, tint.y, tint.z);
    }
}

/// `normal` bent as the material's image says: x runs along the image's rows, y up its columns, on the side `front` (1 or
/// -1) of the triangle (glTF 2.0, section 3.9.3). The tangents are those of the triangle's texture coordinates. As it was
/// where these have no area, or where the bent one would lean below the surface.
KD_FN real3 bend_normal(IN(Surface) s, IN(TexturedEdges) edges, real front, real2 uv, real area)
{
    if (edges.image_area == real(0)) return s.shading;
    real sign = edges.image_area < real(0) ? real(-1) : real(1);
    real3 along_rows = scale3(add_scaled3(scale3(edges.b, edges.image_c.y), edges.c, -edges.image_b.y), sign);
    real3 up_columns = scale3(add_scaled3(scale3(edges.b, edges.image_c.x), edges.c, -edges.image_b.x), sign);
    real3 tangent = normalise3(add_scaled3(along_rows, s.shading, -dot3(along_rows, s.shading)));
    real3 bitangent = cross3(s.shading, tangent);
    if (dot3(bitangent, up_columns) < real(0)) bitangent = -bitangent;

    real4 texel = sample_texture(s.material.normal_texture, uv, area);
    PRECISE real x = (real(2) * texel.x - real(1)) * s.material.normal_scale * front;
    PRECISE real y = (real(2) * texel.y - real(1)) * s.material.normal_scale * front;
    PRECISE real z = real(2) * texel.z - real(1);
    real3 bent = normalise3(add_scaled3(add_scaled3(scale3(s.shading, z), tangent, x), bitangent, y));
    return dot3(bent, s.geometric) > real(0) ? bent : s.shading;
}

/// What the images of a surface's material change of it; `cosine` is that of the ray to the normal.
KD_CALL_FN void apply_images(IN(Hit) hit, real3 edge_b, real3 edge_c, real front, real cosine, real width, INOUT(Surface) s)
{
    bool bends = scene_has_normal_maps() && s.material.normal_texture >= 0;
    bool glows = scene_has_emission() && s.material.emission_texture >= 0;
    bool tints = scene_has_textures() && (s.material.texture >= 0 || glows);
    if (!bends && !tints) return;
    real2 a;
    real2 b;
    real2 c;
    fetch_texture_coordinates(hit.triangle, a, b, c);
    real2 uv = blend2(a, b, c, hit.u, hit.v);
    PRECISE real2 image_b = b - a;
    PRECISE real2 image_c = c - a;
    PRECISE real image_area = image_b.x * image_c.y - image_c.x * image_b.y;
    TexturedEdges edges;
    edges.b = edge_b;
    edges.c = edge_c;
    edges.image_b = image_b;
    edges.image_c = image_c;
    edges.image_area = image_area;
    real area = scene_has_mip_maps() ? seen_area(edges, cosine, width) : real(0);
    if (tints) tint_by_textures(uv, area, s.material);
    if (bends) s.shading = bend_normal(s, edges, front, uv, area);
}

/// Everything shading needs to know about a hit of `ray`, whose direction is a unit vector; `width` is that of the cone about
/// it, there, that its pixel sees.
KD_FN Surface surface_at(IN(Ray) ray, IN(Hit) hit, real width)
{
    real3 a;
    real3 b;
    real3 c;
    fetch_corners(-1, hit.triangle, int3(0, 1, 2), a, b, c);
    Surface s;
    s.triangle = hit.triangle;
    s.position = blend3(a, b, c, hit.u, hit.v);
    s.geometric = normalise3(cross3(b - a, c - a));
    real cosine = dot3(s.geometric, ray.direction);
    real front = cosine > real(0) ? real(-1) : real(1);
    if (front < real(0)) s.geometric = -s.geometric;

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
    if (scene_has_textures() || scene_has_normal_maps())
        apply_images(hit, b - a, c - a, front, abs(cosine), width, s);
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

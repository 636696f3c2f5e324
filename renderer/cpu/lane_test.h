// The triangle test of shaders/shared/triangle.glsl on N lanes, as far as t: the same operations in the same order, so
// that every bit is the same. Lanes are rays at one triangle, or triangles before one ray.
//
// No include guard: included once per instruction set, behind lanes.h.

template <int N>
struct LaneTest {
    using L = Lanes<N>;
    using Mask = LaneMask<N>;

    /// A corner as the ray sees it: permuted, from its origin, sheared but for z.
    struct Corner {
        L x, y, z;
    };

    L edge_b, edge_c, determinant, t;
    Mask may_hit;
    Mask rare;  // of these, with an edge function of 0 or a sliver: intersect_triangle() has to look

    /// Tests the lanes of the mask. False where none may hit; nothing else is known then. `thin` is KD_THIN.
    KD_FN bool run(const Corner& a, const Corner& b, const Corner& c, const L& shear_z, float thin, const Mask& lanes) {
        const L product_a = c.x * b.y, product_b = a.x * c.y, product_c = b.x * a.y;
        const L edge_a = product_a - c.y * b.x;
        edge_b = product_b - a.y * c.x;
        edge_c = product_c - b.y * a.x;
        const L smallest = least(edge_a, least(edge_b, edge_c)), largest = greatest(edge_a, greatest(edge_b, edge_c));
        const L inside = greatest(smallest, -largest);
        may_hit = (L::all(0.0f) <= inside) & lanes;
        if (may_hit.none()) return false;

        determinant = edge_a + edge_b + edge_c;
        const L product = greatest(magnitude(product_a), greatest(magnitude(product_b), magnitude(product_c)));
        const L kept = magnitude(determinant) - L::all(thin) * product;
        rare = may_hit & (least(inside, kept) <= L::all(0.0f));
        const L scaled_t = edge_a * (shear_z * a.z) + edge_b * (shear_z * b.z) + edge_c * (shear_z * c.z);
        t = scaled_t / determinant;
        return true;
    }
};

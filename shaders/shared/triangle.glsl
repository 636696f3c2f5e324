// Watertight ray-triangle test: Woop, Benthin, Wald, JCGT 2(1), 2013. Two triangles that share an edge evaluate the
// same products for it, so no ray slips between them. Contraction to fused multiply-add would break that.

/// The edge function p*q - r*s, of which `rounded` is left, with what rounding its products took away (exact but for the
/// last rounding). Its sign is then that in exact arithmetic: rounding keeps the order of two products unless it makes
/// them equal.
KD_FN real with_lost_digits(real rounded, real p, real q, real r, real s)
{
    PRECISE real lost = product_error(p, q) - product_error(r, s);
    PRECISE real restored = rounded + lost;
    return restored;
}

// A determinant below this fraction of the products whose differences it sums has lost more than 6 of its 24 bits: the
// triangle is a sliver, or seen almost edge-on, and its hit would slide along it.
KD_CONST(real) KD_THIN = real(1e-2);

/// How far the three edge functions are from a change of sign: the size of the smallest where all have one sign, below 0
/// where they differ. Six branches on the signs would be unpredictable ones.
KD_FN real inside_by(real a, real b, real c)
{
    real least = min(a, min(b, c));
    real greatest = max(a, max(b, c));
    return max(least, -greatest);
}

/// Tests the triangle stored at `slot` of the leaf lists (its number is `triangle`) and keeps the nearer hit; at equal t
/// the lowest triangle number wins. Where t is NaN there is no hit: the comparisons stand as they are meant, because a GLSL
/// compiler may turn a negated one round.
KD_FN void intersect_triangle(IN(RaySetup) s, int slot, int triangle, INOUT(Hit) hit)
{
    real3 a;
    real3 b;
    real3 c;
    fetch_corners(slot, triangle, s.axes, a, b, c);
    a = a - s.permuted_origin;
    b = b - s.permuted_origin;
    c = c - s.permuted_origin;

    PRECISE real ax = a.x - s.shear.x * a.z;
    PRECISE real ay = a.y - s.shear.y * a.z;
    PRECISE real bx = b.x - s.shear.x * b.z;
    PRECISE real by = b.y - s.shear.y * b.z;
    PRECISE real cx = c.x - s.shear.x * c.z;
    PRECISE real cy = c.y - s.shear.y * c.z;

    PRECISE real product_a = cx * by;
    PRECISE real product_b = ax * cy;
    PRECISE real product_c = bx * ay;
    PRECISE real edge_a = product_a - cy * bx;
    PRECISE real edge_b = product_b - ay * cx;
    PRECISE real edge_c = product_c - by * ax;
    real inside = inside_by(edge_a, edge_b, edge_c);
    if (inside < real(0)) return;

    PRECISE real determinant = edge_a + edge_b + edge_c;
    real largest = max(abs(product_a), max(abs(product_b), abs(product_c)));
    PRECISE real kept = abs(determinant) - KD_THIN * largest;
    // An edge function of 0 may hide a miss: a triangle seen edge-on would be "hit" at a corner far from the ray.
    if (KD_RARE(min(inside, kept) <= real(0))) {
        edge_a = with_lost_digits(edge_a, cx, by, cy, bx);
        edge_b = with_lost_digits(edge_b, ax, cy, ay, cx);
        edge_c = with_lost_digits(edge_c, bx, ay, by, ax);
        if (inside_by(edge_a, edge_b, edge_c) < real(0)) return;
        determinant = edge_a + edge_b + edge_c;
    }
    if (determinant == real(0)) return;

    PRECISE real scaled_t = edge_a * (s.shear.z * a.z) + edge_b * (s.shear.z * b.z) + edge_c * (s.shear.z * c.z);
    PRECISE real t = quotient(scaled_t, determinant);
    bool nearer = t > s.ray.t_min && (t < hit.t || (t == hit.t && triangle < hit.triangle));
    if (nearer && triangle != s.ray.source) {
        real u = quotient(edge_b, determinant);
        real v = quotient(edge_c, determinant);
        if (masked_out(triangle, u, v)) return;
        hit.triangle = triangle;
        hit.t = t;
        hit.u = u;
        hit.v = v;
    }
}

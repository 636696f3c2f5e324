// What is computed once per ray: reciprocal directions for the planes and the shear of the watertight triangle test.

/// `axes` orders the axes so that z is the direction's largest component; `shear` maps the direction to (0, 0, 1).
/// `inverse` holds 1/d, and 0 on an axis that the ray is parallel to (no infinity is ever made). `slack` is the distance
/// within which a cell counts as touched, and `t_slack` the same in t for planes across each axis. `ray` starts
/// `t_shift` later than the ray asked for.
struct RaySetup {
    Ray ray;
    real t_shift;
    real3 inverse;
    real slack;
    real3 t_slack;
    int3 axes;
    real3 shear;
    real3 permuted_origin;
};

// Lengths that a direction may have: within them neither t nor the products that make it leave single precision.
KD_CONST(real) KD_SHORTEST_DIRECTION = real(1e-30);
KD_CONST(real) KD_LONGEST_DIRECTION = real(1.5e20);

KD_FN bool finite3(real3 a, real limit)
{
    return !(IS_NAN(a.x) || IS_NAN(a.y) || IS_NAN(a.z)) && abs(a.x) <= limit && abs(a.y) <= limit && abs(a.z) <= limit;
}

/// True where the ray can be traced: finite, with a direction, and an interval that holds something.
KD_FN bool valid_ray(IN(Ray) ray)
{
    real largest = max_component(abs(ray.direction));
    return finite3(ray.origin, KD_COORDINATE_LIMIT) && finite3(ray.direction, KD_LONGEST_DIRECTION) &&
           largest > KD_SHORTEST_DIRECTION && !(IS_NAN(ray.t_min) || IS_NAN(ray.t_max)) && ray.t_min >= real(0) &&
           ray.t_min < ray.t_max;
}

KD_FN real inverse_or_zero(real d, real smallest)
{
    return abs(d) <= smallest ? real(0) : quotient(real(1), d);
}

// What is smaller is 0, as a shader may take denormals: a component itself, and a shear whose products would be denormal.
KD_CONST(real) KD_LEAST_COMPONENT = real(1.17549435e-38);
KD_CONST(real) KD_LEAST_SHEAR = real(1e-30);

KD_FN real shear_of(real component, real shear_z)
{
    PRECISE real shear = component * shear_z;
    return abs(component) < KD_LEAST_COMPONENT || abs(shear) < KD_LEAST_SHEAR ? real(0) : shear;
}

KD_FN int largest_axis(real3 a)
{
    if (a.x > a.y) return a.x > a.z ? 0 : 2;
    return a.y > a.z ? 1 : 2;
}

/// t_max cut to what t may be. NaN stays, for valid_ray to find.
KD_FN real limited_end(real t_max)
{
    return IS_NAN(t_max) ? t_max : min(t_max, KD_T_LIMIT);
}

// Extents of the scene between a ray's origin and its farthest corner, above which it starts later.
KD_CONST(real) KD_NEAR_THE_SCENE = real(8);

/// How much later a ray may start: 0 near the scene; from far away, to about twice the scene's extent before it. At a
/// distance, single precision resolves neither triangles nor cells, and every cell would count as touched.
KD_FN real shift_towards(IN(Ray) ray, real3 lower, real3 upper, real reach)
{
    real extent = (upper.x - lower.x) + (upper.y - lower.y) + (upper.z - lower.z);
    if (!(reach > KD_NEAR_THE_SCENE * extent) || !valid_ray(ray)) return real(0);
    real largest = max_component(abs(ray.direction));
    real3 direction = scale3(ray.direction, quotient(real(1), largest));
    real3 to_centre = scale3(lower + upper, real(0.5)) - ray.origin;
    PRECISE real distance = quotient(dot3(to_centre, direction), dot3(direction, direction)) - real(2) * extent;
    real t = quotient(distance, largest);
    return t > ray.t_min && t < ray.t_max ? t : real(0);
}

KD_FN real farthest_corner(real3 point, real3 lower, real3 upper)
{
    return max_component(max(abs(lower - point), abs(upper - point)));
}

/// Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013, section 3.1. Winding is not kept:
/// both faces count, so the axes need no swap.
KD_FN RaySetup setup_ray(IN(Ray) asked)
{
    RaySetup s;
    real3 lower;
    real3 upper;
    fetch_bounds(lower, upper);
    s.ray = asked;
    s.ray.t_max = limited_end(asked.t_max);
    real reach = farthest_corner(asked.origin, lower, upper);
    s.t_shift = KD_RULES == KD_RULES_ROBUST ? shift_towards(s.ray, lower, upper, reach) : real(0);
    if (KD_RARE(s.t_shift > real(0))) {
        s.ray.origin = add_scaled3(asked.origin, asked.direction, s.t_shift);
        s.ray.t_min = real(0);
        s.ray.t_max = s.ray.t_max - s.t_shift;
        reach = farthest_corner(s.ray.origin, lower, upper);
    }
    real3 origin = s.ray.origin;
    real3 direction = asked.direction;
    real smallest = KD_PARALLEL * max_component(abs(direction));
    s.inverse = real3(inverse_or_zero(direction.x, smallest), inverse_or_zero(direction.y, smallest),
                      inverse_or_zero(direction.z, smallest));
    PRECISE real slack = KD_SLACK * reach;
    s.slack = slack;
    s.t_slack = scale3(abs(s.inverse), slack);
    int z = largest_axis(abs(direction));
    int x = z == 2 ? 0 : z + 1;
    int y = x == 2 ? 0 : x + 1;
    s.axes = int3(x, y, z);
    PRECISE real shear_z = AXIS(s.inverse, z);
    s.shear = real3(shear_of(AXIS(direction, x), shear_z), shear_of(AXIS(direction, y), shear_z), shear_z);
    s.permuted_origin = real3(AXIS(origin, x), AXIS(origin, y), AXIS(origin, z));
    return s;
}

KD_FN Hit no_hit(IN(Ray) ray)
{
    Hit hit;
    hit.triangle = -1;
    hit.t = limited_end(ray.t_max);
    hit.u = real(0);
    hit.v = real(0);
    return hit;
}

/// A cell that begins at `t_begin` can no longer hold the nearest hit. A tie in a neighbouring leaf is still looked at.
KD_FN bool beyond_hit(IN(Hit) hit, real t_begin)
{
    return hit.t * (real(1) + KD_T_PADDING) < t_begin;
}

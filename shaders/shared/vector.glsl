// Vector algebra written out, so that every machine adds in the same order. GLSL's own dot, cross and normalize may not.

#include "rounding.glsl"

KD_FN real dot3(real3 a, real3 b)
{
    PRECISE real sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

KD_FN real3 cross3(real3 a, real3 b)
{
    PRECISE real x = a.y * b.z - a.z * b.y;
    PRECISE real y = a.z * b.x - a.x * b.z;
    PRECISE real z = a.x * b.y - a.y * b.x;
    return real3(x, y, z);
}

KD_FN real3 scale3(real3 a, real s)
{
    PRECISE real x = a.x * s;
    PRECISE real y = a.y * s;
    PRECISE real z = a.z * s;
    return real3(x, y, z);
}

/// a + b*s
KD_FN real3 add_scaled3(real3 a, real3 b, real s)
{
    PRECISE real x = a.x + b.x * s;
    PRECISE real y = a.y + b.y * s;
    PRECISE real z = a.z + b.z * s;
    return real3(x, y, z);
}

KD_FN real4 scale4(real4 a, real s)
{
    PRECISE real x = a.x * s;
    PRECISE real y = a.y * s;
    PRECISE real z = a.z * s;
    PRECISE real w = a.w * s;
    return real4(x, y, z, w);
}

/// a + (b - a)*s, which is a or b at either end
KD_FN real4 mix4(real4 a, real4 b, real s)
{
    PRECISE real rest = real(1) - s;
    PRECISE real x = a.x * rest + b.x * s;
    PRECISE real y = a.y * rest + b.y * s;
    PRECISE real z = a.z * rest + b.z * s;
    PRECISE real w = a.w * rest + b.w * s;
    return real4(x, y, z, w);
}

/// The vector divided by its length; the zero vector stays zero.
KD_FN real3 normalise3(real3 a)
{
    PRECISE real squared = dot3(a, a);
    if (!(squared > real(0))) return a;
    real inverse = quotient(real(1), square_root(squared));
    return scale3(a, inverse);
}

KD_FN real max_component(real3 a)
{
    return max(a.x, max(a.y, a.z));
}

// Where light is sampled: points of low discrepancy for each pixel, the same on every machine.
//
// Sample n of a pixel takes point n of Sobol's sequence in two dimensions, shuffled and scrambled after Owen by a hash
// (Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020), with a key of its own for each thing sampled.

/// Every bit of the answer hangs on every bit of x.
KD_FN uint mix_bits(uint x)
{
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    x ^= x >> 16u;
    return x;
}

KD_FN uint reverse_bits(uint x)
{
    x = (x >> 16u) | (x << 16u);
    x = ((x & 0xff00ff00u) >> 8u) | ((x & 0x00ff00ffu) << 8u);
    x = ((x & 0xf0f0f0f0u) >> 4u) | ((x & 0x0f0f0f0fu) << 4u);
    x = ((x & 0xccccccccu) >> 2u) | ((x & 0x33333333u) << 2u);
    return ((x & 0xaaaaaaaau) >> 1u) | ((x & 0x55555555u) << 1u);
}

/// Flips each of 32 binary digits, the first the most significant, by those before it: Owen's scrambling, with the hash of
/// Burley's section 3 (after Laine & Karras).
KD_FN uint scramble(uint x, uint seed)
{
    x = reverse_bits(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverse_bits(x);
}

/// Coordinate n of the second dimension of Sobol's sequence; of the first it is reverse_bits(n).
KD_FN uint second_sobol(uint n)
{
    uint x = 0u;
    for (uint column = 0x80000000u; n != 0u; n >>= 1u) {
        if ((n & 1u) != 0u) x ^= column;
        column ^= column >> 1u;
    }
    return x;
}

/// The 24 leading bits as a number of 0 to below 1.
KD_FN real unit_real(uint bits)
{
    return real(int(bits >> 8u)) * real(5.9604644775390625e-8);
}

/// This frame's point of the unit square for the thing that `key` stands for; keys less than 4 apart are not independent.
KD_FN real2 sample_square(uint key)
{
    uint n = scramble(uint(sample_number()), mix_bits(key));
    return real2(unit_real(scramble(reverse_bits(n), mix_bits(key + 1u))),
                 unit_real(scramble(second_sobol(n), mix_bits(key + 2u))));
}

/// The unit square onto the unit disc with areas in proportion (Shirley & Chiu, "A Low Distortion Map Between Disk and
/// Square", JGT 2(3), 1997). Sine and cosine are their series, which every machine adds alike: off by less than 1e-7.
KD_FN real2 disc_of(real2 square)
{
    PRECISE real x = real(2) * square.x - real(1);
    PRECISE real y = real(2) * square.y - real(1);
    bool wide = abs(x) > abs(y);
    real radius = wide ? x : y;
    if (radius == real(0)) return real2(0, 0);
    PRECISE real angle = real(0.7853981633974483) * (wide ? quotient(y, x) : quotient(x, y));
    PRECISE real a2 = angle * angle;
    PRECISE real cubic = a2 * (real(-0.16666666666666667) + a2 * (real(0.0083333333333333333) - a2 * real(1.984126984126984e-4)));
    PRECISE real quartic = a2 * (real(0.041666666666666667) - a2 * (real(1.388888888888889e-3) - a2 * real(2.48015873015873e-5)));
    PRECISE real sine = angle + angle * cubic;
    PRECISE real cosine = real(1) + a2 * (real(-0.5) + quartic);
    PRECISE real along = radius * cosine;
    PRECISE real across = radius * sine;
    return wide ? real2(along, across) : real2(across, along);
}

/// Unit vectors at right angles to a unit vector and to each other (Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6(1), 2017).
KD_FN void basis_of(real3 n, OUT(real3) a, OUT(real3) b)
{
    real side = n.z < real(0) ? real(-1) : real(1);
    real k = quotient(real(-1), side + n.z);
    PRECISE real xy = n.x * n.y * k;
    PRECISE real xx = real(1) + side * n.x * n.x * k;
    PRECISE real yy = side + n.y * n.y * k;
    a = real3(xx, side * xy, -side * n.x);
    b = real3(xy, yy, -n.y);
}

/// The vector with these coordinates along a basis_of() of `n` and along `n`.
KD_FN real3 around(real3 n, real3 v)
{
    real3 a;
    real3 b;
    basis_of(n, a, b);
    return add_scaled3(add_scaled3(scale3(a, v.x), b, v.y), n, v.z);
}

/// The height of a unit hemisphere over a point of its disc.
KD_FN real height_over(real2 disc)
{
    PRECISE real squared = real(1) - disc.x * disc.x - disc.y * disc.y;
    return square_root(max(squared, real(0)));
}

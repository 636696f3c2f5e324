// Quotients and roots rounded to the nearest number on every machine. C++ and the software renderers have them; GLSL promises
// 2.5 units in the last place, and an NVIDIA GPU uses them. With KD_CORRECTED_ROUNDING 1 the remainder, which is exact,
// says how far off the machine's own answer is: hits and counters are then the same to the last bit there too.

/// a*b minus its rounded value, exactly unless it underflows. With KD_FUSED 1 a fused multiply-add, where the machine has
/// one that rounds once; else after Dekker (Numerische Mathematik 18, 1971). KD_DEKKER halves the digits: 2^12 + 1 for a
/// float's 24 bits, 2^27 + 1 for a double's 53.
KD_FN real product_error(real a, real b)
{
    PRECISE real product = a * b;
#if KD_FUSED
    PRECISE real error = fma(a, b, -product);
#else
    PRECISE real a_scaled = a * KD_DEKKER;
    PRECISE real a_high = a_scaled - (a_scaled - a);
    PRECISE real a_low = a - a_high;
    PRECISE real b_scaled = b * KD_DEKKER;
    PRECISE real b_high = b_scaled - (b_scaled - b);
    PRECISE real b_low = b - b_high;
    PRECISE real error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
#endif
    return error;
}

/// Whether a number of this size may be a factor, or the product, of product_error: nothing overflows or underflows then.
KD_FN bool factor_fits(real a)
{
    return abs(a) > real(1e-30) && abs(a) < real(1e30);
}
KD_FN bool product_fits(real a)
{
    return abs(a) > real(1e-24) && abs(a) < real(1e30);
}

/// a - q*b, exactly where q*b is within a few units in the last place of a.
KD_FN real remainder_of(real a, real q, real b)
{
    PRECISE real product = q * b;
    PRECISE real rest = (a - product) - product_error(q, b);
    return rest;
}

/// The number next to `sum` on the far side of what `addend` brought, where the two are about equally near to the exact
/// start + addend; else `sum`. The addend is then known too coarsely to choose, and remainders have to.
KD_FN real nearly_tied(real start, real addend, real sum)
{
    PRECISE real lost = addend - (sum - start);
    PRECISE real other = sum + (lost + lost);
    PRECISE real miss = (other - sum) - (lost + lost);
    return abs(miss) < real(1e-4) * abs(lost) ? other : sum;
}

/// What brings a number below those of product_fits among them, without rounding: an even power of two, 2^48; else 1.
KD_FN real lift_of(real a)
{
    return abs(a) > real(1e-24) ? real(1) : real(281474976710656.0);
}

KD_FN real quotient(real dividend, real divisor)
{
    PRECISE real q = dividend / divisor;
    if (KD_CORRECTED_ROUNDING == 0) return q;
    real lift = lift_of(dividend);
    PRECISE real a = dividend * lift;
    PRECISE real b = divisor * lift;
    bool exact = product_fits(a) && factor_fits(q) && factor_fits(b);
    if (!exact) return q;
    PRECISE real step = remainder_of(a, q, b) / b;
    PRECISE real nearest = q + step;
    real other = nearly_tied(q, step, nearest);
    if (KD_RARE(other != nearest) && abs(remainder_of(a, other, b)) < abs(remainder_of(a, nearest, b))) return other;
    return nearest;
}

KD_FN real square_root(real radicand)
{
    PRECISE real given = sqrt(radicand);
    if (KD_CORRECTED_ROUNDING == 0) return given;
    real lift = lift_of(radicand);
    real lower = lift == real(1) ? real(1) : real(5.9604644775390625e-8);  // 1 / square root of lift
    PRECISE real a = radicand * lift;
    if (!product_fits(a)) return given;
    PRECISE real root = sqrt(a);
    PRECISE real step = remainder_of(a, root, root) / (root + root);
    PRECISE real nearest = root + step;
    real other = nearly_tied(root, step, nearest);
    if (KD_RARE(other != nearest) && abs(remainder_of(a, other, other)) < abs(remainder_of(a, nearest, nearest)))
        return other * lower;
    return nearest * lower;
}

// Which group of a dispatch has which rows or places. llvmpipe gives each of its threads one run of groups, and one that has
// the emptier part of a picture would wait for the others: so eighths of a dispatch are dealt in turn (KD_DEALT).

const uint dealt_to = 8u; // renderer/gl/gl_tracer_compute.cpp rounds up to it

/// A permutation of 0 to count - 1, `count` a multiple of dealt_to. Bits of the eighth are reversed, so that each run of two, four
/// or eight has its share of neighbours.
uint dealt(uint place, uint count)
{
#if KD_DEALT
    uint turns = count / dealt_to;
    return place % turns * dealt_to + (uint(bitfieldReverse(place / turns)) >> 29);
#else
    return place;
#endif
}

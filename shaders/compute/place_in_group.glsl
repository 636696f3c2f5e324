// Which pixel of its group's block each of a group's places has.

/// Bits 0, 2, 4, ... pushed together.
uint even_bits(uint x)
{
    x &= 0x55555555u;
    x = (x | x >> 1) & 0x33333333u;
    x = (x | x >> 2) & 0x0f0f0f0fu;
    return (x | x >> 4) & 0xffu;
}

int2 pixel_in_group(uint place)
{
#if KD_MORTON
    return int2(even_bits(place), even_bits(place >> 1));
#else
    return int2(place % uint(KD_GROUP_X), place / uint(KD_GROUP_X));
#endif
}

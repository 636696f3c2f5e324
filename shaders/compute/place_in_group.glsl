// Which pixel of its group's block an invocation has.

/// Bits 0, 2, 4, ... pushed together.
uint even_bits(uint x)
{
    x &= 0x55555555u;
    x = (x | x >> 1) & 0x33333333u;
    x = (x | x >> 2) & 0x0f0f0f0fu;
    return (x | x >> 4) & 0xffu;
}

/// This invocation's pixel in its group.
int2 place_in_group()
{
#if KD_MORTON
    return int2(even_bits(gl_LocalInvocationIndex), even_bits(gl_LocalInvocationIndex >> 1));
#else
    return int2(gl_LocalInvocationID.xy);
#endif
}

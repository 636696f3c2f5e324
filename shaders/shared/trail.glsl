// The restart trail (Laine, "Restart Trail for Stackless BVH Traversal", HPG 2010): where a walk goes on from the top, one
// bit per level, set once the far child is taken. It only grows as a binary number, so every walk ends.

/// One bit per level of the tree: 0..63, or 0..31 where no tree is deeper.
struct Trail {
    uint low;
#if KD_LONG_TRAIL
    uint high;
#endif
};

/// Every far child is still to come.
KD_FN Trail new_trail()
{
    Trail trail;
    trail.low = 0u;
#if KD_LONG_TRAIL
    trail.high = 0u;
#endif
    return trail;
}

KD_FN bool trail_bit(IN(Trail) trail, int level)
{
#if KD_LONG_TRAIL
    if (level >= 32) return (trail.high >> uint(level - 32) & 1u) != 0u;
#endif
    return (trail.low >> uint(level) & 1u) != 0u;
}

/// Sets the bit of `level` and clears those of all deeper levels.
KD_FN Trail advance_trail(IN(Trail) trail, int level)
{
    Trail next;
#if KD_LONG_TRAIL
    if (level >= 32) {
        uint high_bit = 1u << uint(level - 32);
        next.low = trail.low;
        next.high = (trail.high & (high_bit - 1u)) | high_bit;
        return next;
    }
    next.high = 0u;
#endif
    uint bit = 1u << uint(level);
    next.low = (trail.low & (bit - 1u)) | bit;
    return next;
}

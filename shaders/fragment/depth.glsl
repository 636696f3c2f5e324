// The depth that RTPrim leaves, by which later passes skip pixels.

/// Later quads lie between these: ShadePrim at 0.5, RTRefl and ShadeRefl at 0.125, drawn with GREATER.
float depth_of(Path path)
{
    if (path.hit.triangle < 0) return 1.0;
#if KD_PUBLISHED_DEPTH
    return 0.0;
#elif !KD_REFLECTIONS
    return 0.25;
#else
    return goes_on(path) ? 0.0 : 0.25;
#endif
}

void leave_depth(Path path)
{
    gl_FragDepth = depth_of(path);
}

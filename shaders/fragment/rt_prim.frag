// RTPrim (paper, section 3.2.1): traces the primary rays and sets the depth that lets later passes skip pixels.

#define KD_WRITES_DEPTH
#include "tracer.glsl"
#include "pixel_io.glsl"
#include "path_io.glsl"
#include "shaded.glsl"

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

void main()
{
    count_shaded();
    Path path = trace_primary(frame_camera(), this_pixel(), frame.image.xy);
    out_hit = pack_hit(path.hit);
    gl_FragDepth = depth_of(path);
    write_counters();
}

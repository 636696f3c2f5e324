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

#if KD_ENTRY == 2
layout(binding = 10) uniform isamplerBuffer kd_entries; // the node of each tile of the area, row by row
#endif

void set_entry()
{
#if KD_ENTRY == 1
    walk_entry = frame.rays.w;
#elif KD_ENTRY == 2
    int2 tile = (this_pixel() - frame.entry.xy) / frame.entry.z;
    walk_entry = texelFetch(kd_entries, tile.y * frame.entry.w + tile.x).x;
#endif
}

void main()
{
    count_shaded();
    set_entry();
    Path path = trace_primary(frame_camera(), this_pixel(), frame.image.xy);
    out_hit = pack_hit(path.hit);
    gl_FragDepth = depth_of(path);
    write_counters();
}

// RTPrim (paper, section 3.2.1): traces the primary rays.

#if KD_ENTRY == 2
layout(binding = 10) uniform isamplerBuffer kd_entries; // the node of each tile of the area, row by row
#endif

void set_entry(int2 pixel)
{
#if KD_ENTRY == 1
    walk_entry = frame.rays.w;
#elif KD_ENTRY == 2
    int2 tile = (pixel - frame.entry.xy) / frame.entry.z;
    walk_entry = texelFetch(kd_entries, tile.y * frame.entry.w + tile.x).x;
#endif
}

void run_pass(int2 pixel)
{
    count_shaded(true);
    set_entry(pixel);
    Path path = trace_primary(frame_camera(), pixel, frame.image.xy);
    leave_hit(pixel, path.hit);
    leave_depth(path);
    leave_counters(pixel);
}

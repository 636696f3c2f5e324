// Runs a pass, run_pass(), which stands above: each invocation at its own pixel. Defines main().

#include "own_pixel.glsl"

layout(local_size_x = KD_GROUP_X, local_size_y = KD_GROUP_Y) in;

void main()
{
    int2 pixel;
    if (!own_pixel(gl_LocalInvocationIndex, pixel)) return;
#if KD_PHASE
    next_slot = ((pixel.y - frame.tile.y) * (frame.tile.z - frame.tile.x) + pixel.x - frame.tile.x) * frame.wave.y;
#endif
    run_pass(pixel);
}

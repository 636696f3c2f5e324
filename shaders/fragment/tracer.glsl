// The tracer in a fragment shader: settings, tables, hooks, the shared text. For entry points to include first.

#include "language.glsl"
#include "settings.glsl"
#include "shared/counters.glsl"
#include "shared/constants.glsl"
#include "shared/types.glsl"
#include "blocks.glsl"
#include "bindings.glsl"
#include "scene_hooks.glsl"
#include "observer_hooks.glsl"
#include "shared/kernel.glsl"

/// Image row r from the top is row r of the targets; whoever displays them turns them over.
int2 this_pixel()
{
    return int2(gl_FragCoord.xy);
}

PinholeCamera frame_camera()
{
    return PinholeCamera(frame.eye.xyz, frame.right.xyz, frame.up.xyz, frame.forward.xyz);
}

/// A layer's hit where its rays found nothing.
Hit nothing_found()
{
    return Hit(-1, 0.0, 0.0, 0.0);
}

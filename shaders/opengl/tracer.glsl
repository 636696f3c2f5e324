// The tracer on tables that are there already (texture_tables.glsl or another): hooks and the shared text.

#include "attribute_tables.glsl"
#include "scene_hooks.glsl"
#include "observer_hooks.glsl"
#if KD_PHASE
#include "wavefront/kernel.glsl"
#else
#include "shared/kernel.glsl"
#endif

PinholeCamera frame_camera()
{
    return PinholeCamera(frame.eye.xyz, frame.right.xyz, frame.up.xyz, frame.forward.xyz);
}

/// A layer's hit where its rays found nothing.
Hit nothing_found()
{
    return Hit(-1, 0.0, 0.0, 0.0);
}

// The steps of the walk that KD_STEPS names.

#if KD_STEPS == 0
#include "stack_steps.glsl"
#elif KD_STEPS == 2
#include "backtrack_steps.glsl"
#elif KD_STEPS == 5
#include "ropes_steps.glsl"
#else
#include "from_top_steps.glsl"
#endif

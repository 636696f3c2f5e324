// What comes before a shader's own tables: the language, the settings, the types, the uniform blocks.

#include "language.glsl"
#include "settings.glsl"
#include "shared/counters.glsl"
#include "shared/constants.glsl"
#include "shared/types.glsl"
#include "blocks.glsl"

layout(std140, binding = 0) uniform SceneUniforms { SceneBlock scene; };
layout(std140, binding = 1) uniform FrameUniforms { FrameBlock frame; };

uvec4 pack_hit(Hit hit)
{
    return uvec4(uint(hit.triangle), floatBitsToUint(hit.t), floatBitsToUint(hit.u), floatBitsToUint(hit.v));
}

Hit unpack_hit(uvec4 texel)
{
    return Hit(int(texel.x), uintBitsToFloat(texel.y), uintBitsToFloat(texel.z), uintBitsToFloat(texel.w));
}

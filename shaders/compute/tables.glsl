// What walks read: from storage buffers or, where a driver reads those more slowly, from textures.

#if KD_STORAGE
#include "storage_tables.glsl"
#else
#include "opengl/texture_tables.glsl"
#endif

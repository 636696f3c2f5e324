// On which multiprocessor an invocation ran. Before anything else of a shader, for it switches an extension on.

#extension GL_NV_shader_thread_group : require

/// The multiprocessor, how many there are, and a number that took some work, so that none is done before all have begun.
uvec4 this_place(uvec2 pixel)
{
    uint x = pixel.x + 65536u * pixel.y;
    for (int i = 0; i < 256; ++i) x = x * 1664525u + 1013904223u;
    return uvec4(gl_SMIDNV, gl_SMCountNV, x, 0u);
}

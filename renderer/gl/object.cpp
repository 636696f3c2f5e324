#include "renderer/gl/object.h"

namespace kd {

namespace {

template <class IsObject>
int count_below(GLuint newest, IsObject is_object) {
    int count = 0;
    for (GLuint name = 1; name < newest; ++name) count += is_object(name) == GL_TRUE ? 1 : 0;
    return count;
}

}  // namespace

std::array<int, 7> count_objects(const GlApi& gl) {
    const GLuint program = gl.CreateProgram();  // programs and shaders share their names
    gl.DeleteProgram(program);
    return {count_below(GlBuffer(gl).id(), gl.IsBuffer),
            count_below(GlTexture(gl).id(), gl.IsTexture),
            count_below(GlFramebuffer(gl).id(), gl.IsFramebuffer),
            count_below(GlVertexArray(gl).id(), gl.IsVertexArray),
            count_below(GlQuery(gl).id(), gl.IsQuery),
            count_below(program, gl.IsProgram),
            count_below(program, gl.IsShader)};
}

}  // namespace kd

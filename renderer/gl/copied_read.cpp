#include "renderer/gl/copied_read.h"

#include <algorithm>

namespace kd {

void CopiedRead::read(const GlApi& gl, const GlBuffer& buffer, std::span<std::byte> bytes) {
    if (!copy_) copy_ = GlBuffer(gl);
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, copy_.id());
    if (room_ < bytes.size()) gl.BufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(bytes.size()), nullptr, GL_DYNAMIC_READ);
    room_ = std::max(room_, bytes.size());
    gl.BindBuffer(GL_COPY_READ_BUFFER, buffer.id());
    gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(bytes.size()));
    gl.GetBufferSubData(GL_COPY_WRITE_BUFFER, 0, GLsizeiptr(bytes.size()), bytes.data());
}

}  // namespace kd

#include "renderer/gl/pixel_list.h"

#include <fmt/format.h>

#include "renderer/gl/bindings.h"
#include "renderer/gl/gl_error.h"

namespace kd {

namespace {

struct Header {
    // Groups each way. One at least, which finds that it has no pixel: drivers finish compiling when a program first
    // runs.
    std::array<GLuint, 3> groups{1, 1, 1};
    GLuint listed = 0, runs = 0;
};
static_assert(sizeof(Header) == 5 * sizeof(GLuint));

}  // namespace

bool PixelList::reserve(const GlApi& gl, std::int64_t pixels, std::int64_t storage_bytes) {
    const auto bytes = std::int64_t(sizeof(Header)) + pixels * std::int64_t(sizeof(GLuint));
    if (bytes > storage_bytes) return false;
    if (bytes <= bytes_) return true;
    *this = {};
    for (GlBuffer& buffer : buffers_) {
        buffer = GlBuffer(gl);
        gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id());
        gl.BufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(bytes), nullptr, GL_DYNAMIC_COPY);
    }
    check_gl(gl, fmt::format("making room for lists of {} pixels", pixels));
    bytes_ = bytes;
    return true;
}

void PixelList::bind(const GlApi& gl) const {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, pixel_list, buffers_[current_].id());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, next_pixel_list, buffers_[1 - current_].id());
}

void PixelList::begin_next(const GlApi& gl) const {
    bind(gl);  // the next one last: it stands at the target
    constexpr Header empty;
    gl.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof empty, &empty);
}

void PixelList::take_next(const GlApi& gl) {
    current_ = 1 - current_;
    bind(gl);
}

double PixelList::filled(const GlApi& gl, int run_length) {
    Header header;
    header_.read(gl, buffers_[current_], std::as_writable_bytes(std::span(&header, 1)));
    return header.runs == 0 ? 1.0 : double(header.listed) / (double(header.runs) * run_length);
}

void PixelList::dispatch(const GlApi& gl) const {
    gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffers_[current_].id());
    gl.DispatchComputeIndirect(0);
    gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

}  // namespace kd

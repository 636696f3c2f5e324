#include "renderer/gl/fault.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

namespace kd {

namespace {

constexpr int draws_before_loss = 10;

/// OpenGL's functions carry no data of ours, so the wrappers find theirs here.
struct Faults {
    GlApi driver;  // as it was
    std::string asked;
    std::int64_t texels = 0, side = 0, memory = 0, storage = 0;  // 0: as the driver says
    int losses = 0;                                              // contexts still to be lost
    int draws = 0;                                               // in this context
    bool out_of_memory = false;                                  // to be reported by the next glGetError
    bool lost = false;                                           // this context
};

Faults& faults() {
    static thread_local Faults of_this_thread;
    return of_this_thread;
}

/// The number after "word:", 0 where it is not asked for.
std::int64_t number_of(std::string_view asked, std::string_view word) {
    while (!asked.empty()) {
        const std::size_t end = std::min(asked.find(','), asked.size());
        const std::string_view item = asked.substr(0, end);
        asked.remove_prefix(std::min(end + 1, asked.size()));
        if (!item.starts_with(word) || item.substr(word.size(), 1) != ":") continue;
        std::int64_t number = 0;
        std::from_chars(item.data() + word.size() + 1, item.data() + item.size(), number);
        return number;
    }
    return 0;
}

bool refused(std::int64_t bytes) {
    if (faults().memory == 0 || bytes <= faults().memory) return false;
    faults().out_of_memory = true;
    return true;
}

void APIENTRY get_integer(GLenum name, GLint* value) {
    faults().driver.GetIntegerv(name, value);
    if (name == GL_MAX_TEXTURE_BUFFER_SIZE && faults().texels > 0) *value = GLint(faults().texels);
    if (name == GL_MAX_TEXTURE_SIZE && faults().side > 0) *value = GLint(faults().side);
}

void APIENTRY get_integer64(GLenum name, GLint64* value) {
    faults().driver.GetInteger64v(name, value);
    if (name == GL_MAX_SHADER_STORAGE_BLOCK_SIZE && faults().storage > 0) *value = faults().storage;
}

void APIENTRY buffer_data(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (!refused(size)) faults().driver.BufferData(target, size, data, usage);
}

void APIENTRY texture_storage(GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
    constexpr std::int64_t most_bytes_per_pixel = 16;
    if (!refused(most_bytes_per_pixel * width * height))
        faults().driver.TexStorage2D(target, levels, format, width, height);
}

GLenum APIENTRY get_error() {
    const bool ours = std::exchange(faults().out_of_memory, false);
    const GLenum code = faults().driver.GetError();
    return ours ? GLenum(GL_OUT_OF_MEMORY) : code;
}

void APIENTRY draw_arrays(GLenum mode, GLint first, GLsizei count) {
    ++faults().draws;
    faults().driver.DrawArrays(mode, first, count);
}

void APIENTRY dispatch(GLuint x, GLuint y, GLuint z) {
    ++faults().draws;
    faults().driver.DispatchCompute(x, y, z);
}

GLenum APIENTRY reset_status() {
    Faults& f = faults();
    if (!f.lost && f.losses > 0 && f.draws >= draws_before_loss) {
        f.lost = true;
        --f.losses;
    }
    return f.lost ? GLenum(GL_GUILTY_CONTEXT_RESET) : GLenum(GL_NO_ERROR);
}

}  // namespace

void inject_faults(GlApi& gl) {
    const char* variable = std::getenv("KDSCOPE_FAULT");
    const std::string asked = variable ? variable : "";
    Faults& f = faults();
    if (asked != f.asked) f.losses = int(number_of(asked, "lost"));
    f.asked = asked;
    if (asked.empty()) return;
    f.driver = gl;
    f.texels = number_of(asked, "texels");
    f.side = number_of(asked, "side");
    f.memory = number_of(asked, "memory");
    f.storage = number_of(asked, "storage");
    f.draws = 0;
    f.out_of_memory = false;
    f.lost = false;
    gl.GetIntegerv = get_integer;
    gl.BufferData = buffer_data;
    gl.TexStorage2D = texture_storage;
    gl.GetError = get_error;
    gl.DrawArrays = draw_arrays;
    gl.GetInteger64v = get_integer64;
    gl.DispatchCompute = dispatch;
    gl.GetGraphicsResetStatus = reset_status;
}

}  // namespace kd

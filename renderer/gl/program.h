// Linked programs, kept by what they were made from.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "renderer/gl/gl_error.h"
#include "renderer/gl/shader_source.h"

namespace kd {

/// What a program is made from.
struct ProgramKey {
    // Files under shaders/: a vertex and a fragment shader, or a compute shader.
    std::string vertex;
    std::string fragment;
    ShaderDefines defines;
    std::string compute = {};

    auto operator<=>(const ProgramKey&) const = default;
};

/// A linked program. GlError with the driver's log, positions as file and line, where a shader does not compile.
class GlProgram {
  public:
    GlProgram(const GlApi& gl, const ProgramKey& key, const ShaderReader& read);
    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    [[nodiscard]] GLuint id() const { return id_; }

  private:
    const GlApi& gl_;
    GLuint id_;
};

/// At most `most` programs; the one whose use lies farthest back goes first.
class ProgramCache {
  public:
    /// Frames use up to twenty at a time; the rest are those that a person went away from and may come back to.
    static constexpr std::size_t usual_size = 64;

    explicit ProgramCache(const GlApi& gl, ShaderReader read = default_shader_reader(), std::size_t most = usual_size)
        : gl_(gl), read_(std::move(read)), most_(most) {}

    /// The program, compiled and linked where it is not there. It stays for the next `most` - 1 that are asked for.
    [[nodiscard]] const GlProgram& get(const ProgramKey& key);
    [[nodiscard]] std::size_t size() const { return programs_.size(); }
    /// Called before a program is compiled.
    void tell_compiling(std::function<void()> told) { told_ = std::move(told); }

  private:
    struct Entry {
        GlProgram program;
        std::uint64_t used;

        Entry(const GlApi& gl, const ProgramKey& key, const ShaderReader& read, std::uint64_t now)
            : program(gl, key, read), used(now) {}
    };

    void drop_oldest();

    const GlApi& gl_;
    ShaderReader read_;
    std::size_t most_;
    std::uint64_t now_ = 0;
    std::function<void()> told_;
    std::map<ProgramKey, Entry> programs_;
};

}  // namespace kd

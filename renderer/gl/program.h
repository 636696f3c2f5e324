// Linked programs, kept by what they were made from.
#pragma once

#include <map>
#include <string>

#include "renderer/gl/gl_error.h"
#include "renderer/gl/shader_source.h"

namespace kd {

/// What a program is made from.
struct ProgramKey {
    std::string vertex;    // file under shaders/
    std::string fragment;  // file under shaders/
    ShaderDefines defines;

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

class ProgramCache {
  public:
    explicit ProgramCache(const GlApi& gl, ShaderReader read = default_shader_reader())
        : gl_(gl), read_(std::move(read)) {}

    /// The program, compiled and linked when first asked for.
    [[nodiscard]] const GlProgram& get(const ProgramKey& key);
    [[nodiscard]] std::size_t size() const { return programs_.size(); }

  private:
    const GlApi& gl_;
    ShaderReader read_;
    std::map<ProgramKey, GlProgram> programs_;
};

}  // namespace kd

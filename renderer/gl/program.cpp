#include "renderer/gl/program.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <tuple>

#include "renderer/gl/gl_debug.h"

namespace kd {

namespace {

/// A compiled shader, deleted at the end of the scope.
class GlShader {
  public:
    GlShader(const GlApi& gl, GLenum stage) : gl_(gl), id_(gl.CreateShader(stage)) {}
    ~GlShader() { gl_.DeleteShader(id_); }
    GlShader(const GlShader&) = delete;
    GlShader& operator=(const GlShader&) = delete;

    void compile(const std::string& entry, const ShaderSource& source) {
        const char* text = source.text.c_str();
        gl_.ShaderSource(id_, 1, &text, nullptr);
        gl_.CompileShader(id_);
        GLint good = 0;
        gl_.GetShaderiv(id_, GL_COMPILE_STATUS, &good);
        if (!good) throw GlError(fmt::format("shader {} does not compile:\n{}", entry, source.map_log(log())));
    }

    [[nodiscard]] GLuint id() const { return id_; }

  private:
    const GlApi& gl_;
    GLuint id_;

    std::string log() const {
        GLint length = 0;
        gl_.GetShaderiv(id_, GL_INFO_LOG_LENGTH, &length);
        std::string text(static_cast<std::size_t>(length) + 1, '\0');
        gl_.GetShaderInfoLog(id_, length, &length, text.data());
        text.resize(static_cast<std::size_t>(length));
        return text;
    }
};

ShaderSource resolve(const std::string& entry, const ShaderDefines& defines, const ShaderReader& read) {
    try {
        return resolve_shader(entry, defines, read);
    } catch (const ShaderError& error) {
        throw GlError(error.what());
    }
}

std::string link_log(const GlApi& gl, GLuint program) {
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length) + 1, '\0');
    gl.GetProgramInfoLog(program, length, &length, text.data());
    text.resize(static_cast<std::size_t>(length));
    return text;
}

}  // namespace

GlProgram::GlProgram(const GlApi& gl, const ProgramKey& key, const ShaderReader& read) : gl_(gl), id_(0) {
    struct Stage {
        GLenum kind;
        const std::string& entry;
        ShaderSource source = {};
        std::optional<GlShader> shader = {};
    };
    std::array<Stage, 3> stages{
        {{GL_VERTEX_SHADER, key.vertex}, {GL_FRAGMENT_SHADER, key.fragment}, {GL_COMPUTE_SHADER, key.compute}}};
    const Stage* last = nullptr;
    std::string names;
    for (Stage& stage : stages) {
        if (stage.entry.empty()) continue;
        stage.source = resolve(stage.entry, key.defines, read);
        stage.shader.emplace(gl, stage.kind);
        stage.shader->compile(stage.entry, stage.source);
        names += (last ? " and " : "") + stage.entry;
        last = &stage;
    }
    if (!last) throw GlError("OpenGL: a program of no shader");

    id_ = gl.CreateProgram();
    for (const Stage& stage : stages)
        if (stage.shader) gl.AttachShader(id_, stage.shader->id());
    gl.LinkProgram(id_);
    GLint good = 0;
    gl.GetProgramiv(id_, GL_LINK_STATUS, &good);
    if (good) {
        label_object(gl, GL_PROGRAM, id_, last->entry);
        return;
    }
    const std::string log = last->source.map_log(link_log(gl, id_));
    gl.DeleteProgram(id_);
    throw GlError(fmt::format("shaders {} do not link:\n{}", names, log));
}

GlProgram::~GlProgram() { gl_.DeleteProgram(id_); }

const GlProgram& ProgramCache::get(const ProgramKey& key) {
    ++now_;
    if (const auto found = programs_.find(key); found != programs_.end()) {
        found->second.used = now_;
        return found->second.program;
    }
    if (told_) told_();
    const auto made = programs_.emplace(std::piecewise_construct, std::forward_as_tuple(key),
                                        std::forward_as_tuple(gl_, key, read_, now_));
    if (programs_.size() > most_) drop_oldest();
    return made.first->second.program;
}

void ProgramCache::drop_oldest() {
    programs_.erase(std::ranges::min_element(programs_, {}, [](const auto& entry) { return entry.second.used; }));
}

}  // namespace kd

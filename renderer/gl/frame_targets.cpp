#include "renderer/gl/frame_targets.h"

#include <fmt/format.h>

#include "renderer/gl/gl_error.h"

namespace kd {

namespace {

constexpr std::array<float, 4> no_colour{0, 0, 0, 0};
constexpr GLuint no_hit_texel[4] = {~0u, 0, 0, 0};  // triangle -1
constexpr GLuint no_counters[4] = {0, 0, 0, 0};

constexpr GLint index_of(Output output) { return static_cast<GLint>(output); }

}  // namespace

GlTexture make_texture(const GlApi& gl, GLenum format, int width, int height) {
    GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    check_gl(gl, fmt::format("making a texture of {}x{} pixels", width, height));
    return texture;
}

GlFramebuffer make_framebuffer(const GlApi& gl, const std::array<const GlTexture*, output_count>& outputs,
                               GLuint depth) {
    GlFramebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    std::array<GLenum, output_count> buffers{};
    for (unsigned i = 0; i < output_count; ++i) {
        const bool there = outputs[i] && *outputs[i];
        buffers[i] = there ? GL_COLOR_ATTACHMENT0 + i : GL_NONE;
        if (there) gl.FramebufferTexture2D(GL_FRAMEBUFFER, buffers[i], GL_TEXTURE_2D, outputs[i]->id(), 0);
    }
    gl.DrawBuffers(GLsizei(buffers.size()), buffers.data());
    if (depth) gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw GlError(fmt::format("OpenGL: the driver refuses a framebuffer of the passes (0x{:04x})", status));
    return framebuffer;
}

FrameTargets::FrameTargets(const GlApi& gl, const TargetKey& key) : key_(key) {
    colour_ = texture(gl, GL_RGBA32F, 16);
    depth_ = texture(gl, GL_DEPTH_COMPONENT32F, 4);
    LayerTargets& prim = layers_[0];
    LayerTargets& shade = layers_[1];
    prim = make_layer(gl, true);
    shade = make_layer(gl, true);
    framebuffers_[0] = attach(gl, {&prim.counters_a, &prim.counters_b, &prim.hit, nullptr, nullptr});
    framebuffers_[1] = attach(gl, {&shade.counters_a, &shade.counters_b, &shade.hit, &colour_, nullptr});
    if (key.bounces > 0) make_reflection_targets(gl);

    gl.Disable(GL_SCISSOR_TEST);
    constexpr float far = 1.0f;
    clear_framebuffer(gl, framebuffer(Pass::rt_prim), nullptr);
    gl.ClearBufferfv(GL_DEPTH, 0, &far);
    clear(gl, no_colour);
    check_gl(gl, "making the targets of the passes");
}

void FrameTargets::make_reflection_targets(const GlApi& gl) {
    LayerTargets& refl = layers_[2];
    LayerTargets& shade = layers_[3];
    refl = make_layer(gl, key_.bounces > 1);
    shade = make_layer(gl, true);
    if (key_.bounces > 1) earlier_ = make_layer(gl, true);
    for (std::size_t i = 0; i < std::size_t(key_.bounces); ++i) {
        PathTargets& path = paths_[i];
        path.hit = texture(gl, GL_RGBA32UI, 16);
        path.direction = texture(gl, GL_RGBA32F, 16);
        path.weight = texture(gl, GL_RGBA32F, 16);
        bounces_[i] = attach(gl, {&refl.counters_a, &refl.counters_b, &path.hit, &path.direction, &path.weight});
    }
    framebuffers_[3] = attach(gl, {&shade.counters_a, &shade.counters_b, &shade.hit, &colour_, nullptr});
}

GlTexture FrameTargets::texture(const GlApi& gl, GLenum format, int bytes_per_texel) {
    bytes_ += std::int64_t(key_.width) * key_.height * bytes_per_texel;
    return make_texture(gl, format, key_.width, key_.height);
}

LayerTargets FrameTargets::make_layer(const GlApi& gl, bool with_hit) {
    LayerTargets layer;
    if (with_hit) layer.hit = texture(gl, GL_RGBA32UI, 16);
    if (key_.counters) {
        layer.counters_a = texture(gl, GL_RGBA32UI, 16);
        layer.counters_b = texture(gl, GL_RGBA32UI, 16);
    }
    return layer;
}

GlFramebuffer FrameTargets::attach(const GlApi& gl, const std::array<const GlTexture*, output_count>& outputs) const {
    return make_framebuffer(gl, outputs, depth_.id());
}

GLuint FrameTargets::first_reflection_hit() const {
    return key_.bounces > 1 ? layers_[2].hit.id() : paths_[0].hit.id();
}

void FrameTargets::clear_framebuffer(const GlApi& gl, GLuint framebuffer, const float* colour) const {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (key_.counters) {
        gl.ClearBufferuiv(GL_COLOR, index_of(Output::counters_a), no_counters);
        gl.ClearBufferuiv(GL_COLOR, index_of(Output::counters_b), no_counters);
    }
    gl.ClearBufferuiv(GL_COLOR, index_of(Output::hit), no_hit_texel);
    if (colour) gl.ClearBufferfv(GL_COLOR, index_of(Output::colour), colour);
}

void FrameTargets::clear(const GlApi& gl, const std::array<float, 4>& background) const {
    clear_framebuffer(gl, framebuffer(Pass::shade_prim), background.data());
    if (key_.bounces == 0) return;
    for (int bounce = 0; bounce < key_.bounces; ++bounce) {
        clear_framebuffer(gl, bounce_framebuffer(bounce), no_colour.data());
        gl.ClearBufferfv(GL_COLOR, index_of(Output::weight), no_colour.data());
    }
    clear_framebuffer(gl, framebuffer(Pass::shade_refl), background.data());
}

}  // namespace kd

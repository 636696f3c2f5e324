#include "renderer/gl/frame_targets.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/gl/gl_debug.h"
#include "renderer/gl/gl_error.h"

namespace kd {

namespace {

constexpr std::array<float, 4> no_colour{0, 0, 0, 0};
constexpr GLuint no_hit_texel[4] = {~0u, 0, 0, 0};  // triangle -1
constexpr GLuint no_counters[4] = {0, 0, 0, 0};

std::string name_of(Pass pass) { return std::string(pass_names[static_cast<std::size_t>(pass)]); }

constexpr GLint index_of(Output output) { return static_cast<GLint>(output); }

}  // namespace

GlTexture make_texture(const GlApi& gl, GLenum format, int width, int height, std::string_view name) {
    GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    label_object(gl, GL_TEXTURE, texture.id(), name);
    gl.TexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    check_gl(gl, fmt::format("making a texture of {}x{} pixels", width, height));
    return texture;
}

GlFramebuffer make_framebuffer(const GlApi& gl, const std::array<const GlTexture*, output_count>& outputs, GLuint depth,
                               std::string_view name) {
    GlFramebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    label_object(gl, GL_FRAMEBUFFER, framebuffer.id(), name);
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
        throw GlError(fmt::format("OpenGL: the driver refuses the framebuffer of {} (0x{:04x})", name, status));
    return framebuffer;
}

TargetKey target_key(const SceneNeeds& needs, int width, int height) {
    return {width, height, needs.counters, needs.shadows, std::min(needs.bounces, 2)};
}

std::int64_t target_bytes(const TargetKey& key) {
    constexpr std::int64_t texel = 16, depth = 4;
    const std::int64_t counters = key.counters ? 2 * texel : 0;
    const std::int64_t shadows = key.shadows ? texel + counters : 0;
    std::int64_t pixel = texel + depth + texel + counters + shadows;
    if (key.bounces > 0) pixel += counters + shadows + 3 * texel * key.bounces;
    if (key.bounces > 1) pixel += texel + counters + (key.shadows ? texel : 0);  // the first hit; the earlier layer
    return pixel * key.width * key.height;
}

FrameTargets::FrameTargets(const GlApi& gl, const TargetKey& key) : key_(key) {
    colour_ = texture(gl, GL_RGBA32F, 16, "colour");
    depth_ = texture(gl, GL_DEPTH_COMPONENT32F, 4, "depth");
    LayerTargets& prim = layers_[0];
    LayerTargets& shade = layers_[1];
    prim = make_layer(gl, true, name_of(Pass::rt_prim));
    shade = make_shadow_layer(gl, Pass::shade_prim);
    framebuffers_[0] =
        attach(gl, {&prim.counters_a, &prim.counters_b, &prim.hit, nullptr, nullptr}, name_of(Pass::rt_prim));
    framebuffers_[1] =
        attach(gl, {&shade.counters_a, &shade.counters_b, &shade.hit, &colour_, nullptr}, name_of(Pass::shade_prim));
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
    refl = make_layer(gl, key_.bounces > 1, name_of(Pass::rt_refl));
    shade = make_shadow_layer(gl, Pass::shade_refl);
    if (key_.bounces > 1) earlier_ = make_layer(gl, key_.shadows, "earlier bounces");
    for (std::size_t i = 0; i < std::size_t(key_.bounces); ++i) {
        PathTargets& path = paths_[i];
        path.hit = texture(gl, GL_RGBA32UI, 16, "path hit");
        path.direction = texture(gl, GL_RGBA32F, 16, "path direction");
        path.weight = texture(gl, GL_RGBA32F, 16, "path weight");
        bounces_[i] = attach(gl, {&refl.counters_a, &refl.counters_b, &path.hit, &path.direction, &path.weight},
                             name_of(Pass::rt_refl));
    }
    framebuffers_[3] =
        attach(gl, {&shade.counters_a, &shade.counters_b, &shade.hit, &colour_, nullptr}, name_of(Pass::shade_refl));
}

GlTexture FrameTargets::texture(const GlApi& gl, GLenum format, int bytes_per_texel, const std::string& name) {
    bytes_ += std::int64_t(key_.width) * key_.height * bytes_per_texel;
    return make_texture(gl, format, key_.width, key_.height, name);
}

LayerTargets FrameTargets::make_layer(const GlApi& gl, bool with_hit, const std::string& name) {
    LayerTargets layer;
    if (with_hit) layer.hit = texture(gl, GL_RGBA32UI, 16, name + " hit");
    if (key_.counters) {
        layer.counters_a = texture(gl, GL_RGBA32UI, 16, name + " counters a");
        layer.counters_b = texture(gl, GL_RGBA32UI, 16, name + " counters b");
    }
    return layer;
}

LayerTargets FrameTargets::make_shadow_layer(const GlApi& gl, Pass pass) {
    return key_.shadows ? make_layer(gl, true, name_of(pass)) : LayerTargets{};
}

GlFramebuffer FrameTargets::attach(const GlApi& gl, const std::array<const GlTexture*, output_count>& outputs,
                                   std::string_view name) const {
    return make_framebuffer(gl, outputs, depth_.id(), name);
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

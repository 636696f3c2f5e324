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
    return {width, height, needs.counters, needs.shadows, std::min(needs.bounces, 2), needs.indirect};
}

std::int64_t target_bytes(const TargetKey& key) {
    constexpr std::int64_t texel = 16, depth = 4;
    const std::int64_t counters = key.counters ? 2 * texel : 0;
    const std::int64_t shadows = key.shadows ? texel + counters : 0;
    std::int64_t pixel = texel + depth + texel + counters + shadows;
    if (key.bounces > 0) pixel += counters + shadows + 3 * texel * key.bounces;
    if (key.bounces > 1) pixel += texel + counters + (key.shadows ? texel : 0);  // the first hit; the earlier layer
    if (key.indirect) pixel += counters + shadows + 3 * texel;
    return pixel * key.width * key.height;
}

FrameTargets::FrameTargets(const GlApi& gl, const TargetKey& key) : key_(key) {
    colour_ = texture(gl, GL_RGBA32F, 16, "colour");
    depth_ = texture(gl, GL_DEPTH_COMPONENT32F, 4, "depth");
    LayerTargets& prim = layer_of(Pass::rt_prim);
    prim = make_layer(gl, true, name_of(Pass::rt_prim));
    layer_of(Pass::shade_prim) = make_shadow_layer(gl, Pass::shade_prim);
    framebuffers_[0] =
        attach(gl, {&prim.counters_a, &prim.counters_b, &prim.hit, nullptr, nullptr}, name_of(Pass::rt_prim));
    framebuffers_[1] = attach_shading(gl, Pass::shade_prim);
    if (key.bounces > 0) make_reflection_targets(gl);
    if (key.indirect) make_indirect_targets(gl);

    gl.Disable(GL_SCISSOR_TEST);
    constexpr float far = 1.0f;
    clear_framebuffer(gl, framebuffer(Pass::rt_prim), nullptr);
    gl.ClearBufferfv(GL_DEPTH, 0, &far);
    clear(gl, no_colour);
    check_gl(gl, "making the targets of the passes");
}

PathTargets FrameTargets::make_path(const GlApi& gl) {
    return {texture(gl, GL_RGBA32UI, 16, "path hit"), texture(gl, GL_RGBA32F, 16, "path direction"),
            texture(gl, GL_RGBA32F, 16, "path weight")};
}

void FrameTargets::make_reflection_targets(const GlApi& gl) {
    layer_of(Pass::rt_refl) = make_layer(gl, key_.bounces > 1, name_of(Pass::rt_refl));
    layer_of(Pass::shade_refl) = make_shadow_layer(gl, Pass::shade_refl);
    if (key_.bounces > 1) earlier_ = make_layer(gl, key_.shadows, "earlier bounces");
    for (std::size_t i = 0; i < std::size_t(key_.bounces); ++i) {
        paths_[i] = make_path(gl);
        bounces_[i] = attach_path(gl, Pass::rt_refl, paths_[i]);
    }
    framebuffers_[3] = attach_shading(gl, Pass::shade_refl);
}

void FrameTargets::make_indirect_targets(const GlApi& gl) {
    layer_of(Pass::rt_indirect) = make_layer(gl, false, name_of(Pass::rt_indirect));
    layer_of(Pass::shade_indirect) = make_shadow_layer(gl, Pass::shade_indirect);
    indirect_path_ = make_path(gl);
    framebuffers_[4] = attach_path(gl, Pass::rt_indirect, indirect_path_);
    framebuffers_[5] = attach_shading(gl, Pass::shade_indirect);
}

GlFramebuffer FrameTargets::attach_path(const GlApi& gl, Pass pass, const PathTargets& path) const {
    const LayerTargets& counted = layer(pass);
    return attach(gl, {&counted.counters_a, &counted.counters_b, &path.hit, &path.direction, &path.weight},
                  name_of(pass));
}

GlFramebuffer FrameTargets::attach_shading(const GlApi& gl, Pass pass) const {
    const LayerTargets& shadows = layer(pass);
    return attach(gl, {&shadows.counters_a, &shadows.counters_b, &shadows.hit, &colour_, nullptr}, name_of(pass));
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

GLuint FrameTargets::hits(Pass pass) const {
    if (pass == Pass::rt_indirect) return indirect_path_.hit.id();
    if (pass == Pass::rt_refl && key_.bounces == 1) return paths_[0].hit.id();
    return layer(pass).hit.id();
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
    const auto clear_path = [&](GLuint framebuffer_of_path) {
        clear_framebuffer(gl, framebuffer_of_path, no_colour.data());
        gl.ClearBufferfv(GL_COLOR, index_of(Output::weight), no_colour.data());
    };
    clear_framebuffer(gl, framebuffer(Pass::shade_prim), background.data());
    for (int bounce = 0; bounce < key_.bounces; ++bounce) clear_path(bounce_framebuffer(bounce));
    if (key_.bounces > 0) clear_framebuffer(gl, framebuffer(Pass::shade_refl), background.data());
    if (!key_.indirect) return;
    clear_path(framebuffer(Pass::rt_indirect));
    clear_framebuffer(gl, framebuffer(Pass::shade_indirect), background.data());
}

}  // namespace kd

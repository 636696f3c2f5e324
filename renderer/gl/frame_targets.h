// The textures that passes draw into and read from each other.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "renderer/gl/bindings.h"
#include "renderer/gl/object.h"
#include "renderer/scene/needs.h"
#include "renderer/trace/frame.h"

namespace kd {

/// What the targets are made for.
struct TargetKey {
    int width = 0, height = 0;
    bool counters = true;
    bool shadows = true;  // hit and counters of shadow rays
    int bounces = 0;      // 0, 1, or 2 for more
    bool indirect = false;

    bool operator==(const TargetKey&) const = default;
};

[[nodiscard]] TargetKey target_key(const SceneNeeds& needs, int width, int height);

/// What such targets take, known before they are made.
[[nodiscard]] std::int64_t target_bytes(const TargetKey& key);

/// Hit and counters of one pass's rays; those of a shading pass only where it traces shadow rays.
struct LayerTargets {
    GlTexture hit, counters_a, counters_b;
};

/// The path after a bounce: what RTRefl leaves for ShadeRefl and for the next RTRefl, RTIndirect for ShadeIndirect.
struct PathTargets {
    GlTexture hit, direction, weight;
};

/// All are made "untraced": colour with alpha 0, hits -1, counters and weights 0, depth 1.
class FrameTargets {
  public:
    FrameTargets() = default;
    FrameTargets(const GlApi& gl, const TargetKey& key);

    [[nodiscard]] const TargetKey& key() const { return key_; }
    [[nodiscard]] std::int64_t bytes() const { return bytes_; }

    /// Of a pass other than RTRefl.
    [[nodiscard]] GLuint framebuffer(Pass pass) const { return framebuffers_[static_cast<std::size_t>(pass)].id(); }
    /// RTRefl of a bounce, 0 first: it draws into path(bounce).
    [[nodiscard]] GLuint bounce_framebuffer(int bounce) const { return bounces_[std::size_t(bounce % 2)].id(); }
    [[nodiscard]] const PathTargets& path(int bounce) const { return paths_[std::size_t(bounce % 2)]; }
    [[nodiscard]] const PathTargets& indirect_path() const { return indirect_path_; }
    [[nodiscard]] const LayerTargets& layer(Pass pass) const { return layers_[static_cast<std::size_t>(pass)]; }
    /// Copies of a layer as it was before a later bounce.
    [[nodiscard]] const LayerTargets& earlier() const { return earlier_; }
    [[nodiscard]] GLuint colour() const { return colour_.id(); }
    /// What the rays of a pass hit; of RTRefl, those of the first bounce.
    [[nodiscard]] GLuint hits(Pass pass) const;

    /// Before drawing: sets the scissored part to untraced, and its colour to `background`. RTPrim's own targets and
    /// depth stay: it draws every pixel.
    void clear(const GlApi& gl, const std::array<float, 4>& background) const;

  private:
    TargetKey key_;
    std::int64_t bytes_ = 0;
    GlTexture colour_, depth_;
    std::array<LayerTargets, pass_count> layers_;
    std::array<PathTargets, 2> paths_;
    PathTargets indirect_path_;
    LayerTargets earlier_;
    std::array<GlFramebuffer, pass_count> framebuffers_;
    std::array<GlFramebuffer, 2> bounces_;

    GlTexture texture(const GlApi& gl, GLenum format, int bytes_per_texel, const std::string& name);
    LayerTargets make_layer(const GlApi& gl, bool with_hit, const std::string& name);
    LayerTargets make_shadow_layer(const GlApi& gl, Pass pass);
    LayerTargets& layer_of(Pass pass) { return layers_[static_cast<std::size_t>(pass)]; }
    PathTargets make_path(const GlApi& gl);
    void make_reflection_targets(const GlApi& gl);
    void make_indirect_targets(const GlApi& gl);
    GlFramebuffer attach_path(const GlApi& gl, Pass pass, const PathTargets& path) const;
    GlFramebuffer attach_shading(const GlApi& gl, Pass pass) const;
    GlFramebuffer attach(const GlApi& gl, const std::array<const GlTexture*, output_count>& outputs,
                         std::string_view name) const;
    void clear_framebuffer(const GlApi& gl, GLuint framebuffer, const float* colour) const;
};

/// A texture with one level and no filtering.
[[nodiscard]] GlTexture make_texture(const GlApi& gl, GLenum format, int width, int height, std::string_view name);

/// A framebuffer of these textures (null or empty = none) and depth; GlError where the driver refuses it.
[[nodiscard]] GlFramebuffer make_framebuffer(const GlApi& gl, const std::array<const GlTexture*, output_count>& outputs,
                                             GLuint depth, std::string_view name);

}  // namespace kd

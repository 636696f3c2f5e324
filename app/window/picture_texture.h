// The finished picture as a texture for Dear ImGui.
#pragma once

#include <imgui.h>

#include "renderer/geometry/image.h"
#include "renderer/gl/gl_api.h"

namespace kd {

/// An 8-bit image on the GPU, uploaded when it changes. Needs the window's context current.
class PictureTexture {
  public:
    explicit PictureTexture(const GlApi& gl) : gl_(gl) {}
    ~PictureTexture();
    PictureTexture(const PictureTexture&) = delete;
    PictureTexture& operator=(const PictureTexture&) = delete;

    /// `smooth` mixes neighbours where the image is drawn larger than it is.
    void upload(const Image<Rgba8>& image, bool smooth);
    [[nodiscard]] ImTextureID id() const;
    [[nodiscard]] bool empty() const { return width_ == 0; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

  private:
    const GlApi& gl_;
    unsigned texture_ = 0;
    int width_ = 0, height_ = 0;
};

}  // namespace kd

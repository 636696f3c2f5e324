#include "app/window/picture_texture.h"

#include <cstdint>

namespace kd {

PictureTexture::~PictureTexture() {
    if (texture_) gl_.DeleteTextures(1, &texture_);
}

void PictureTexture::upload(const Image<Rgba8>& image, bool smooth) {
    if (!texture_) gl_.GenTextures(1, &texture_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const bool same_size = image.width == width_ && image.height == height_;
    width_ = image.width;
    height_ = image.height;
    if (image.empty()) return;
    if (same_size) {
        gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    } else {
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    }
}

ImTextureID PictureTexture::id() const { return reinterpret_cast<ImTextureID>(std::uintptr_t(texture_)); }

}  // namespace kd

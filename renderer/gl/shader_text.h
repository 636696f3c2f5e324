#pragma once

#include <span>
#include <string_view>

namespace kd {

/// A file under shaders/, as it was when the program was built.
struct ShaderFile {
    std::string_view path;  ///< relative to shaders/, for example "shared/kernel.glsl"
    std::string_view text;  ///< the whole file
};

/// All files under shaders/, sorted by path.
std::span<const ShaderFile> shader_files();

}  // namespace kd

// Shader text: #include resolved, settings put in front, and a table that leads from its lines back to the files. No
// GL.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace kd {

/// A shader file that is missing, includes itself, or has an include that cannot be read; what() names file and line.
struct ShaderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// #define NAME VALUE, in front of the text.
using ShaderDefines = std::map<std::string, std::string>;

/// The text of a file under shaders/ ("shared/box.glsl"), nothing where there is none.
using ShaderReader = std::function<std::optional<std::string>(const std::string& path)>;

/// Reads the files built into the program, or those in the folder that the environment variable KD_SHADER_DIR names.
[[nodiscard]] ShaderReader default_shader_reader();

/// One shader as the driver gets it.
struct ShaderSource {
    struct Origin {
        std::size_t file;  // index into `files`
        int line;          // from 1
    };
    std::string text;
    std::vector<std::string> files;  // files[0] stands for the lines put in front
    std::vector<Origin> lines;       // lines[i] is where line i + 1 of `text` comes from

    /// "shaders/shared/box.glsl:12" for a line of `text`, counted from 1.
    [[nodiscard]] std::string locate(int line) const;

    /// A driver's log with its positions ("0:123(4):" Mesa, "0(123) :" NVIDIA, "0:123:" others) replaced by file and
    /// line.
    [[nodiscard]] std::string map_log(std::string_view log) const;
};

/// `entry` with its includes. A name is looked up beside the including file, then from shaders/. ShaderError where a
/// file is missing or includes itself.
[[nodiscard]] ShaderSource resolve_shader(const std::string& entry, const ShaderDefines& defines,
                                          const ShaderReader& read = default_shader_reader());

}  // namespace kd

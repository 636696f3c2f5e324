// Looking at output paths before the work, so that hours of it are not lost on a typing error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kd {

/// A file that a command is going to write. An empty path is good: nothing will be written.
struct OutputFile {
    std::string_view option;  // that named it, for errors
    std::string path;
    std::string_view extension = {};  // that it must have, ".png"
};

/// A file that a command reads, and must not write over.
struct InputFile {
    std::string_view what;  // "the scene's own file"
    std::string path;       // may be no file at all
};

/// InputError where the program's standard output is closed, or a device that takes nothing.
void check_standard_output();

/// A scene's name as a part of file names: "ball-9000" of "ball:9000", "lantern" of "assets/scenes/lantern.gltf".
[[nodiscard]] std::string file_stem(const std::string& scene);

/// Makes the folder and those above it where they are missing. InputError naming the option.
void make_output_folder(std::string_view option, const std::string& folder);

/// InputError naming the option where a file cannot be written, is one of `inputs`, or is written twice. Tries each
/// folder by writing a small file in it and removing that again; what stands there already is left alone.
void check_outputs(const std::vector<OutputFile>& outputs, const std::vector<InputFile>& inputs);

}  // namespace kd

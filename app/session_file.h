// Session files: everything that a person has chosen, as JSON, to be opened again (docs/session.md).
#pragma once

#include <filesystem>
#include <string>

#include "app/session.h"

namespace kd {

/// Of the files that the window writes; any name that ends in ".json" can be opened.
inline constexpr const char* session_extension = ".session.json";

/// True where `name` reads like a session file rather than a scene.
[[nodiscard]] bool names_session(const std::string& name);

/// The session of a file, its camera in scene units. A relative scene file is looked for in the folder of `path`.
/// InputError naming file, place in it and what would be right.
[[nodiscard]] Session read_session(const std::filesystem::path& path);

/// The same of a file's text, which `path` is the place of.
[[nodiscard]] Session parse_session(const std::string& text, const std::filesystem::path& path);

/// What is wrong with the scene of session file `file`, with its place there.
[[nodiscard]] std::string scene_fault(const std::string& file, const std::string& why);

/// Writes a session whose camera is in scene units. A scene file below the folder of `path` is named relative to it,
/// any other by its absolute path. InputError.
void write_session(const std::filesystem::path& path, const Session& session);

/// The text that it writes.
[[nodiscard]] std::string session_text(const std::filesystem::path& path, const Session& session);

}  // namespace kd

// The URIs of a glTF file: data in the file itself, or files beside it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace kd {

[[nodiscard]] bool is_data_uri(std::string_view uri);

/// Bytes that a base64 data URI of a kind that tinygltf decodes holds; nothing for any other URI.
[[nodiscard]] std::optional<std::uint64_t> data_uri_size(std::string_view uri);

/// %20 and its like decoded. With `plus_is_space`, as tinygltf does it, '+' becomes a space.
[[nodiscard]] std::string decode_uri(std::string_view uri, bool plus_is_space = false);

/// Why a decoded URI must not be opened: it is no plain relative path, or leads out of `folder` (by .. or through a
/// symbolic link). Nothing where it may be; whether there is such a file is another question.
[[nodiscard]] std::optional<std::string> uri_objection(const std::filesystem::path& folder, const std::string& decoded);

}  // namespace kd

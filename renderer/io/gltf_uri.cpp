#include "renderer/io/gltf_uri.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace kd {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 7> data_headers{"data:application/octet-stream;base64,",
                                                       "data:application/gltf-buffer;base64,",
                                                       "data:image/png;base64,",
                                                       "data:image/jpeg;base64,",
                                                       "data:image/bmp;base64,",
                                                       "data:image/gif;base64,",
                                                       "data:text/plain;base64,"};

bool is_base64_digit(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/';
}

/// Value of a hexadecimal digit, -1 for anything else.
int hex_value(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// "http:" and its like, at least two letters: "C:" is an absolute path, and refused as such.
bool has_scheme(const std::string& uri) {
    const std::size_t colon = uri.find(':');
    return colon != std::string::npos && colon > 0 && std::isalpha(static_cast<unsigned char>(uri.front())) &&
           std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
               return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
           });
}

bool is_inside(const fs::path& folder, const fs::path& path) {
    const auto [end_of_folder, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end_of_folder == folder.end() && rest != path.end();
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

std::optional<std::uint64_t> data_uri_size(std::string_view uri) {
    const auto header = std::ranges::find_if(data_headers, [&](std::string_view h) { return uri.starts_with(h); });
    if (header == data_headers.end()) return std::nullopt;
    std::string_view digits = uri.substr(header->size());
    for (int i = 0; i < 2 && digits.ends_with('='); ++i) digits.remove_suffix(1);
    if (!std::ranges::all_of(digits, is_base64_digit) || digits.size() % 4 == 1) return std::nullopt;
    return std::uint64_t(digits.size()) * 3 / 4;
}

std::string decode_uri(std::string_view uri, bool plus_is_space) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_value(uri[i + 1]) : -1;
        const int low = high >= 0 ? hex_value(uri[i + 2]) : -1;
        if (low >= 0) {
            decoded += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            decoded += uri[i] == '+' && plus_is_space ? ' ' : uri[i];
        }
    }
    return decoded;
}

std::optional<std::string> uri_objection(const fs::path& folder, const std::string& decoded) {
    if (decoded.empty()) return "empty";
    if (decoded.find('\0') != std::string::npos) return "holds a NUL character";
    if (decoded.find('\\') != std::string::npos) return "holds a backslash; separate folders by /";
    if (has_scheme(decoded)) return "not a file beside the scene, and nothing is fetched from elsewhere";
    const fs::path path(decoded);
    if (path.is_absolute()) return "an absolute path; only files in the scene's folder are read";
    if (std::ranges::find(path, fs::path("..")) != path.end()) {
        return "leads out of the scene's folder; only files in it are read";
    }
    // Symbolic links are followed to where they end, which must still be in the folder.
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder, error);
    if (error) return "the scene's folder cannot be looked at";
    const fs::path target = fs::weakly_canonical(folder / path, error);
    if (error) return "cannot be looked at: " + error.message();
    if (!is_inside(root, target)) return "leads out of the scene's folder through a symbolic link";
    return std::nullopt;
}

}  // namespace kd

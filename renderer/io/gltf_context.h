// What every part of the glTF loader shares: how it fails, and what it tells about what it left out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/io/gltf_limits.h"

namespace kd {

class GltfContext {
  public:
    /// `file` as errors name it.
    explicit GltfContext(std::string file, const GltfLimits& limits = {});

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] const GltfLimits& limits() const { return limits_; }

    /// Throws InputError "file: pointer: reason". `pointer` is a JSON pointer (RFC 6901), empty for the whole file.
    [[noreturn]] void fail(std::string_view pointer, std::string_view reason) const;

    /// Adds a note, once however often it is made; beyond limits().notes different ones it is only counted.
    void note(std::string_view text);
    /// Counts things of one kind into one note: count("skipped", "primitive", " of points") gives "skipped 3 primitives
    /// of points".
    void count(std::string_view verb, std::string_view noun, std::string_view what = "", std::uint64_t number = 1);
    /// All notes, in the order in which each was first made.
    [[nodiscard]] std::vector<std::string> notes() const;

  private:
    struct Entry {
        std::string before, after;  // around the number
        std::uint64_t number;       // 0: no number, `before` is all
        bool operator==(const Entry&) const = default;
    };
    std::string file_;
    GltfLimits limits_;
    std::vector<Entry> entries_;
    std::uint64_t untold_ = 0;
};

/// "/a/b" + 3 -> "/a/b/3"
[[nodiscard]] std::string pointer_to(std::string_view parent, std::size_t index);
/// "/a" + "b" -> "/a/b", escaped as RFC 6901 says and fit for one line.
[[nodiscard]] std::string pointer_to(std::string_view parent, std::string_view key);

}  // namespace kd

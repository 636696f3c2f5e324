// What the fuzz targets check beside what sanitizers do.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace kd::fuzz {

inline void promise(bool kept, const std::string& what) {
    if (!kept) throw std::logic_error("broken promise: " + what);
}

/// Text for people: one line, no control characters.
inline void promise_one_line(std::string_view text) {
    promise(!text.empty() && text.size() < 10'000, "messages have a length");
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        promise(byte >= 0x20 && byte != 0x7f, "messages are one line of printable text: " + std::string(text));
    }
}

}  // namespace kd::fuzz

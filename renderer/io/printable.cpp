#include "renderer/io/printable.h"

#include <algorithm>

namespace kd {

namespace {

unsigned byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// Bytes of the UTF-8 sequence at `i`; 0 where there is none (cut off, a stray byte, or a longer form than needed).
std::size_t sequence_length(std::string_view text, std::size_t i) {
    const unsigned first = byte_at(text, i);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    if (length == 0 || length > text.size() - i) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte_at(text, i + k) & 0xc0) != 0x80) return 0;
    const unsigned second = byte_at(text, i + 1);
    if ((first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90)) return 0;
    return length;
}

/// C0 and C1 controls and DEL. C1 is U+0080 to U+009F, the bytes C2 80 to C2 9F; terminals obey those too.
bool is_control(std::string_view sequence) {
    const unsigned first = byte_at(sequence, 0);
    return first < 0x20 || first == 0x7f || (first == 0xc2 && byte_at(sequence, 1) < 0xa0);
}

}  // namespace

std::string printable(std::string_view text, std::size_t limit) {
    std::string line;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = sequence_length(text, i);
        const std::string_view sequence = text.substr(i, std::max<std::size_t>(length, 1));
        if (i + sequence.size() > limit) return line + "...";
        line += length == 0 || is_control(sequence) ? "?" : sequence;
        i += sequence.size();
    }
    return line;
}

}  // namespace kd

#include "renderer/io/printable.h"

namespace kd {

std::string printable(std::string_view text, std::size_t limit) {
    std::string line(text.substr(0, limit));
    if (text.size() > limit) {
        // Cut before a UTF-8 sequence that did not fit, not inside it.
        while (!line.empty() && (static_cast<unsigned char>(text[line.size()]) & 0xc0) == 0x80) line.pop_back();
        line += "...";
    }
    // The C1 controls U+0080..U+009F are the bytes C2 80 .. C2 9F; terminals obey them too.
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto c = static_cast<unsigned char>(line[i]);
        const bool c1 = c == 0xc2 && i + 1 < line.size() && static_cast<unsigned char>(line[i + 1]) < 0xa0;
        if (c < 0x20 || c == 0x7f) line[i] = '?';
        if (c1) line.replace(i, 2, "?");
    }
    return line;
}

}  // namespace kd

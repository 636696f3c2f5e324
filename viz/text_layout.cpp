#include <algorithm>
#include <functional>

#include "viz/text.h"

namespace kd {
namespace {

/// Bytes of the sequence that starts with `lead`; 0 where none can.
std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xc2 && lead < 0xe0) return 2;
    if (lead >= 0xe0 && lead < 0xf0) return 3;
    if (lead >= 0xf0 && lead < 0xf5) return 4;
    return 0;
}

bool is_scalar(char32_t code, std::size_t length) {
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    return code >= least[length] && code <= 0x10ffff && !(code >= 0xd800 && code <= 0xdfff);
}

/// The code point at `text[i]`, moving i past it, or past one byte where there is none.
char32_t next_code(std::string_view text, std::size_t& i) {
    constexpr char32_t replacement = U'\ufffd';
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = sequence_length(lead);
    if (length == 0 || i + length > text.size()) {
        ++i;
        return replacement;
    }
    char32_t code = length == 1 ? lead : lead & (0x7fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
        const auto byte = static_cast<unsigned char>(text[i + k]);
        if ((byte & 0xc0) != 0x80) {
            ++i;
            return replacement;
        }
        code = code << 6 | (byte & 0x3fu);
    }
    i += is_scalar(code, length) ? length : 1;
    return is_scalar(code, length) ? code : replacement;
}

using Fits = std::function<bool(std::string_view)>;

/// Longest start of `text` that fits, at least one character; in bytes.
std::size_t fitting_prefix(std::string_view text, const Fits& fits) {
    std::size_t end = 0;
    next_code(text, end);
    while (end < text.size()) {
        std::size_t longer = end;
        next_code(text, longer);
        if (!fits(text.substr(0, longer))) break;
        end = longer;
    }
    return end;
}

/// Adds the words of one paragraph to `lines`.
void wrap_paragraph(std::string_view text, const Fits& fits, std::vector<std::string>& lines) {
    std::string line;
    while (!text.empty()) {
        const std::size_t space = std::min(text.find(' '), text.size());
        std::string_view word = text.substr(0, space);
        text.remove_prefix(std::min(space + 1, text.size()));
        if (!line.empty() && fits(line + ' ' + std::string(word))) {
            line += ' ' + std::string(word);
            continue;
        }
        if (!line.empty()) lines.push_back(line);
        while (!fits(word)) {
            const std::size_t length = fitting_prefix(word, fits);
            if (length == word.size()) break;
            lines.emplace_back(word.substr(0, length));
            word.remove_prefix(length);
        }
        line = word;
    }
    lines.push_back(line);
}

}  // namespace

std::u32string decode_utf8(std::string_view text) {
    std::u32string codes;
    for (std::size_t i = 0; i < text.size();) codes += next_code(text, i);
    return codes;
}

std::vector<std::string> wrap_text(const Font& font, std::string_view text, float size, int width) {
    return wrap_text(text, [&](std::string_view line) { return font.width(line, size) <= float(width); });
}

std::vector<std::string> wrap_text(std::string_view text, std::size_t most_letters) {
    return wrap_text(text, [&](std::string_view line) { return decode_utf8(line).size() <= most_letters; });
}

std::vector<std::string> wrap_text(std::string_view text, const Fits& fits) {
    std::vector<std::string> lines;
    if (text.empty()) return lines;
    while (true) {
        const std::size_t end = text.find('\n');
        wrap_paragraph(text.substr(0, end), fits, lines);
        if (end == std::string_view::npos) return lines;
        text.remove_prefix(end + 1);
    }
}

}  // namespace kd

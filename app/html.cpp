#include "app/html.h"

#include "renderer/io/printable.h"

namespace kd {

std::string html_text(std::string_view text) {
    constexpr std::size_t longest = 2000;
    std::string safe;
    for (const char c : printable(text, longest)) {
        switch (c) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            default: safe += c;
        }
    }
    return safe;
}

}  // namespace kd

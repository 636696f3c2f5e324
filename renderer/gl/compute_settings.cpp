#include "renderer/gl/compute_settings.h"

#include <bit>
#include <charconv>
#include <cstdlib>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

constexpr int most_pixels = 1024;
constexpr int most_groups = 65535;

[[noreturn]] void refuse(std::string_view text, std::string_view why) {
    throw InputError(
        fmt::format("KDSCOPE_COMPUTE '{}': {}; say 16x8, 16x16,linear or 8x4,persistent:1056,storage", text, why));
}

/// All of `digits` as a number from 1 to `most`.
int number(std::string_view text, std::string_view digits, int most) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < 1 || value > most)
        refuse(text, fmt::format("'{}' is no number from 1 to {}", digits, most));
    return value;
}

/// What stands before the next comma; takes it off.
std::string_view next_word(std::string_view& rest) {
    const std::string_view word = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    return word;
}

void take_word(std::string_view text, std::string_view word, ComputeSettings& group) {
    constexpr std::string_view persistent = "persistent:";
    if (word == "linear")
        group.morton = false;
    else if (word == "storage" || word == "textures")
        group.storage = word == "storage";
    else if (word == "lists" || word == "no-lists")
        group.lists = word == "lists";
    else if (word == "dealt" || word == "in-order")
        group.dealt = word == "dealt";
    else if (word.starts_with(persistent))
        group.persistent = number(text, word.substr(persistent.size()), most_groups);
    else
        refuse(text, fmt::format("'{}' is unknown", word));
}

}  // namespace

ComputeSettings parse_compute_settings(std::string_view text) {
    std::string_view rest = text;
    const std::string_view size = next_word(rest);
    const std::size_t cross = size.find('x');
    if (cross == std::string_view::npos) refuse(text, "it begins with no size");
    ComputeSettings group;
    group.x = number(text, size.substr(0, cross), most_pixels);
    group.y = number(text, size.substr(cross + 1), most_pixels);
    if (group.x * group.y > most_pixels) refuse(text, fmt::format("a group has at most {} pixels", most_pixels));
    const bool square = group.x == group.y || group.x == 2 * group.y;
    group.morton = square && std::has_single_bit(unsigned(group.x));
    while (!rest.empty()) take_word(text, next_word(rest), group);
    return group;
}

ComputeSettings compute_settings_in_force() {
    const char* said = std::getenv("KDSCOPE_COMPUTE");
    return said && *said ? parse_compute_settings(said) : ComputeSettings{};
}

}  // namespace kd

#include "renderer/gl/compute_settings.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <utility>

#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

constexpr int most_pixels = 1024;

[[noreturn]] void refuse(std::string_view text, std::string_view why) {
    throw InputError(fmt::format(
        "KDSCOPE_COMPUTE '{}': {}; say 16x8, or with linear, storage or textures, lists or no-lists, dealt or "
        "in-order behind it: 8x4,storage",
        text, why));
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

/// Refuses a word that contradicts one before it in `text`.
void check_opposite(std::string_view text, std::string_view word, std::string_view before) {
    constexpr std::pair<std::string_view, std::string_view> opposites[] = {
        {"storage", "textures"}, {"lists", "no-lists"}, {"dealt", "in-order"}};
    for (const auto& [a, b] : opposites) {
        if (word != a && word != b) continue;
        for (std::string_view rest = before; !rest.empty();)
            if (next_word(rest) == (word == a ? b : a))
                refuse(text, fmt::format("'{}' and '{}' exclude each other", a, b));
    }
}

void take_word(std::string_view text, std::string_view word, ComputeSettings& settings) {
    if (word == "linear")
        settings.morton = false;
    else if (word == "storage" || word == "textures")
        settings.storage = word == "storage";
    else if (word == "lists" || word == "no-lists")
        settings.lists = word == "lists";
    else if (word == "dealt" || word == "in-order")
        settings.dealt = word == "dealt";
    else
        refuse(text, fmt::format("'{}' is unknown", word));
}

}  // namespace

ComputeSettings parse_compute_settings(std::string_view text) {
    std::string_view rest = text;
    const std::string_view size = next_word(rest);
    const std::size_t cross = size.find('x');
    if (cross == std::string_view::npos) refuse(text, "it begins with no size");
    ComputeSettings settings;
    settings.x = number(text, size.substr(0, cross), most_pixels);
    settings.y = number(text, size.substr(cross + 1), most_pixels);
    if (settings.x * settings.y > most_pixels) refuse(text, fmt::format("a group has at most {} pixels", most_pixels));
    const bool square = settings.x == settings.y || settings.x == 2 * settings.y;
    settings.morton = square && std::has_single_bit(unsigned(settings.x));
    const std::string_view words = rest;
    while (!rest.empty()) {
        const std::string_view before = words.substr(0, words.size() - rest.size());
        const std::string_view word = next_word(rest);
        check_opposite(text, word, before);
        take_word(text, word, settings);
    }
    return settings;
}

ComputeSettings compute_settings_in_force() {
    const char* said = std::getenv("KDSCOPE_COMPUTE");
    return said && *said ? parse_compute_settings(said) : ComputeSettings{};
}

}  // namespace kd

// Options with errors that say what would have been right, in one line: "--size: 'abc' is not WIDTHxHEIGHT, ...".
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <concepts>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/choices.h"
#include "app/limits.h"
#include "renderer/geometry/shared_types.h"

namespace kd {

/// The whole text as a number, "." for the decimal point whatever the locale; nothing where it is not one.
template <class T>
[[nodiscard]] std::optional<T> parse_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// An option whose text `take` reads; it throws std::invalid_argument saying what is wrong with the text.
CLI::Option* add_text_option(CLI::App& app, const std::string& flag, const std::string& type, const std::string& text,
                             std::function<void(const std::string&)> take);

[[noreturn]] void refuse(const std::string& reason);

/// A number within limits.
template <class T, class Target>
CLI::Option* add_number(CLI::App& app, const std::string& flag, Target& target, Limits<T> limits,
                        const std::string& text) {
    return add_text_option(app, flag, std::integral<T> ? "N" : "X", text, [&target, limits](const std::string& given) {
        const std::optional<T> value = parse_number<T>(given);
        if (!value || !limits.hold(*value)) refuse(fmt::format("'{}' is not {}", given, limits.text()));
        target = *value;
    });
}

/// The same for limits that only this option has.
template <class T, class Target>
CLI::Option* add_number(CLI::App& app, const std::string& flag, Target& target, std::type_identity_t<T> low,
                        std::type_identity_t<T> high, const std::string& text) {
    return add_number(app, flag, target, Limits<T>{low, high}, text);
}

/// One of a few names.
template <class T, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& flag, Target& target, std::vector<NamedValue<T>> choices,
                        const std::string& text) {
    const std::string described = fmt::format("{}: {}", text, list_names(choices));
    return add_text_option(app, flag, "NAME", described,
                           [&target, choices](const std::string& given) { target = chosen(choices, given, "value"); });
}

/// Numbers separated by commas or spaces, all finite. Throws std::invalid_argument.
[[nodiscard]] std::vector<float> parse_floats(const std::string& text);
[[nodiscard]] Vec3 parse_vec3(const std::string& text);

/// "512x384": two whole numbers within limits.
void add_pair(CLI::App& app, const std::string& flag, int& first, int& second, Limits<int> limits,
              const std::string& text);

}  // namespace kd

#include "app/cli/typed_options.h"

#include <cmath>
#include <stdexcept>

#include "renderer/io/printable.h"

namespace kd {

void refuse(const std::string& reason) { throw std::invalid_argument(reason); }

CLI::Option* add_text_option(CLI::App& app, const std::string& flag, const std::string& type, const std::string& text,
                             std::function<void(const std::string&)> take) {
    const auto read = [flag, take = std::move(take)](const std::string& given) {
        try {
            take(given);
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError(flag, printable(error.what(), 1000));
        }
    };
    return app.add_option_function<std::string>(flag, read, text)->type_name(type);
}

std::vector<float> parse_floats(const std::string& text) {
    std::vector<float> values;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find_first_of(", ", at), text.size());
        if (end > at) {
            const std::string word = text.substr(at, end - at);
            const std::optional<float> value = parse_number<float>(word);
            if (!value || !std::isfinite(*value)) refuse(fmt::format("'{}' is not a finite number", word));
            values.push_back(*value);
        }
        at = end + 1;
    }
    return values;
}

Vec3 parse_vec3(const std::string& text) {
    const std::vector<float> v = parse_floats(text);
    if (v.size() != 3) refuse(fmt::format("'{}' is not three numbers x,y,z", text));
    return {v[0], v[1], v[2]};
}

void add_pair(CLI::App& app, const std::string& flag, int& first, int& second, Limits<int> limits,
              const std::string& text) {
    add_text_option(app, flag, "WxH", text, [&first, &second, limits](const std::string& given) {
        const std::size_t cross = given.find('x');
        const auto part = [&](std::size_t from, std::size_t count) {
            return cross == std::string::npos ? std::nullopt : parse_number<int>(given.substr(from, count));
        };
        const std::optional<int> a = part(0, cross);
        const std::optional<int> b = part(cross + 1, std::string::npos);
        if (!a || !b || !limits.hold(*a) || !limits.hold(*b))
            refuse(fmt::format("'{}' is not WIDTHxHEIGHT with {} to {} pixels each", given, limits.low, limits.high));
        first = *a;
        second = *b;
    });
}

}  // namespace kd

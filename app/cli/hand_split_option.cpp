#include "app/cli/hand_split_option.h"

#include <cmath>
#include <stdexcept>

#include "app/choices.h"
#include "app/cli/typed_options.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

void add_hand_split(std::vector<HandSplit>& splits, const std::string& given) {
    const std::size_t first = given.find(':');
    const std::size_t second = given.find(':', first == std::string::npos ? first : first + 1);
    if (second == std::string::npos) refuse("not PATH:AXIS:AT, such as ba:x:0.5");
    HandSplit& split = splits.emplace_back(HandSplit{.path = given.substr(0, first)});
    if (const auto fault = hand_split_fault(splits, splits.size() - 1)) refuse(*fault);
    split.axis = chosen(choices::axes(), given.substr(first + 1, second - first - 1), "axis");
    const std::string position = given.substr(second + 1);
    const std::optional<float> at = parse_number<float>(position);
    if (!at || !std::isfinite(*at)) refuse(fmt::format("position '{}' is not a finite number", position));
    split.position = *at;
}

}  // namespace

std::string hand_split_text(const HandSplit& split) {
    return fmt::format("{}:{}:{}", split.path, choices::axes()[std::size_t(split.axis)].name, split.position);
}

CLI::Option* add_split_option(CLI::App& app, std::vector<HandSplit>& splits) {
    const auto take = [&splits](const std::vector<std::string>& given) {
        splits.clear();
        for (const std::string& one : given) {
            try {
                add_hand_split(splits, one);
            } catch (const std::invalid_argument& error) {
                throw CLI::ValidationError("--split", printable(fmt::format("'{}': {}", one, error.what()), 1000));
            }
        }
    };
    return app
        .add_option_function<std::vector<std::string>>(
            "--split", take,
            "A plane put by hand, as often as you like: the node by its path from the root (b: the child below, a: "
            "above; nothing: the root), axis x, y or z, position in scene units")
        ->type_name("PATH:AXIS:AT")
        ->allow_extra_args(false);
}

}  // namespace kd

#include "app/cli/hand_split_option.h"

#include <cmath>

#include "app/choices.h"
#include "app/cli/typed_options.h"

namespace kd {

void add_hand_split(std::vector<HandSplit>& splits, const std::string& given) {
    const std::size_t first = given.find(':');
    const std::size_t second = given.find(':', first == std::string::npos ? first : first + 1);
    if (second == std::string::npos) refuse(fmt::format("'{}' is not PATH:AXIS:AT, such as ba:x:0.5", given));
    const std::string position = given.substr(second + 1);
    const std::optional<float> at = parse_number<float>(position);
    if (!at || !std::isfinite(*at)) refuse(fmt::format("'{}' is not a finite number", position));
    splits.push_back(
        {given.substr(0, first), chosen(choices::axes(), given.substr(first + 1, second - first - 1), "axis"), *at});
    if (const auto fault = hand_split_fault(splits, splits.size() - 1)) refuse(fmt::format("'{}': {}", given, *fault));
}

}  // namespace kd

#include "app/cli/environment.h"

#include <cstdlib>
#include <fmt/format.h>

#include "app/cli/typed_options.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"

namespace kd {

std::optional<float> environment_number(const char* name, float low, float high) {
    const char* text = std::getenv(name);
    if (!text || !*text) return std::nullopt;
    const std::optional<float> value = parse_number<float>(text);
    if (!value || !(*value >= low && *value <= high))
        throw InputError(fmt::format("{}: '{}' is not a number from {} to {}; change it or unset it", name,
                                     printable(text), low, high));
    return value;
}

std::optional<float> environment_scale() { return environment_number("KDSCOPE_SCALE", 0.75f, 4.0f); }

}  // namespace kd

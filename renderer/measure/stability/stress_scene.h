// Scenes of the stability suite by name: "stress:T14" is the first scene that the case makes, "stress:T25=1e-4" the one
// that its sweep makes of a value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "renderer/scene/scene.h"

namespace kd {

inline constexpr std::string_view stress_prefix = "stress:";

/// Nothing where the name does not begin with stress_prefix. InputError for a case that is not known or has no scene,
/// and for a value that its sweep does not take.
[[nodiscard]] std::optional<FlatScene> make_stress_scene(std::string_view name, unsigned seed);

/// "stress:T25=0.0001"; reads back as the same value.
[[nodiscard]] std::string stress_name(std::string_view id, double value);

}  // namespace kd

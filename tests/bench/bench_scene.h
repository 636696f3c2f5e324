// What the benchmarks trace.
#pragma once

#include <optional>
#include <string>

#include "renderer/geometry/input_error.h"
#include "renderer/scene/procedural.h"

namespace kd {

inline constexpr int image_size = 512;

[[nodiscard]] inline FlatScene bench_scene(const std::string& name) {
    const std::optional<Scene> made = make_procedural(name);
    if (!made) throw InputError(name + ": no such procedural scene");
    return flatten(*made);
}

}  // namespace kd

// What the benchmarks trace.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/geometry/input_error.h"
#include "renderer/scene/procedural.h"

namespace kd {

inline constexpr int image_size = 512;

/// The camera's rays, row by row.
inline std::vector<Ray> primary_rays(const FlatScene& scene) {
    const PinholeCamera camera = pinhole(scene.camera, image_size, image_size);
    std::vector<Ray> rays;
    for (unsigned y = 0; y < image_size; ++y)
        for (unsigned x = 0; x < image_size; ++x) {
            const float across = (float(x) + 0.5f) * 2.0f / float(image_size) - 1.0f;
            const float down = 1.0f - (float(y) + 0.5f) * 2.0f / float(image_size);
            const Vec3 d = camera.forward + camera.right * across + camera.up * down;
            rays.push_back({camera.eye, d, 0.0f, KD_T_LIMIT, -1});
        }
    return rays;
}

[[nodiscard]] inline FlatScene bench_scene(const std::string& name) {
    const std::optional<Scene> made = make_procedural(name);
    if (!made) throw InputError(name + ": no such procedural scene");
    return flatten(*made);
}

}  // namespace kd

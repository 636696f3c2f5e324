// Sweeps: the parameter of a case driven through its range, from harmless to hopeless.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/kdtree/build.h"
#include "renderer/scene/random.h"
#include "renderer/scene/scene.h"

namespace kd {

/// What one value of the parameter makes. All lengths in scene units.
struct SweepScene {
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
    Camera camera;                // shows what the rays meet
    bool every_ray_hits = false;  // closed around every origin, or aimed well inside
    BuildConfig build{};
};

struct Sweep {
    std::string_view id;         // of the case, "T25"
    std::string_view parameter;  // "width of the triangles"
    std::string_view unit;       // "lengths"; empty where it has none
    bool logarithmic;            // how the parameter's axis is drawn
    std::vector<double> values;  // ascending
    /// At most `rays` rays, fewer where the scene is large; any value between the first and the last will do.
    SweepScene (*make)(double value, std::size_t rays, Random& random);
};

/// In order of their ids.
[[nodiscard]] std::span<const Sweep> sweeps();
/// Null where the case has none.
[[nodiscard]] const Sweep* find_sweep(std::string_view id);
/// The sweep of a case. InputError naming the cases that have one.
[[nodiscard]] const Sweep& sweep_of(std::string_view id);

/// "triangles at the vertex from 3 to 10000", with the unit where there is one.
[[nodiscard]] std::string range_text(const Sweep& sweep);

/// The random numbers of a sweep: the same at each of its values, so that nothing but the parameter differs.
[[nodiscard]] Random sweep_random(const Sweep& sweep, unsigned seed);

/// The flat scene of these triangles, seen and lit by the sweep's camera.
[[nodiscard]] FlatScene flat_scene(SweepScene& made);

}  // namespace kd

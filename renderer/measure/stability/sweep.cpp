#include "renderer/measure/stability/sweep.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/scene/units.h"

namespace kd {

std::span<const Sweep> sweeps() {
    static const std::vector<Sweep> table = [] {
        std::vector<Sweep> all{
#define KD_SWEEP(id) sweep_##id(),
#include "renderer/measure/stability/sweep_list.inc"
#undef KD_SWEEP
        };
        std::ranges::sort(all, {}, &Sweep::id);
        return all;
    }();
    return table;
}

const Sweep* find_sweep(std::string_view id) {
    const auto found = std::ranges::find(sweeps(), id, &Sweep::id);
    return found == sweeps().end() ? nullptr : &*found;
}

const Sweep& sweep_of(std::string_view id) {
    if (const Sweep* sweep = find_sweep(id)) return *sweep;
    const bool is_case = std::ranges::find(stability_cases(), id, &StabilityCase::id) != stability_cases().end();
    std::string known;
    for (const Sweep& sweep : sweeps()) known += fmt::format("{}{}", known.empty() ? "" : ", ", sweep.id);
    throw InputError(fmt::format("case '{}': {}; try one of {}", id, is_case ? "has no sweep" : "not known", known));
}

std::string range_text(const Sweep& sweep) {
    return fmt::format("{} from {:g} to {:g}{}{}", sweep.parameter, sweep.values.front(), sweep.values.back(),
                       sweep.unit.empty() ? "" : " ", sweep.unit);
}

Random sweep_random(const Sweep& sweep, unsigned seed) { return Random(case_seed(sweep.id, seed)); }

FlatScene flat_scene(SweepScene& made) {
    FlatScene scene = bare_scene(std::move(made.triangles));
    for (Ray& ray : made.rays) ray = to_internal(scene, ray);
    scene.camera = to_internal(scene, made.camera);
    scene.lights = {default_light(scene.camera)};
    return scene;
}

}  // namespace kd

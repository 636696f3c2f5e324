#include "renderer/measure/stability/stress_scene.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/measure/stability/case_run.h"
#include "renderer/measure/stability/sweep.h"

namespace kd {

namespace {

/// Runs a case until it asks for its first scene.
class FirstScene : public CaseRun {
  public:
    using CaseRun::CaseRun;
    Subject subject(FlatScene scene, const std::optional<BuildConfig>&) override {
        found = std::move(scene);
        throw Stopped{};
    }
    std::optional<FlatScene> found;
};

std::optional<FlatScene> first_scene(const StabilityCase& info, unsigned seed) {
    StabilityConfig config;
    config.seed = seed;
    FirstScene run(info, config, {}, {});
    try {
        info.run(run);
    } catch (const CaseRun::Stopped&) {
    }
    return run.found;
}

double value_for(const Sweep& sweep, std::string_view name, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const double low = sweep.values.front(), high = sweep.values.back();
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= low && value <= high))
        throw InputError(fmt::format("{}: {} is not a number from {:g} to {:g}; try {}", name, sweep.parameter, low,
                                     high, stress_name(sweep.id, sweep.values[sweep.values.size() / 2])));
    return value;
}

}  // namespace

std::string stress_name(std::string_view id, double value) { return fmt::format("{}{}={}", stress_prefix, id, value); }

std::optional<FlatScene> make_stress_scene(std::string_view name, unsigned seed) {
    if (!name.starts_with(stress_prefix)) return std::nullopt;
    const std::string_view rest = name.substr(stress_prefix.size());
    const std::size_t equals = std::min(rest.find('='), rest.size());
    const StabilityCase& info = stability_case(rest.substr(0, equals));
    std::optional<FlatScene> scene;
    if (equals == rest.size()) {
        scene = first_scene(info, seed);
        if (!scene) throw InputError(fmt::format("{}: this case traces no scene; try stress:T14", name));
    } else {
        const Sweep& sweep = sweep_of(info.id);
        const double value = value_for(sweep, name, rest.substr(equals + 1));
        Random random = sweep_random(sweep, seed);
        SweepScene made = sweep.make(value, 0, random);
        scene = flat_scene(made);
    }
    scene->name = name;
    return scene;
}

}  // namespace kd

#include "renderer/kdtree/build.h"

#include <array>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/sweep_events.h"

namespace kd {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void check_range(std::string_view name, double value, double least, double most) {
    if (value >= least && value <= most) return;  // false for NaN
    throw InputError(fmt::format("builder constant {} is {}: use a number from {} to {}", name, value, least, most));
}

void check_by_hand(const std::vector<HandSplit>& splits) {
    for (std::size_t i = 0; i < splits.size(); ++i)
        if (const auto fault = hand_split_fault(splits, i))
            throw InputError(fmt::format("plane by hand at '{}': {}", splits[i].path, *fault));
}

void check_config(const BuildConfig& config) {
    check_range("traversal_cost", double(config.traversal_cost), 0, 1e6);
    check_range("intersection_cost", double(config.intersection_cost), 0, 1e6);
    check_range("empty_bonus", double(config.empty_bonus), 0, 1);
    check_range("empty_bonus_gate", double(config.empty_bonus_gate), 0, 1);
    check_range("leaf_size", config.leaf_size, 0, 1 << 20);
    check_range("leaf_block", config.leaf_block, 1, 16);
    check_range("max_depth", config.max_depth, 0, max_tree_depth);
    check_range("empty_cut", config.empty_cut, 0.0f, 1.0f);
    check_range("bad_refines", config.bad_refines, 0, max_tree_depth);
    check_range("reference_cap", double(config.reference_cap), 1, 1e6);
    check_range("bins", config.bins, fewest_bins, most_bins);
    check_by_hand(config.by_hand);
}

bool is_finite(const Triangle& triangle) {
    for (const Vec3& point : triangle.corner) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return false;
    }
    return true;
}

void check_triangles(std::span<const Triangle> triangles) {
    if (triangles.size() > sweep_triangle_limit) {
        throw InputError(fmt::format("scene has {} triangles: a tree takes at most {}, split the scene",
                                     triangles.size(), sweep_triangle_limit));
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (is_finite(triangles[i])) continue;
        throw InputError(fmt::format("triangle {} has a corner that is not finite: remove it before building", i));
    }
}

const Builder& named_builder(std::string_view name) {
    if (const Builder* builder = find_builder(name)) return *builder;
    std::string known;
    for (const Builder& builder : builders()) known += fmt::format("{}{}", known.empty() ? "" : ", ", builder.name);
    throw InputError(fmt::format("builder '{}' is unknown: use one of {}", name, known));
}

}  // namespace

std::span<const Builder> builders() {
#define KD_LIST_BUILDER(name) name##_builder(),
    static const std::array table{KD_BUILDERS(KD_LIST_BUILDER)};
#undef KD_LIST_BUILDER
    return table;
}

const Builder* find_builder(std::string_view name) {
    for (const Builder& builder : builders()) {
        if (builder.name == name) return &builder;
    }
    return nullptr;
}

std::vector<std::string> build_notes(const BuildReport& report) {
    std::vector<std::string> notes;
    if (report.reference_cap_hit) notes.emplace_back(reference_cap_note);
    constexpr std::size_t named = 3;
    const std::size_t idle = report.idle_planes.size();
    for (std::size_t i = 0; i < std::min(idle, named); ++i)
        notes.push_back("plane by hand not used " + report.idle_planes[i]);
    if (idle > named) notes.push_back(fmt::format("{} more planes by hand not used", idle - named));
    if (report.tests_cost_nothing)
        notes.emplace_back(
            "one leaf holds all triangles: where tests cost nothing no split pays; raise the intersection cost");
    return notes;
}

void check_build_input(std::span<const Triangle> triangles, const BuildConfig& config) {
    check_config(config);
    check_triangles(triangles);
}

int depth_limit(const BuildConfig& config, std::size_t n) {
    if (config.max_depth > 0) return std::min(config.max_depth, max_tree_depth);
    const double depth = 8.0 + 1.6 * std::log2(double(std::max<std::size_t>(n, 1)));
    return std::min(int(std::lround(depth)), max_tree_depth);
}

KdTree build_tree(std::span<const Triangle> triangles, const BuildConfig& config, BuildReport* report,
                  const BuildProgress& progress, std::stop_token stop, int threads) {
    const auto begin = Clock::now();
    const Builder& builder = named_builder(config.builder);
    check_build_input(triangles, config);

    BuildReport own_report;
    BuildReport& told = report ? *report : own_report;
    told = BuildReport{};
    // A tree that grows a second time does not go back.
    float most_told = 0;
    const BuildProgress rising = [&](float done) {
        if (done > most_told) progress(most_told = done);
    };
    const BuildTask task{triangles, config, told, progress ? rising : progress, std::move(stop), threads};
    const TriangleRanges ranges(triangles);
    told.phases.prepare = seconds_since(begin);
    const auto grow = [&](Refusal refusal) {
        const auto sorting = Clock::now();
        std::unique_ptr<Splitter> splitter = builder.splitter(task, ranges);
        told.phases.prepare += seconds_since(sorting);
        return grow_tree(task, ranges, std::move(splitter), refusal);
    };
    std::optional<KdTree> tree = grow(Refusal::whole_tree);
    if (!tree) tree = grow(Refusal::each_cell);
    for (const HandSplit& split : config.by_hand)
        if (const auto why = why_idle(*tree, split))
            told.idle_planes.push_back(
                fmt::format("{}: {}", split.path.empty() ? "at the root" : "at '" + split.path + "'", *why));
    told.hand_splits = int(config.by_hand.size());
    told.idle_hand_splits = int(told.idle_planes.size());
    told.tests_cost_nothing =
        config.intersection_cost == 0 && tree->nodes.size() == 1 && int(triangles.size()) > config.leaf_size;
    told.seconds = seconds_since(begin);
    return *std::move(tree);
}

}  // namespace kd

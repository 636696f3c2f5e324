// What the paper's experiments gave when they were made again.
//
// "An Analysis of GPU-based Interactive Raytracing", section 4: three tracers on three kinds of scene, 512x512.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/measure/measured_on.h"
#include "renderer/measure/ray_count.h"
#include "renderer/measure/timing.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/rules.h"
#include "renderer/trace/traversal.h"

namespace kd {

/// The paper's three tracers, and three to understand them by.
enum class PaperMethod { cpurt, cpu_restart, gpurt, cpu_backtrack, gpu_stack, naive };
inline constexpr std::size_t paper_method_count = 6;

struct PaperMethodInfo {
    PaperMethod id;
    std::string_view name;   // in tables: "CPURT"
    std::string_view title;  // for people: "CPU, stack"
    Traversal traversal;
    bool gpu;
    bool papers_own;
};
[[nodiscard]] std::span<const PaperMethodInfo> paper_methods();
[[nodiscard]] const PaperMethodInfo& info(PaperMethod method);

struct PaperSceneInfo {
    std::string_view name;     // "ball:1000"
    std::string_view section;  // of the paper
    std::string_view what;     // for people
    bool papers_own;           // else larger than any of the paper's: for the law of growth alone (claim E1a)
};
/// 4.1: three sizes, and a larger one; 4.2: rooms; 4.3: both readings of a scene of small visible triangles.
[[nodiscard]] std::span<const PaperSceneInfo> paper_scenes();

/// Lanes of the groups that the neighbours' divergence is told for: 8 x 4 pixels, 32 as on GPUs of today.
inline constexpr int paper_tile_width = 8, paper_tile_height = 4;

/// One tracer on one scene.
struct PaperTimes {
    PaperMethod method = PaperMethod::cpurt;
    TimedRounds timed;
    std::string clock;
    double upload_ms = -1, compile_ms = -1;
};

/// Counts of one traversal on one scene, all rays: the same whatever traces them.
struct PaperCounts {
    Traversal traversal = Traversal::stack;
    CounterTotals all;
    double step_efficiency = 0;  // of primary rays, weighted by steps

    [[nodiscard]] std::uint64_t interior() const { return all.interior_first + all.interior_again; }
    /// Interior and leaf visits.
    [[nodiscard]] std::uint64_t visits() const { return interior() + all.leaves; }
};

struct PaperScene {
    std::string name;
    std::size_t triangles = 0, nodes = 0;
    double build_ms = 0;
    RayCounts rays{};
    std::vector<PaperCounts> counts;
    std::vector<PaperTimes> times;
    std::vector<double> seed_node_ratios;  // interior nodes, restart over stack, of scenes made from other seeds

    [[nodiscard]] std::int64_t ray_sum() const { return rays[0] + rays[1] + rays[2] + rays[3]; }
    [[nodiscard]] const PaperCounts* counts_of(Traversal traversal) const;
    [[nodiscard]] const PaperTimes* times_of(PaperMethod method) const;
    /// ms of every round; empty where it was not measured.
    [[nodiscard]] std::vector<double> ms(PaperMethod method) const;
    /// Interior nodes of `traversal` over those of the stack's; 0 where not counted.
    [[nodiscard]] double node_ratio(Traversal traversal) const;
};

/// Kd-restart with a limited number of steps: how many pixels were given up.
struct PaperBudget {
    std::string scene;
    std::size_t triangles = 0;
    int budget = 0;
    std::int64_t pixels = 0, unfinished = 0;
};

/// Whole frames by the stack over the same tree, with nodes of 16 and of 8 bytes.
struct PaperNodeSizes {
    std::string scene;
    bool gpu = false;  // the four passes; else the CPU
    std::size_t nodes = 0;
    TimedRounds wide, packed;
    std::string clock;
};

/// Stack traversals of the same rays, with every triangle tested once and twice.
struct PaperTriangleTests {
    std::string scene;
    TimedRounds once, twice;

    /// Of the time, what is no triangle test, round by round: visits of nodes and leaves, and beginning.
    [[nodiscard]] std::vector<double> traversal_shares() const;
};

struct PaperPicture {
    std::string file;  // "budget-ball-9000-255.png"
    std::string caption;
    std::shared_ptr<const Image<Rgba8>> image;
};

struct PaperResults {
    MeasuredOn on;
    int width = 512, height = 512;
    bool quick = false;
    Rules rules = Rules::robust;
    std::vector<PaperScene> scenes;
    std::vector<PaperBudget> budgets;
    std::vector<PaperNodeSizes> node_sizes;
    std::vector<PaperTriangleTests> triangle_tests;
    std::vector<PaperPicture> pictures;
    std::vector<std::string> notes;
    int rounds = 0;
    bool complete = false;

    [[nodiscard]] const PaperScene* scene(std::string_view name) const;
    [[nodiscard]] bool has_gpu_times() const;
};

}  // namespace kd

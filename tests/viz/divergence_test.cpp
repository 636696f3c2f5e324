#include "viz/divergence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/trace/counters.h"
#include "tests/viz/synthetic.h"
#include "viz/map.h"

namespace kd {
namespace {

RayLayer random_layer(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<uint> count(0, 40);
    RayLayer layer{Image<Hit>(width, height), Image<RayCounters>(width, height)};
    for (RayCounters& c : layer.counters.pixels) {
        if (random() % 4 == 0) continue;  // a lane with nothing to do
        c.interior_first = count(random);
        c.interior_again = count(random);
        c.leaves = count(random);
        c.triangle_tests = count(random);
        c.restarts = 1000;  // restarts, climbs and stack depth are no steps of their own
        c.backtracks = 1000;
        c.stack_depth = 1000;
    }
    return layer;
}

/// The definition written out for one pixel: every lane of its tile, also those past the border.
struct Slow {
    double sum = 0, max = 0, own = 0;
    int lanes = 0;

    Slow(const RayLayer& layer, int x, int y, int w, int h) {
        const int left = x / w * w;
        const int top = y / h * h;
        for (int lane = 0; lane < w * h; ++lane) {
            const int lane_x = left + lane % w;
            const int lane_y = top + lane / w;
            double n = 0;
            if (layer.counters.contains(lane_x, lane_y)) {
                const RayCounters& c = layer.counters.at(lane_x, lane_y);
                n = double(c.interior_first) + c.interior_again + c.leaves + c.triangle_tests;
            }
            sum += n;
            max = std::max(max, n);
            if (lane_x == x && lane_y == y) own = n;
            ++lanes;
        }
    }
};

constexpr std::pair<int, int> shapes[] = {{2, 2}, {8, 4}, {4, 8}, {32, 1}, {16, 16}, {7, 3}, {64, 16}, {1, 5}};

TEST(Divergence, AgreesWithTheDefinition) {
    for (const auto& [w, h] : shapes) {
        const RayLayer layer = random_layer(37, 23, unsigned(w * 100 + h));
        const Image<float> efficiency = step_efficiency(layer, w, h);
        const Image<float> idle = idle_steps(layer, w, h);
        for (int y = 0; y < 23; ++y) {
            for (int x = 0; x < 37; ++x) {
                const Slow slow(layer, x, y, w, h);
                EXPECT_EQ(idle.at(x, y), float(slow.max - slow.own));
                if (slow.max == 0) {
                    EXPECT_TRUE(std::isnan(efficiency.at(x, y)));
                } else {
                    EXPECT_EQ(efficiency.at(x, y), float(slow.sum / (slow.lanes * slow.max))) << w << "x" << h;
                }
            }
        }
    }
}

TEST(Divergence, LiesBetweenOneLaneAndAll) {
    for (const auto& [w, h] : shapes) {
        const RayLayer layer = random_layer(40, 30, 7);
        for (const float e : step_efficiency(layer, w, h).pixels) {
            if (std::isnan(e)) continue;
            EXPECT_GE(e, float(1.0 / (w * h)));
            EXPECT_LE(e, 1.0f);
        }
        for (const float idle : idle_steps(layer, w, h).pixels) EXPECT_GE(idle, 0.0f);
    }
}

TEST(Divergence, OneLaneNeverWaits) {
    const RayLayer layer = random_layer(20, 20, 3);
    const Image<float> efficiency = step_efficiency(layer, 1, 1);
    for (std::size_t i = 0; i < efficiency.pixels.size(); ++i) {
        if (lane_steps(layer.counters.pixels[i]) > 0) {
            EXPECT_EQ(efficiency.pixels[i], 1.0f);
        }
    }
    for (const float idle : idle_steps(layer, 1, 1).pixels) EXPECT_EQ(idle, 0.0f);
}

TEST(Divergence, EqualRaysNeverWait) {
    RayLayer layer{Image<Hit>(32, 16), Image<RayCounters>(32, 16)};
    for (RayCounters& c : layer.counters.pixels) c.interior_first = 17;
    for (const float e : step_efficiency(layer, 8, 4).pixels) EXPECT_EQ(e, 1.0f);
    const EfficiencySummary all = summarise_divergence(layer, 8, 4);
    EXPECT_EQ(all.weighted, 1.0);
    EXPECT_EQ(all.groups, 16);
    EXPECT_EQ(all.steps, 17u * 32 * 16);
}

TEST(Divergence, OneBusyLaneIsTheWorstCase) {
    RayLayer layer{Image<Hit>(8, 4), Image<RayCounters>(8, 4)};
    layer.counters.at(5, 2).leaves = 1000;
    EXPECT_EQ(step_efficiency(layer, 8, 4).at(0, 0), 1.0f / 32.0f);
    EXPECT_EQ(idle_steps(layer, 8, 4).at(0, 0), 1000.0f);
    EXPECT_EQ(idle_steps(layer, 8, 4).at(5, 2), 0.0f);
}

// Lanes past the border are there, and idle.
TEST(Divergence, BorderTilesArePadded) {
    RayLayer layer{Image<Hit>(10, 4), Image<RayCounters>(10, 4)};
    for (RayCounters& c : layer.counters.pixels) c.leaves = 3;
    const Image<float> efficiency = step_efficiency(layer, 8, 4);
    EXPECT_EQ(efficiency.at(0, 0), 1.0f);
    EXPECT_EQ(efficiency.at(9, 3), 8.0f / 32.0f);
}

TEST(Divergence, CountsDoNotOverflow) {
    RayLayer layer{Image<Hit>(2, 2), Image<RayCounters>(2, 2)};
    for (RayCounters& c : layer.counters.pixels) c.interior_first = c.interior_again = c.leaves = 0xffffffffu;
    EXPECT_EQ(lane_steps(layer.counters.at(0, 0)), 3 * 0xffffffffull);
    EXPECT_EQ(step_efficiency(layer, 2, 2).at(1, 1), 1.0f);
}

TEST(Divergence, SummaryWeighsByStepsOrByTiles) {
    // Three tiles of 2x2: efficiencies 1 (4 of 4 steps), 1/4 (100 of 400), and one without work.
    RayLayer layer{Image<Hit>(6, 2), Image<RayCounters>(6, 2)};
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) layer.counters.at(x, y).leaves = 1;
    }
    layer.counters.at(3, 1).interior_first = 100;
    const EfficiencySummary all = summarise_divergence(layer, 2, 2);
    EXPECT_EQ(all.groups, 2);
    EXPECT_DOUBLE_EQ(all.weighted, 104.0 / 404.0);
    EXPECT_EQ(all.median, 0.25) << "the lower of two";
    EXPECT_EQ(all.p5, 0.25);
    EXPECT_EQ(summarise_divergence(RayLayer{Image<Hit>(4, 4), Image<RayCounters>(4, 4)}, 2, 2).groups, 0);
}

TEST(Divergence, MapTellsTheTileAndTheWholeImage) {
    const Frame frame = test::ball_frame();
    MapConfig config;
    config.map = "divergence";
    const ScalarMap map = compute_map(frame, config);
    ASSERT_EQ(map.facts.size(), 6u);
    EXPECT_EQ(map.facts[0], (MapFact{"tile", "8×4 = 32 lanes"}));
    EXPECT_EQ(map.facts[1], (MapFact{"schedule", "lockstep"}));
    const double whole = summarise_divergence(frame.layer(Pass::rt_prim), 8, 4).weighted;
    EXPECT_NEAR(std::stod(map.facts[2].value), whole, 5e-4);
    EXPECT_TRUE(std::isnan(compute_map(Frame(8, 8), config).values.at(0, 0)));
}

}  // namespace
}  // namespace kd

// Frames of blocks of pixels, whose rays are traced type by type, against frames pixel by pixel.

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/trace/counters.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

/// A frame whose sides are no multiple of a tile or of a block of pixels, with every kind of light and of material.
class PixelBatch : public testing::Test {
  protected:
    static constexpr int width = 41, height = 35;
    const FlatScene scene = test::soft_scene(200, 7);
    const KdTree tree = build_tree(scene.triangles, {});

    [[nodiscard]] Frame frame(CpuMode mode, const TraceConfig& config) const {
        Frame made(width, height);
        CpuTracer(scene, tree, mode).trace_frame(config, pinhole(scene.camera, width, height), made, 2);
        return made;
    }
};

void expect_the_same(const Frame& found, const Frame& expected) {
    EXPECT_TRUE(found.colour == expected.colour);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        const RayLayer &layer = found.layers[pass], &wanted = expected.layers[pass];
        EXPECT_TRUE(std::ranges::equal(layer.hit.pixels, wanted.hit.pixels, bit_equal)) << pass_names[pass];
        EXPECT_TRUE(std::ranges::equal(layer.counters.pixels, wanted.counters.pixels)) << pass_names[pass];
    }
}

TEST_F(PixelBatch, MakesThePictureOfSinglePixelsToTheBit) {
    for (const int bounces : {0, 1, 4})
        for (const bool shadows : {true, false}) {
            SCOPED_TRACE(testing::Message() << bounces << " bounces, shadows " << shadows);
            // Sampled or not, in turn.
            TraceConfig config{
                .shadows = shadows, .reflection_depth = bounces, .sampling = {.sample = bounces % 2 - 1}};
            const Frame expected = frame(CpuMode::scalar, config);
            test::on_each_instruction_set([&] {
                expect_the_same(frame(CpuMode::wide, config), expected);
                for (const int size : {4, 8, 16}) {
                    SCOPED_TRACE(testing::Message() << "packets of " << size);
                    config.packet_size = size;
                    expect_the_same(frame(CpuMode::packet, config), expected);
                }
            });
        }
}

TEST_F(PixelBatch, HasEveryPassToCompare) {
    const Frame made = frame(CpuMode::packet, {.reflection_depth = 4, .sampling = {.sample = 0}});
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        EXPECT_TRUE(std::ranges::any_of(made.layers[pass].hit.pixels, [](const Hit& hit) { return hit.triangle >= 0; }))
            << pass_names[pass];
    // Some path goes on behind its first bounce.
    EXPECT_FALSE(made.colour == frame(CpuMode::packet, {.reflection_depth = 1, .sampling = {.sample = 0}}).colour);
}

}  // namespace
}  // namespace kd

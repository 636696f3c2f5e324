// Walks against the counters of the frame that they are the walks of.

#include "renderer/measure/walk_recorder.h"

#include <atomic>
#include <gtest/gtest.h>
#include <mutex>
#include <set>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"

namespace kd {
namespace {

constexpr int width = 50, height = 41;

struct Recorded {
    explicit Recorded(const std::string& name) : scene(flatten(*make_procedural(name))) {}

    [[nodiscard]] WalkRequest request(const TraceConfig& config, Pass rays) const {
        return {.scene = scene,
                .tree = tree,
                .config = config,
                .camera = camera,
                .width = width,
                .height = height,
                .rays = rays,
                .block_width = 16,
                .block_height = 8};
    }
    /// Compares every pixel's walks with its counters.
    void compare(const TraceConfig& config, Pass rays) const {
        Frame frame(width, height);
        CpuTracer(scene, tree).trace_frame(config, camera, frame);
        std::mutex mutex;
        int pixels = 0;
        WalkRequest asked = request(config, rays);
        asked.with_stack = true;
        const bool whole = record_walks(asked, [&](const BlockWalks& block) {
            const std::scoped_lock lock(mutex);
            for (int y = block.area.y0; y < block.area.y1; ++y)
                for (int x = block.area.x0; x < block.area.x1; ++x) {
                    ++pixels;
                    compare(block.at(x, y), frame, rays, frame.colour.index(x, y));
                }
        });
        EXPECT_TRUE(whole);
        EXPECT_EQ(pixels, width * height);
    }
    void compare(const PixelWalks& walks, const Frame& frame, Pass rays, std::size_t i) const {
        const RayCounters& c = frame.layer(rays).counters.pixels[i];
        const Hit& hit = frame.layer(rays).hit.pixels[i];
        EXPECT_EQ(walks.steps(), std::uint64_t(c.interior_first) + c.interior_again + c.leaves + c.triangle_tests);
        EXPECT_EQ(walks.interior_steps(), std::uint64_t(c.interior_first) + c.interior_again);
        EXPECT_EQ(!walks.rays.empty(), ray_traced(frame, rays, i));
        EXPECT_EQ(walks.hit_triangle, hit.triangle);
        EXPECT_TRUE(walks.same_hit);
        if (hit.triangle < 0) return;
        ASSERT_GE(walks.hit_leaf, 0);
        const TreeNode& leaf = tree.nodes[std::size_t(walks.hit_leaf)];
        const auto first = tree.references.begin() + leaf.link;
        EXPECT_NE(std::find(first, first + leaf.count, hit.triangle), first + leaf.count);
    }

    FlatScene scene;
    KdTree tree = build_tree(scene.triangles, {});
    PinholeCamera camera = pinhole(scene.camera, width, height);
};

TEST(RecordWalks, AreWhatTheCountersCount) {
    const Recorded cornell("cornell");
    for (const TraversalInfo& traversal : traversals())
        for (int pass = 0; pass < pass_count && traversal.id != Traversal::naive; ++pass) {
            SCOPED_TRACE(std::string(traversal.name) + " " + std::string(ray_names[std::size_t(pass)]));
            cornell.compare({.traversal = traversal.id, .reflection_depth = 3, .sampling = {.sample = 0}}, Pass(pass));
        }
    const Recorded rooms("rooms");  // with the camera inside
    for (const TraceConfig& config : {TraceConfig{.traversal = Traversal::ropes, .eye_leaf = true},
                                      TraceConfig{.traversal = Traversal::stack, .entry_tile = 8}}) {
        WalkRequest request = rooms.request(config, Pass::rt_prim);
        request.with_stack = true;
        std::atomic<int> unlike = 0;
        record_walks(request, [&](const BlockWalks& block) {
            for (const PixelWalks& pixel : block.pixels) unlike += !pixel.same_hit;
        });
        EXPECT_EQ(unlike, 0) << "the stack's walk begins at the root";
    }
    cornell.compare({.traversal = Traversal::ropes, .eye_leaf = true}, Pass::rt_prim);
    cornell.compare({.traversal = Traversal::stack, .entry_tile = 8}, Pass::rt_prim);
}

TEST(RecordWalks, RoundsAreLightsAndBounces) {
    Recorded two("cornell");
    two.scene.lights.push_back(two.scene.lights.front());
    for (Material& material : two.scene.materials) material.reflectance = Vec3(0.5f);
    std::set<int> rounds;
    std::mutex mutex;
    const auto collect = [&](const BlockWalks& block) {
        const std::scoped_lock lock(mutex);
        for (const PixelWalks& pixel : block.pixels)
            for (const RayWalk& ray : pixel.rays) rounds.insert(ray.round);
    };
    record_walks(two.request({}, Pass::shade_prim), collect);
    EXPECT_EQ(rounds, (std::set<int>{0, 1}));
    rounds.clear();
    record_walks(two.request({.reflection_depth = 2}, Pass::rt_refl), collect);
    EXPECT_EQ(rounds, (std::set<int>{0, 1}));
    rounds.clear();
    record_walks(two.request({.reflection_depth = 2}, Pass::shade_refl), collect);
    EXPECT_EQ(rounds, (std::set<int>{0, 1, 2, 3}));
}

TEST(RecordWalks, TheStackNeverVisitsMore) {
    const Recorded ball("ball:1000");
    std::atomic<std::uint64_t> with = 0, without = 0;
    WalkRequest request = ball.request({.traversal = Traversal::restart}, Pass::rt_prim);
    request.with_stack = true;
    record_walks(request, [&](const BlockWalks& block) {
        for (const PixelWalks& pixel : block.pixels) {
            EXPECT_LE(pixel.stack_interior, pixel.interior_steps());
            with += pixel.stack_interior;
            without += pixel.interior_steps();
        }
    });
    EXPECT_GT(double(without) / double(with), 1.5);
}

TEST(RecordWalks, OneTriangleAfterTheOtherIsOneRun) {
    const Recorded ball("ball:1000");
    record_walks(ball.request({.traversal = Traversal::naive}, Pass::rt_prim), [&](const BlockWalks& block) {
        for (const PixelWalks& pixel : block.pixels) {
            ASSERT_EQ(pixel.rays.size(), 1u);
            ASSERT_EQ(pixel.rays[0].walk.runs().size(), 1u) << "memory must not grow with the scene";
            EXPECT_EQ(pixel.hit_leaf, -1);
        }
    });
}

TEST(RecordWalks, StopsAndTellsHowFarItIs) {
    const Recorded ball("ball:1000");
    std::stop_source stop;
    std::atomic<float> last = 0;
    EXPECT_FALSE(record_walks(
        ball.request({}, Pass::rt_prim), [](const BlockWalks&) {}, stop.get_token(),
        [&](float done) {
            last = done;
            stop.request_stop();
        }));
    EXPECT_GT(last, 0.0f);
    EXPECT_LT(last, 1.0f);
}

}  // namespace
}  // namespace kd

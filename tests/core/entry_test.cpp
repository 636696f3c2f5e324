// Where primary rays begin: never beyond anything that they could hit.

#include "renderer/kdtree/entry.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/kdtree/ropes.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"

namespace kd {
namespace {

constexpr int size = 64;

struct Seen {
    FlatScene scene;
    KdTree tree;
    std::vector<Aabb> boxes;
    PinholeCamera camera;

    explicit Seen(const char* name)
        : scene(flatten(*make_procedural(name))), tree(build_tree(scene.triangles, {})), boxes(node_boxes(tree)),
          camera(pinhole(scene.camera, size, size)) {}

    [[nodiscard]] SeenArea area(int x0, int y0, int x1, int y1) const { return {camera, size, size, x0, y0, x1, y1}; }
    [[nodiscard]] Frame traced(TraceConfig config) const {
        Frame frame(size, size);
        CpuTracer(scene, tree).trace_frame(config, camera, frame);
        return frame;
    }
    [[nodiscard]] EntryPoints points(const TraceConfig& config) const {
        return entry_points(tree, boxes, config, area(0, 0, size, size));
    }
};

std::uint64_t visits(const Frame& frame) {
    std::uint64_t sum = 0;
    for (const RayCounters& c : frame.layer(Pass::rt_prim).counters.pixels) sum += c.interior_first + c.interior_again;
    return sum;
}

TEST(Entry, IsTheRootUnlessAskedForOtherwise) {
    const Seen rooms("rooms");
    const Vec3 eye = rooms.scene.camera.eye;
    EXPECT_EQ(rooms.points({}).at(5, 60), 0);
    EXPECT_EQ(rooms.points({.traversal = Traversal::ropes}).at(5, 60), 0);
    EXPECT_EQ(rooms.points({.traversal = Traversal::stack, .eye_leaf = true}).at(0, 0), 0) << "it could not go on";
    EXPECT_EQ(rooms.points({.traversal = Traversal::ropes, .eye_leaf = true}).at(0, 0), leaf_at(rooms.tree, eye));
    EXPECT_EQ(rooms.points({.traversal = Traversal::ropes, .entry_tile = 8}).at(0, 0), 0);
    EXPECT_EQ(rooms.points({.rules = Rules::as_published, .entry_tile = 8}).at(0, 0), 0);
    EXPECT_EQ(rooms.points({.entry_tile = 8}).nodes.size(), 64u);
    EXPECT_EQ(rooms.points({.entry_tile = 24}).nodes.size(), 9u);
}

TEST(Entry, SmallerTilesBeginDeeper) {
    const Seen ball("ball:1000");
    const std::vector<int> depths = node_depths(ball.tree);
    double before = -1;
    for (const int tile : {64, 16, 4, 1}) {
        const EntryPoints points = ball.points({.entry_tile = tile});
        double sum = 0;
        for (const std::int32_t node : points.nodes) sum += depths[std::size_t(node)];
        const double mean = sum / double(points.nodes.size());
        EXPECT_GE(mean, before) << tile;
        before = mean;
    }
    EXPECT_GT(before, 2);
}

TEST(Entry, ChangesNoHitAndSparesVisits) {
    for (const char* name : {"ball:1000", "rooms", "scatter:500"}) {
        const Seen seen(name);
        for (const TraversalInfo& walk : traversals()) {
            SCOPED_TRACE(std::string(name) + " " + std::string(walk.name));
            if (walk.id == Traversal::naive) continue;
            const Frame from_root = seen.traced({.traversal = walk.id});
            for (const int tile : {1, 8, 24}) {
                const TraceConfig config{.traversal = walk.id, .entry_tile = tile};
                const Frame from_tiles = seen.traced(config);
                EXPECT_EQ(from_tiles.colour, from_root.colour);
                for (std::size_t pass = 0; pass < pass_count; ++pass)
                    EXPECT_TRUE(std::ranges::equal(from_tiles.layers[pass].hit.pixels,
                                                   from_root.layers[pass].hit.pixels, bit_equal));
                if (enters_by_tile(config))
                    EXPECT_LT(visits(from_tiles), visits(from_root)) << tile;
                else
                    EXPECT_EQ(visits(from_tiles), visits(from_root)) << tile;
            }
        }
    }
}

TEST(Entry, AShaftThatMeetsNothingEndsInALeaf) {
    Seen seen("ball:300");
    seen.camera.forward = -seen.camera.forward;
    const int node = shaft_entry(seen.tree, seen.boxes, seen.area(0, 0, 8, 8));
    EXPECT_TRUE(seen.tree.nodes[std::size_t(node)].is_leaf());
    const Frame frame = seen.traced({.entry_tile = 8});
    for (const Hit& hit : frame.layer(Pass::rt_prim).hit.pixels) ASSERT_EQ(hit.triangle, -1);
    EXPECT_EQ(visits(frame), 0u) << "every ray begins in a leaf";
}

}  // namespace
}  // namespace kd

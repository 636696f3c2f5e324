// Frames against double precision: right ones, published ones, and ones in which every fault was planted.

#include "renderer/measure/frame_judge.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <mutex>
#include <string>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

constexpr int size = 128;

struct Judged {
    explicit Judged(FlatScene what) : scene(std::move(what)) {}
    explicit Judged(const std::string& name) : Judged(flatten(*make_procedural(name))) {}

    Frame trace(const TraceConfig& config) {
        Frame frame(size, size);
        CpuTracer(scene, tree).trace_frame(config, camera, frame);
        return frame;
    }
    JudgedLayer judge(const Frame& frame, Pass rays = Pass::rt_prim, int step = 1) const {
        return judge_frame(oracle, {frame, camera, rays, step}).value();
    }

    FlatScene scene;
    KdTree tree = build_tree(scene.triangles, {});
    PinholeCamera camera = pinhole(scene.camera, size, size);
    DoubleOracle oracle{scene};
};

std::int64_t count(const JudgedLayer& layer, HitVerdict verdict) { return layer.counts[std::size_t(verdict)]; }

TEST(JudgeFrame, RobustRulesHaveNoWrongPixel) {
    for (const char* name : {"ball:1000", "rooms", "cornell"}) {
        Judged subject(name);
        for (const TraversalInfo& traversal : traversals()) {
            if (traversal.id == Traversal::naive) continue;
            const Frame frame = subject.trace({.traversal = traversal.id});
            const JudgedLayer primary = subject.judge(frame);
            EXPECT_EQ(primary.compared(), size * size) << name;
            EXPECT_EQ(primary.wrong(), 0) << name << ", " << traversal.name;
            const JudgedLayer mirrored = subject.judge(frame, Pass::rt_refl);
            EXPECT_EQ(mirrored.wrong(), 0) << name << ", " << traversal.name << ", reflections";
            EXPECT_EQ(mirrored.compared() > 0, name != std::string("rooms")) << "nothing in rooms reflects";
        }
    }
}

TEST(JudgeFrame, PublishedRulesHaveWrongPixels) {
    Judged rooms("rooms");
    const JudgedLayer stack = rooms.judge(rooms.trace({.rules = Rules::as_published}));
    EXPECT_GT(count(stack, HitVerdict::missed), 100);
    EXPECT_GT(count(stack, HitVerdict::wrong_triangle), 100);
    EXPECT_EQ(count(stack, HitVerdict::unfinished), 0);
    const TraceConfig endless{.traversal = Traversal::restart, .rules = Rules::first_edition};
    EXPECT_GT(count(rooms.judge(rooms.trace(endless)), HitVerdict::unfinished), 1000);
}

/// Where a walk loses a hit at an edge, single precision is no excuse: brute force with the same triangle test finds
/// it.
TEST(JudgeFrame, AHoleAtAnEdgeIsNoTie) {
    Judged cornell("cornell");
    const Frame frame = cornell.trace({.rules = Rules::as_published});
    const JudgedLayer layer = cornell.judge(frame);
    const Frame right = cornell.trace({.traversal = Traversal::naive});
    int at_edges = 0;
    for (std::size_t i = 0; i < layer.hits.pixels.size(); ++i) {
        const Hit& found = frame.layer(Pass::rt_prim).hit.pixels[i];
        const Hit& expected = right.layer(Pass::rt_prim).hit.pixels[i];
        EXPECT_EQ(is_wrong(layer.hits.pixels[i].verdict), found.triangle != expected.triangle) << i;
        const f64::Hit& exact = layer.hits.pixels[i].exact;
        at_edges += found.triangle < 0 && exact.triangle >= 0 && edge_distance(exact.u, exact.v) < HitJudge{}.margin;
    }
    EXPECT_GT(at_edges, 0) << "the scene has such pixels";
}

TEST(JudgeFrame, PlantedFaultsAreNamed) {
    Judged subject("ball:1000");
    Frame frame = subject.trace({});
    RayLayer& layer = frame.layer(Pass::rt_prim);
    // Pixels well inside of their triangles, and one that sees nothing.
    const auto inside = [&](int y) {
        for (int x = 0; x < size; ++x) {
            const Hit& hit = layer.hit.at(x, y);
            if (hit.triangle >= 0 && edge_distance(double(hit.u), double(hit.v)) > 0.1) return layer.hit.index(x, y);
        }
        ADD_FAILURE() << "row " << y << " sees no triangle's inside";
        return std::size_t(0);
    };
    const std::size_t missed = inside(40), wrong = inside(50), off = inside(60), capped = inside(70), full = inside(80),
                      neighbour = inside(90), near = inside(100);
    layer.hit.pixels[missed] = {-1, KD_T_LIMIT, 0, 0};
    layer.counters.pixels[missed].exit_reason = uint(KD_EXIT_MISS);
    layer.hit.pixels[wrong] = {0, 2 * layer.hit.pixels[wrong].t, 0.3f, 0.3f};
    layer.hit.pixels[off].t *= 1.0f + 0x1p-12f;
    layer.counters.pixels[capped].exit_reason = uint(KD_EXIT_STEP_CAP);
    layer.counters.pixels[full].exit_reason = uint(KD_EXIT_STACK_OVERFLOW);
    layer.hit.pixels[neighbour].triangle =
        (layer.hit.pixels[neighbour].triangle + 1) % int(subject.scene.triangles.size());
    layer.hit.pixels[near].t = std::nextafter(layer.hit.pixels[near].t, 1e9f);

    const JudgedLayer judged = subject.judge(frame);
    EXPECT_EQ(judged.hits.pixels[missed].verdict, HitVerdict::missed);
    EXPECT_TRUE(std::isinf(judged.hits.pixels[missed].ulps));
    EXPECT_EQ(judged.hits.pixels[wrong].verdict, HitVerdict::wrong_triangle);
    EXPECT_EQ(judged.hits.pixels[off].verdict, HitVerdict::wrong_t);
    EXPECT_GT(judged.hits.pixels[off].ulps, 1000);
    EXPECT_EQ(judged.hits.pixels[capped].verdict, HitVerdict::unfinished);
    EXPECT_EQ(judged.hits.pixels[full].verdict, HitVerdict::unfinished);
    EXPECT_EQ(judged.hits.pixels[neighbour].verdict, HitVerdict::wrong_triangle) << "t is right, the triangle not";
    EXPECT_EQ(judged.hits.pixels[near].verdict, HitVerdict::agrees);
    EXPECT_EQ(judged.wrong(), 6);
    EXPECT_FALSE(judged.places.empty());
}

TEST(JudgeFrame, EitherOfTwoTrianglesInOnePlaceWillDo) {
    const Triangle twice{{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)}};
    FlatScene scene = test::scene_of({twice, twice});
    scene.camera = {{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 60};
    Judged subject(std::move(scene));
    Frame frame = subject.trace({});
    Hit& hit = frame.layer(Pass::rt_prim).hit.at(size / 2, size / 2);
    ASSERT_EQ(hit.triangle, 0);
    hit.triangle = 1;
    EXPECT_EQ(subject.judge(frame).hits.at(size / 2, size / 2).verdict, HitVerdict::tie);
    hit.u += 0x1p-10f;
    EXPECT_EQ(subject.judge(frame).hits.at(size / 2, size / 2).verdict, HitVerdict::wrong_triangle)
        << "the ray meets it elsewhere";
}

TEST(JudgeFrame, AHitWhereNothingIsIsFalse) {
    Judged subject("scatter:200");
    Frame frame = subject.trace({});
    const auto empty = std::ranges::find(frame.layer(Pass::rt_prim).hit.pixels, -1, &Hit::triangle);
    ASSERT_NE(empty, frame.layer(Pass::rt_prim).hit.pixels.end());
    *empty = {7, 1.0f, 0.3f, 0.3f};
    const JudgedLayer judged = subject.judge(frame);
    EXPECT_EQ(count(judged, HitVerdict::false_hit), 1);
    EXPECT_EQ(judged.wrong(), 1);
}

TEST(JudgeFrame, ASketchJudgesEveryFourthPixel) {
    Judged subject("cornell");
    const Frame frame = subject.trace({.rules = Rules::as_published});
    const JudgedLayer all = subject.judge(frame), sketch = subject.judge(frame, Pass::rt_prim, 4);
    EXPECT_EQ(sketch.step, 4);
    ASSERT_EQ(sketch.hits.width, size / 4);
    for (int y = 0; y < sketch.hits.height; ++y)
        for (int x = 0; x < sketch.hits.width; ++x)
            EXPECT_EQ(sketch.hits.at(x, y).verdict, all.hits.at(4 * x, 4 * y).verdict);
}

TEST(JudgeFrame, PixelsWithoutARayAreNotCompared) {
    Judged subject("cornell");
    Frame frame = subject.trace({});
    frame.colour.at(3, 5).w = 0;
    const JudgedLayer judged = subject.judge(frame);
    EXPECT_EQ(judged.hits.at(3, 5).verdict, HitVerdict::none);
    EXPECT_EQ(judged.compared(), size * size - 1);
}

TEST(JudgeFrame, StopsAndTellsHowFarItIs) {
    Judged subject("cornell");
    const Frame frame = subject.trace({});
    std::stop_source stop;
    float farthest = 0;
    std::mutex mutex;
    EXPECT_FALSE(judge_frame(subject.oracle, {frame, subject.camera}, stop.get_token(), [&](float done) {
        const std::scoped_lock lock(mutex);
        farthest = std::max(farthest, done);
        stop.request_stop();
    }));
    EXPECT_GT(farthest, 0);
    EXPECT_LT(farthest, 1);
}

}  // namespace
}  // namespace kd

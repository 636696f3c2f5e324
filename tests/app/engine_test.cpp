// The engine without a window: one way from session to picture, whatever happens on the way.
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "app/engine/pixel.h"
#include "renderer/trace/counters.h"
#include "tests/app/engine_run.h"
#include "viz/overlay.h"

namespace kd {
namespace {

TEST(Engine, ShowsTheWholePictureOfTheSessionItStartsWith) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const EngineState& state = engine.state();
    EXPECT_EQ(state.picture->image.width, 64);
    EXPECT_EQ(state.picture->image.height, 48);
    EXPECT_EQ(state.picture->traced.scale, 1);
    EXPECT_EQ(state.world->stats.triangles, std::int64_t(state.world->scene().triangles.size()));
    ASSERT_TRUE(state.picture->map);
    EXPECT_EQ(state.picture->map->summary.count, 64 * 48);
    EXPECT_EQ(read_map(*state.picture, {20, 30}), state.picture->map->labels.values.at(20, 30));
    EXPECT_FALSE(read_map(*state.picture, {64, 0}));
    EXPECT_TRUE(state.messages.empty());
}

TEST(Engine, SameSessionSamePicture) {
    Session session = small_session();
    session.trace.traversal = Traversal::restart;
    Engine a(session, quiet());
    Engine b(small_session("rooms"), quiet());
    ASSERT_TRUE(settle(b));
    b.set_session(session);  // by another way
    ASSERT_TRUE(settle(a));
    ASSERT_TRUE(settle(b));
    EXPECT_EQ(a.state().picture->image, b.state().picture->image);
}

TEST(Engine, TheLatestOfManySessionsWins) {
    Engine engine(small_session(), quiet());
    Session session = small_session();
    for (int i = 0; i < 40; ++i) {
        session.scene = i % 2 ? "ball:300" : "ball:200";
        session.build.leaf_size = 1 + i;
        session.width = 40 + i;
        engine.set_session(session);
        engine.poll();
    }
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().world->loaded->name, "ball:300");
    EXPECT_EQ(engine.state().world->built_with.leaf_size, 40);
    EXPECT_EQ(engine.state().picture->image.width, 79);
}

TEST(Engine, AnUnknownSceneKeepsTheOldOneAndSaysWhy) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const Image<Rgba8> before = engine.state().picture->image;
    Session session = small_session("no-such-scene.gltf");
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.messages.empty(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "no-such-scene.gltf"));
    EXPECT_EQ(engine.state().session.scene, "ball:300");
    EXPECT_EQ(engine.state().picture->image, before);
}

TEST(Engine, ARefusedConstantOfTheTreeIsTakenBack) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = small_session();
    session.build.builder = "no-such-builder";
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.messages.empty(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "no-such-builder"));
    EXPECT_EQ(engine.state().session.build, BuildConfig{});
}

TEST(Engine, ATreeThatStoppedAtItsCapOfReferencesIsTold) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(engine.state().messages.empty());
    Session session = small_session();
    session.build.reference_cap = 1;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    ASSERT_EQ(engine.state().messages.size(), 1u);
    EXPECT_EQ(engine.state().messages[0].text, "tree: " + std::string(reference_cap_note));
    EXPECT_FALSE(engine.state().messages[0].error) << "the tree is sound";
}

TEST(Engine, AnUnknownMapIsTakenBack) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = small_session();
    session.view.map.map = "no-such-map";
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.messages.empty(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().session.view.map.map, "nodes");
}

TEST(Engine, AnInvalidCameraLeavesTheLastGoodOne) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = engine.state().session;
    session.camera = Camera{.eye = Vec3(3, 2, 1)};
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    const Camera good = engine.state().camera;
    const std::uint64_t generation = engine.state().generation;
    for (const Camera& bad : {Camera{.eye = Vec3(std::numeric_limits<float>::quiet_NaN())},
                              Camera{.eye = Vec3(1), .target = Vec3(1)}, Camera{.fov_y_degrees = 0}}) {
        session.camera = bad;
        engine.set_session(session);
        ASSERT_TRUE(settle(engine));
        EXPECT_EQ(engine.state().camera, good);
        EXPECT_EQ(engine.state().generation, generation) << "nothing was done again";
    }
}

TEST(Engine, APictureWithoutPixelsIsNotAskedFor) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = engine.state().session;
    session.width = 0;
    session.height = -5;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().picture->image.width, 64);
    EXPECT_EQ(engine.state().picture->image.height, 48);
}

TEST(Engine, OtherColoursDoNotTraceAgain) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const auto frame = engine.state().picture->traced.frame;
    Session session = engine.state().session;
    session.view.heat.colormap = "magma";
    engine.set_session(session);
    EXPECT_TRUE(engine.state().stale());
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().picture->traced.frame, frame);
    EXPECT_EQ(engine.state().picture->view.heat.colormap, "magma");
}

TEST(Engine, ACancelledBuildKeepsTheTreeBefore) {
    Session session = small_session("scatter:60000");
    session.build.builder = "spatial-median";
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    const auto world = engine.state().world;
    session = engine.state().session;
    session.build.builder = "paper";
    engine.set_session(session);
    ASSERT_TRUE(engine.state().building.active);
    EXPECT_EQ(engine.state().picture->traced.world, world) << "the old tree stays shown";
    const double built_ms = engine.state().last_build_ms;
    engine.cancel_build();
    EXPECT_FALSE(engine.state().building.active) << "cancelled at once, whatever the thread is at";
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().world, world);
    EXPECT_EQ(engine.state().last_build_ms, built_ms) << "no other tree was ever taken over";
    EXPECT_EQ(engine.state().session.build.builder, "spatial-median");
}

TEST(Engine, ReadsThePixelsThatTheFrameHolds) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.set_probes(PixelPosition{32, 24}, PixelPosition{1, 2});
    const EngineState& state = engine.state();
    const Frame& frame = *state.picture->traced.frame;
    ASSERT_TRUE(state.hovered && state.pinned);
    EXPECT_EQ(state.hovered->primary().counters, frame.layer(Pass::rt_prim).counters.at(32, 24));
    EXPECT_EQ(state.pinned->primary().hit.triangle, frame.layer(Pass::rt_prim).hit.at(1, 2).triangle);
    EXPECT_TRUE(state.ray_cells.empty());
    engine.set_probes(PixelPosition{64, 0}, std::nullopt);
    EXPECT_FALSE(engine.state().hovered) << "outside";
    EXPECT_FALSE(engine.state().pinned);
}

/// The ray through the middle of a pixel of a 64 x 48 picture.
Ray ray_through(const Camera& camera, PixelPosition pixel) {
    const PinholeCamera p = pinhole(camera, 64, 48);
    const float x = (float(pixel.x) + 0.5f) * 2 / 64 - 1;
    const float y = 1 - (float(pixel.y) + 0.5f) * 2 / 48;
    return {camera.eye, glm::normalize(p.forward + x * p.right + y * p.up), 0, 1e30f, -1};
}

/// Boxes of the leaves among the lines, in their order: a leaf's outline is twelve lines.
std::vector<Aabb> leaf_boxes(const KdTree& tree, const std::vector<WorldLine>& lines) {
    std::vector<Aabb> boxes;
    int node = -1;
    for (const WorldLine& line : lines) {
        if (!tree.nodes[std::size_t(line.node)].is_leaf()) continue;
        if (line.node != node) boxes.emplace_back();
        node = line.node;
        boxes.back().include(line.a);
        boxes.back().include(line.b);
    }
    return boxes;
}

/// Where the ray is deepest before its way through the box begins.
float entry(const Ray& ray, const Aabb& box) {
    float near = 0;
    for (int axis = 0; axis < 3; ++axis)
        near = std::max(near, std::min((box.lower[axis] - ray.origin[axis]) / ray.direction[axis],
                                       (box.upper[axis] - ray.origin[axis]) / ray.direction[axis]));
    return near;
}

TEST(Engine, ShowsTheCellsOfARayWithTheSplits) {
    Session session = small_session();
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    engine.set_probes(PixelPosition{32, 24}, std::nullopt);
    EXPECT_TRUE(engine.state().ray_cells.empty()) << "no splits, no cells";
    session = engine.state().session;
    session.view.overlay.show = true;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    for (const PixelPosition pixel : {PixelPosition{32, 24}, PixelPosition{20, 30}, PixelPosition{40, 13}}) {
        engine.set_probes(pixel, std::nullopt);
        const EngineState& state = engine.state();
        ASSERT_TRUE(state.hovered);
        for (const ScreenLine& line : state.ray_cells) {
            EXPECT_TRUE(line.x0 > -0.01f && line.x0 < 64.01f && line.x1 > -0.01f && line.x1 < 64.01f);
            EXPECT_TRUE(line.y0 > -0.01f && line.y0 < 48.01f && line.y1 > -0.01f && line.y1 < 48.01f);
        }
        const Ray ray = ray_through(state.camera, pixel);
        const PassReading& read = state.hovered->primary();
        ASSERT_GE(read.hit.triangle, 0);
        const std::vector<WorldLine> lines = lines_along_ray(state.world->tree, ray, read.hit.t);
        EXPECT_FALSE(state.ray_cells.empty());
        EXPECT_LE(state.ray_cells.size(), lines.size()) << "those out of the picture are not drawn";
        const std::vector<Aabb> leaves = leaf_boxes(state.world->tree, lines);
        EXPECT_EQ(leaves.size(), read.counters.leaves) << "as many as the ray visited";
        for (std::size_t i = 1; i < leaves.size(); ++i)
            EXPECT_GE(entry(ray, leaves[i]), entry(ray, leaves[i - 1]) - 1e-4f) << "leaf " << i << " comes later";
    }
}

TEST(Engine, StepsThroughTheLeavesThatWereCounted) {
    for (const char* scene : {"ball:300", "rooms"})
        for (const Rules rules : {Rules::robust, Rules::as_published}) {
            Session session = small_session();
            session.scene = scene;
            session.trace.rules = rules;
            Engine engine(session, quiet());
            ASSERT_TRUE(settle(engine));
            for (const PixelPosition pixel : {PixelPosition{32, 24}, PixelPosition{20, 30}, PixelPosition{40, 13}}) {
                engine.set_probes(std::nullopt, pixel);
                EXPECT_FALSE(engine.state().step) << "nobody stepped";
                const int visited = int(engine.state().pinned->primary().counters.leaves);
                ASSERT_GT(visited, 0);
                float end = 0;
                for (int i = 0; i < visited; ++i) {
                    engine.set_probes(std::nullopt, pixel, i);
                    const std::optional<StepReading>& step = engine.state().step;
                    ASSERT_TRUE(step);
                    EXPECT_EQ(step->number, i);
                    EXPECT_EQ(step->count, visited);
                    EXPECT_TRUE(engine.state().world->tree.nodes[std::size_t(step->leaf.node)].is_leaf());
                    if (std::isnan(step->leaf.enters)) continue;
                    EXPECT_GE(step->leaf.enters, end);
                    end = step->leaf.leaves;
                }
                const Hit& hit = engine.state().pinned->primary().hit;
                const bool ends = hit.triangle >= 0 && rules == Rules::robust;
                EXPECT_TRUE(!ends || std::abs(end - hit.t) <= 1e-5f * hit.t) << "it ends at its hit";
                engine.set_probes(std::nullopt, pixel, visited + 5);
                EXPECT_EQ(engine.state().step->number, visited - 1) << "no farther than the last";
            }
        }
}

TEST(Engine, WithoutAGpuTheCpuTracesAndOneLineSaysWhy) {
    Session session = small_session();
    session.tracer = TracerKind::gl_fragment;
    EngineOptions options = quiet();
    options.open_gl = []() -> std::unique_ptr<Context> { throw ContextError("this machine has none"); };
    Engine engine(session, options);
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "this machine has none"));
    EXPECT_EQ(engine.state().session.tracer, TracerKind::cpu);
    EXPECT_FALSE(engine.state().gl.available());
}

TEST(Engine, MeasuresTheSameFrameAgainAndAgainWhileIdle) {
    EngineOptions options = quiet();
    options.duel = true;
    Engine engine(small_session(), options);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.duel.rounds.size() >= 2; }));
    const DuelState& duel = engine.state().duel;
    EXPECT_EQ(duel.width * duel.scale, 64) << "a slow machine times smaller frames";
    EXPECT_EQ(duel.cpu.samples, int(duel.rounds.size()));
    EXPECT_GT(duel.cpu.median_ms, 0);
    EXPECT_LT(duel.rounds.back().gl.ms, 0) << "no GPU here";
    EXPECT_LT(duel.gl_setup.upload_ms, 0);
    EXPECT_LT(duel.gl_setup.compile_ms, 0);
    EXPECT_GE(duel.rays, duel.width * duel.height);
    engine.note_input();
    EXPECT_FALSE(engine.state().duel.running);
}

TEST(Engine, ARoundTimesPassesAndNamesItsClocks) {
    EngineOptions options = quiet();
    options.duel = true;
    options.open_gl = [] { return Context::create(ContextKind::automatic); };
    Engine engine(small_session("cornell"), options);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.gl.known; }));
    if (!engine.state().gl.available()) GTEST_SKIP() << "NO CONTEXT: " << engine.state().gl.unavailable;
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.duel.decided(); }));
    const DuelState& duel = engine.state().duel;
    for (const DuelRound& round : duel.rounds) {
        double sum = 0;
        for (const double ms : round.gl.pass_ms) sum += std::max(ms, 0.0);
        EXPECT_GT(round.gl.pass_ms[0], 0);
        EXPECT_GT(sum, 0);
        EXPECT_LE(sum, round.gl.ms * (1 + 1e-9));
    }
    for (const TimeSummary& time : {duel.cpu, duel.gl}) {
        EXPECT_EQ(time.samples, int(duel.rounds.size()));
        EXPECT_GT(time.p25_ms, 0);
        EXPECT_LE(time.p25_ms, time.median_ms);
        EXPECT_LE(time.median_ms, time.p75_ms);
        EXPECT_DOUBLE_EQ(duel.mrays_per_s(time), double(duel.rays) / time.median_ms / 1000);
    }
    EXPECT_EQ(duel.mrays_per_s({}), 0);
    EXPECT_EQ(duel.cpu_clock, "steady clock");
    EXPECT_EQ(duel.gl_clock, engine.state().gl.software ? "finish + steady clock" : "timer query");
    EXPECT_EQ(engine.state().picture->traced.clock, "steady clock") << "the picture is the CPU's";

    // Programs are made once: prepared for round after round, they keep the time that they took.
    const SetupTimes setup = duel.gl_setup;
    EXPECT_GT(setup.upload_ms, 0);
    EXPECT_GT(setup.compile_ms, 0);
    const std::size_t rounds = duel.rounds.size();
    ASSERT_TRUE(wait_until(engine, [&](const EngineState& s) { return s.duel.rounds.size() >= rounds + 2; }));
    EXPECT_EQ(engine.state().duel.gl_setup.upload_ms, setup.upload_ms);
    EXPECT_EQ(engine.state().duel.gl_setup.compile_ms, setup.compile_ms);
    // Another tree is uploaded anew, and its programs are those of before.
    Session session = engine.state().session;
    session.build.leaf_size = 9;
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [&](const EngineState& s) {
        return !s.duel.outdated && s.duel.gl_setup.upload_ms != setup.upload_ms;
    }));
    EXPECT_EQ(engine.state().duel.gl_setup.compile_ms, setup.compile_ms);
}

TEST(Engine, EndsAtOnceInTheMiddleOfWork) {
    // The whole frame is hours of work: where it were not given up, this test would end by its time limit.
    Session session = small_session("ball:20000");
    session.trace.traversal = Traversal::naive;
    session.width = session.height = 8000;
    Engine engine(session, quiet());
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.tracing.active; }));
    EXPECT_TRUE(engine.state().stale()) << "there is work left to be given up";
}

TEST(Engine, AFileThatIsChosenIsLoadedAndABadOneIsNot) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = engine.state().session;
    session.scene = std::string(KD_SOURCE_DIR) + "/assets/scenes/lantern.gltf";  // as a dropped file's path
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().world->loaded->name, session.scene);
    session.scene = std::string(KD_SOURCE_DIR) + "/README.md";
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return has_error(s, "README.md"); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().session.scene, engine.state().world->loaded->name) << "the file before stays";
}

}  // namespace
}  // namespace kd

// The engine's stage between frame and picture: hits against double precision, where a map asks for it.
#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

#include "app/engine/judging.h"
#include "app/scenes.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "tests/app/engine_run.h"

namespace kd {
namespace {

TEST(EngineOracle, ComparesWithTheOracleWhereTheMapAsks) {
    Session session = small_session("rooms");
    session.trace.rules = Rules::as_published;
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().judged(), nullptr) << "costs only where asked for";
    session.view.map.map = "oracle";
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    const JudgedLayer* judged = engine.state().judged();
    ASSERT_NE(judged, nullptr);
    EXPECT_EQ(judged->compared(), 64 * 48);
    EXPECT_GT(judged->wrong(), 0);
    ASSERT_TRUE(engine.state().picture->map);
    EXPECT_EQ(engine.state().picture->map->category_pixels[std::size_t(HitVerdict::missed)],
              judged->counts[std::size_t(HitVerdict::missed)]);

    const auto wrong = next_wrong_place(*judged, {}, false);
    ASSERT_TRUE(wrong);
    EXPECT_EQ(place_number(*judged, *wrong), 1);
    const auto other = next_wrong_place(*judged, wrong, false);
    ASSERT_TRUE(other);
    EXPECT_GT(std::max(std::abs(other->x - wrong->x), std::abs(other->y - wrong->y)), 8) << "leads elsewhere";
    EXPECT_EQ(next_wrong_place(*judged, other, true), wrong);
    EXPECT_EQ(place_number(*judged, {wrong->x + 1, wrong->y}), 0);
    engine.set_probes({}, wrong);
    ASSERT_TRUE(engine.state().pinned && engine.state().pinned->oracle);
    const OracleReading& reading = *engine.state().pinned->oracle;
    EXPECT_TRUE(is_wrong(reading.judged.verdict));
    EXPECT_EQ(reading.ray.origin, engine.state().camera.eye);

    session.trace.rules = Rules::robust;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    ASSERT_NE(engine.state().judged(), nullptr);
    EXPECT_EQ(engine.state().judged()->wrong(), 0) << "another frame is compared anew";
    EXPECT_FALSE(engine.state().judging.active);
}

TEST(EngineOracle, ACameraOnTheMoveEndsComparisonsOfFramesBefore) {
    Session session = small_session("rooms");
    session.view.map.map = "oracle";
    session.width = 200;
    session.height = 150;
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    Camera camera = engine.state().camera;
    for (int i = 0; i < 30; ++i) {
        camera.eye.x += 0.01f;
        session.camera = camera;
        engine.set_session(session);
        engine.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_TRUE(settle(engine));
    ASSERT_NE(engine.state().judged(), nullptr);
    EXPECT_EQ(engine.state().picture->traced.camera.eye, camera.eye);
    EXPECT_EQ(engine.state().judged()->wrong(), 0);
}

TEST(EngineOracle, PreviewsAreComparedByTheRaysThatTheyWereTracedBy) {
    // 203 x 151 in steps of 8 is 26 x 19: another shape.
    const auto loaded = std::make_shared<LoadedScene>();
    loaded->flat = load_scene("ball:300", 1);
    const auto world = std::make_shared<World>();
    world->loaded = loaded;
    world->tree = build_tree(world->scene().triangles, {});
    const auto frame = std::make_shared<Frame>(26, 19);
    TracedFrame traced;
    traced.world = world;
    traced.camera = world->scene().camera;
    traced.lens = pinhole(traced.camera, 203, 151);
    traced.scale = 8;
    CpuTracer(world->scene(), world->tree).trace_frame({}, traced.lens, *frame, 1);
    traced.frame = frame;
    std::shared_ptr<const JudgedLayer> judged;
    Judging().judge(traced, Pass::rt_prim, 1, {}, [&](auto layer) { judged = std::move(layer); }, {});
    ASSERT_NE(judged, nullptr);
    EXPECT_EQ(judged->compared(), 26 * 19);
    EXPECT_EQ(judged->wrong(), 0);
    EXPECT_EQ(judged->counts[std::size_t(HitVerdict::agrees)], judged->compared());
}

TEST(EngineOracle, ShadowRaysAreNotComparedAndTheViewGoesBack) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = small_session();
    session.view.map = {.map = "oracle", .rays = Pass::shade_prim};
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.messages.empty(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "choose primary or reflection rays"));
    EXPECT_EQ(engine.state().session.view.map.map, "nodes");
}

}  // namespace
}  // namespace kd

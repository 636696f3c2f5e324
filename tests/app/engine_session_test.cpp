// Session files opened in the window's engine: camera in the scene's units, the old state where something is wrong.
#include "app/session_file.h"
#include "renderer/io/file.h"
#include "renderer/scene/units.h"
#include "tests/app/cli_run.h"
#include "tests/app/engine_run.h"

namespace kd {
namespace {

const std::string square = std::string(KD_SOURCE_DIR) + "/tests/fixtures/app/large_square.gltf";

/// Another scene, 2^20 times as large as usual, seen by a camera in its own units.
Session large_session() {
    Session session;
    session.scene = square;
    session.camera = Camera{Vec3(100000, 0, 2500000), Vec3(0), Vec3(0, 1, 0), 40};
    session.trace.traversal = Traversal::restart;
    session.view.map.map = "leaves";
    session.threads = 1;
    session.width = 333;  // which the window has its own of
    return session;
}

void expect_large_session(const EngineState& state) {
    Session wanted = large_session();
    wanted.width = 64;
    wanted.height = 48;
    EXPECT_NE(state.world->scene().exponent, 0);
    EXPECT_EQ(in_scene_units(state.session, state.world->scene()), wanted);
    EXPECT_EQ(to_scene_units(state.world->scene(), state.picture->traced.camera), *wanted.camera);
}

TEST(EngineSession, TheCameraComesWithItsScene) {
    const test::TestFolder folder;
    write_session(folder.file("a.session.json"), large_session());
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.open_session(folder.file("a.session.json"));
    ASSERT_TRUE(settle(engine));
    expect_large_session(engine.state());

    Session moved = engine.state().session;
    moved.camera.reset();
    moved.trace.traversal = Traversal::stack;
    engine.set_session(moved);
    ASSERT_TRUE(settle(engine));
    engine.open_session(folder.file("a.session.json"));  // of the scene that is there
    ASSERT_TRUE(settle(engine));
    expect_large_session(engine.state());
}

TEST(EngineSession, OneOpenedWhileItsSceneIsBeingLoadedIsCompleteToo) {
    const test::TestFolder folder;
    write_session(folder.file("a.session.json"), large_session());
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session wish = engine.state().session;
    wish.scene = square;
    engine.set_session(wish);
    engine.open_session(folder.file("a.session.json"));
    ASSERT_TRUE(settle(engine));
    expect_large_session(engine.state());
}

TEST(EngineSession, ACameraThatCannotBeUsedIsToldWhetherItsSceneIsThereOrNot) {
    const test::TestFolder folder;
    Session far = large_session();
    far.camera = Camera{Vec3(1e-42f, 0, 0), Vec3(0), Vec3(0, 1, 0), 40};  // both are 0 in the scene's own units
    write_session(folder.file("a.json"), far);
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    for (const char* scene : {"not there", "there"}) {
        SCOPED_TRACE(scene);
        engine.dismiss_messages();
        engine.open_session(folder.file("a.json"));
        ASSERT_TRUE(settle(engine));
        EXPECT_TRUE(has_error(engine.state(), "camera: its values cannot be used with this scene"));
        EXPECT_FALSE(engine.state().session.camera);
    }
}

TEST(EngineSession, ABadOneLeavesEverythingAsItWas) {
    const test::TestFolder folder;
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session before = engine.state().session;
    before.camera = engine.state().camera;
    before.camera->eye.x += 0.25f;
    engine.set_session(before);
    ASSERT_TRUE(settle(engine));

    write_file(folder.file("bad.json"), R"({"kdscope_session": 1, "settings": {"seed": "x"}})");
    engine.open_session(folder.file("bad.json"));
    EXPECT_TRUE(has_error(engine.state(), "/settings/seed"));
    ASSERT_TRUE(engine.state().refused);
    EXPECT_EQ(engine.state().refused->name, folder.file("bad.json"));
    EXPECT_EQ(engine.state().session, before);

    Session lost = large_session();
    lost.scene = "bal:300";  // which turns out only when it is loaded
    write_session(folder.file("lost.json"), lost);
    engine.open_session(folder.file("lost.json"));
    EXPECT_FALSE(has_error(engine.state(), "/settings/seed")) << "there is another wish";
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.refused.has_value(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "lost.json: /settings/scene: scene 'bal:300'"));
    EXPECT_EQ(engine.state().session, before);
}

}  // namespace
}  // namespace kd

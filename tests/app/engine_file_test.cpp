// What the window does with files: bad ones leave the old scene, and what a file lost is told.
#include "tests/app/engine_run.h"

namespace kd {
namespace {

const std::string corpus = std::string(KD_SOURCE_DIR) + "/tests/fuzz/corpus/gltf/";

TEST(EngineFile, ABadFileLeavesTheOldSceneAndItsPicture) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const Image<Rgba8> before = engine.state().picture->image;
    for (const char* bad : {"empty.gltf", "points.glb", "no-such-file.glb"}) {
        Session session = engine.state().session;
        session.scene = corpus + bad;
        engine.set_session(session);
        ASSERT_TRUE(wait_until(engine, [&](const EngineState& s) { return has_error(s, bad); })) << bad;
        ASSERT_TRUE(settle(engine));
        EXPECT_EQ(engine.state().session.scene, "ball:300") << bad;
        EXPECT_EQ(engine.state().picture->image, before) << bad;
        EXPECT_EQ(engine.state().messages.back().text.find('\n'), std::string::npos);
    }
}

TEST(EngineFile, ARefusedWishIsKnownUntilTheNextAndTakesNoCamera) {
    Session session = small_session();
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    session.camera = engine.state().camera;
    session.camera->eye.x += 0.25f;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_FALSE(engine.state().refused);

    Session wish = session;
    wish.scene = "bal:300";
    wish.camera.reset();
    engine.set_session(wish);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.refused.has_value(); }));
    ASSERT_TRUE(settle(engine));
    ASSERT_TRUE(engine.state().refused);
    EXPECT_EQ(engine.state().refused->name, "bal:300");
    EXPECT_EQ(engine.state().refused->why, engine.state().messages.back().text);
    EXPECT_EQ(engine.state().session, session) << "the camera, too, is as before";

    session.scene = "scatter:50";
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_FALSE(engine.state().refused);
}

TEST(EngineFile, WhatAFileLostIsTold) {
    Engine engine(small_session(corpus + "skinned.glb"), quiet());
    ASSERT_TRUE(settle(engine));
    ASSERT_FALSE(engine.state().messages.empty());
    const Message& message = engine.state().messages.front();
    EXPECT_FALSE(message.error);
    EXPECT_NE(message.text.find("ignored 1 animation channel, whose times are not SCALAR of float"), std::string::npos);
    EXPECT_FALSE(engine.state().world->scene().notes.empty()) << "what the panel SCENE lists";
}

}  // namespace
}  // namespace kd

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

TEST(EngineFile, WhatAFileLostIsTold) {
    Engine engine(small_session(corpus + "skinned.glb"), quiet());
    ASSERT_TRUE(settle(engine));
    ASSERT_FALSE(engine.state().messages.empty());
    const Message& message = engine.state().messages.front();
    EXPECT_FALSE(message.error);
    EXPECT_NE(message.text.find("shown skins, morph targets and animations in their static pose"), std::string::npos);
    EXPECT_FALSE(engine.state().world->scene().notes.empty()) << "what the panel SCENE lists";
}

}  // namespace
}  // namespace kd

// What the engine does when OpenGL fails; faults by their number in docs/stability.md.
#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <thread>

#include "tests/app/engine_run.h"
#include "tests/support/faulty_shaders.h"

namespace kd {
namespace {

using namespace std::chrono_literals;

class EngineGlFaults : public testing::Test {
  protected:
    void SetUp() override {
        try {
            (void)Context::create(ContextKind::automatic);
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
    }
    void TearDown() override {
        unsetenv("KDSCOPE_FAULT");
        unsetenv("KD_SHADER_DIR");
    }

    std::unique_ptr<Engine> start(TracerKind tracer) {
        session.tracer = tracer;
        EngineOptions options;
        options.duel = false;
        options.open_gl = [this] {
            ++opened;
            return Context::create(ContextKind::automatic);
        };
        return std::make_unique<Engine>(session, options);
    }

    /// Reads shaders from a folder where `file` has `to` instead of `from`.
    static void change_shader(const std::string& file, const std::string& from, const std::string& to) {
        setenv("KD_SHADER_DIR", test::shaders_with(file, from, to).c_str(), 1);
    }

    static bool settle(Engine& engine) {
        return wait_until(engine, [](const EngineState& s) { return !s.stale() && !s.working() && s.gl.known; });
    }

    static int messages_with(const EngineState& state, const std::string& part) {
        int count = 0;
        for (const Message& message : state.messages) count += message.text.find(part) != std::string::npos;
        return count;
    }

    Session session = small_session();
    std::atomic<int> opened = 0;
};

TEST_F(EngineGlFaults, F03_AShaderThatFailsIsShownWithItsLineAndTheCpuGoesOn) {
    change_shader("opengl/scene_hooks.glsl", "#if KD_DUPLICATED\n", "#if KD_DUPLICATED\nnonsense();\n");
    const auto engine = start(TracerKind::gl_fragment);
    ASSERT_TRUE(settle(*engine));
    EXPECT_EQ(engine->state().picture->traced.tracer, TracerKind::gl_fragment) << "this shader is good";
    Session next = engine->state().session;
    next.trace.leaf_lists = LeafLists::duplicated;
    engine->set_session(next);
    ASSERT_TRUE(engine->state().picture) << "the picture before stays";
    ASSERT_TRUE(settle(*engine));
    EXPECT_EQ(messages_with(engine->state(), "shaders/opengl/scene_hooks.glsl:"), 1);
    EXPECT_EQ(engine->state().session.tracer, TracerKind::cpu);
    EXPECT_EQ(engine->state().picture->traced.config.leaf_lists, LeafLists::duplicated);
    EXPECT_EQ(engine->state().picture->traced.tracer, TracerKind::cpu);
    next = engine->state().session;
    next.trace.leaf_lists = LeafLists::references;
    next.tracer = TracerKind::gl_fragment;
    engine->set_session(next);
    ASSERT_TRUE(settle(*engine));
    EXPECT_EQ(engine->state().picture->traced.tracer, TracerKind::gl_fragment) << "the good one still is";
}

TEST_F(EngineGlFaults, F04_AGpuThatFailsTheSelfTestIsNotUsedAndABannerStays) {
    change_shader("opengl/rays.glsl", "leave_hit(pixel, hit)", "hit.t *= 1.001; leave_hit(pixel, hit)");
    for (const TracerKind tracer : {TracerKind::cpu, TracerKind::gl_fragment}) {
        const auto engine = start(tracer);
        ASSERT_TRUE(settle(*engine));
        EXPECT_EQ(engine->state().picture->traced.tracer, TracerKind::cpu);
        EXPECT_EQ(engine->state().session.tracer, TracerKind::cpu);
        EXPECT_FALSE(engine->state().gl.available());
        EXPECT_EQ(messages_with(engine->state(), "fails the self-test"), 1);
        EXPECT_TRUE(engine->state().messages.back().stays);
    }
}

TEST_F(EngineGlFaults, F06_MemoryThatRunsOutLeavesThePictureToTheCpu) {
    setenv("KDSCOPE_FAULT", "memory:200000", 1);
    const auto engine = start(TracerKind::gl_fragment);
    ASSERT_TRUE(settle(*engine));
    EXPECT_EQ(engine->state().picture->traced.tracer, TracerKind::gl_fragment);
    Session next = engine->state().session;
    next.scene = "ball:20000";
    engine->set_session(next);
    ASSERT_TRUE(settle(*engine));
    EXPECT_EQ(messages_with(engine->state(), "out of memory while uploading"), 1);
    EXPECT_EQ(engine->state().picture->traced.tracer, TracerKind::cpu);
    EXPECT_EQ(engine->state().world->loaded->name, "ball:20000");
}

TEST_F(EngineGlFaults, F08_ALostContextIsMadeAnewOnce) {
    setenv("KDSCOPE_FAULT", "lost:1", 1);
    const auto engine = start(TracerKind::gl_fragment);
    Session next = session;
    for (int i = 0; i < 6; ++i) {
        ASSERT_TRUE(settle(*engine));
        EXPECT_EQ(engine->state().picture->traced.tracer, TracerKind::gl_fragment);
        next.width = 65 + i;
        engine->set_session(next);
    }
    ASSERT_TRUE(settle(*engine));
    EXPECT_EQ(opened, 2);
    EXPECT_EQ(engine->state().gl.losses, 1);
    EXPECT_EQ(messages_with(engine->state(), "its context was made anew"), 1);
    EXPECT_EQ(engine->state().picture->image.width, 70);
}

TEST_F(EngineGlFaults, F08_ASecondLossWithinTenSecondsLeavesThePictureToTheCpu) {
    setenv("KDSCOPE_FAULT", "lost:2", 1);
    const auto engine = start(TracerKind::gl_fragment);
    Session next = session;
    for (int i = 0; i < 12 && engine->state().session.tracer != TracerKind::cpu; ++i) {
        ASSERT_TRUE(settle(*engine));
        next.width = 65 + i;
        engine->set_session(next);
    }
    ASSERT_TRUE(settle(*engine));
    EXPECT_EQ(engine->state().session.tracer, TracerKind::cpu);
    EXPECT_FALSE(engine->state().gl.available());
    EXPECT_EQ(opened, 2);
    EXPECT_EQ(messages_with(engine->state(), "twice within 10 s"), 1);
}

}  // namespace
}  // namespace kd

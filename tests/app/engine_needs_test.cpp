// Features put back and left out while the window goes on: programs are made in the background, once.
#include <cstring>

#include "tests/app/engine_run.h"

namespace kd {
namespace {

/// Of GL where there is some, and of the CPU.
class EngineNeeds : public testing::TestWithParam<TracerKind> {
  protected:
    void SetUp() override {
        if (GetParam() == TracerKind::cpu) return;
        try {
            (void)Context::create(ContextKind::automatic);
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
    }

    static std::unique_ptr<Engine> start() {
        Session session = small_session("cornell");
        session.tracer = GetParam();
        EngineOptions options = quiet();
        options.open_gl = [] { return Context::create(ContextKind::automatic); };
        auto engine = std::make_unique<Engine>(session, options);
        EXPECT_TRUE(patient_settle(*engine));
        return engine;
    }

    /// Compiling may take a while on a busy machine.
    static bool patient_settle(Engine& engine) { return settle(engine, 6 * test::patience()); }

    static bool force(Engine& engine, FeatureSet features) {
        Session session = engine.state().session;
        session.trace.forced = features;
        engine.set_session(session);
        return patient_settle(engine);
    }

    static std::vector<Vec4> colours(const Engine& engine) {
        return engine.state().picture->traced.frame->colour.pixels;
    }
};
INSTANTIATE_TEST_SUITE_P(Tracers, EngineNeeds, testing::Values(TracerKind::cpu, TracerKind::gl_fragment),
                         [](const auto& test) { return test.param == TracerKind::cpu ? "cpu" : "gl"; });

TEST_P(EngineNeeds, PutBackChangesNoPixel) {
    const auto engine = start();
    const std::vector<Vec4> without = colours(*engine);
    EXPECT_FALSE(engine->state().picture->traced.needs.textures);
    ASSERT_TRUE(force(*engine, Feature::textures));
    EXPECT_TRUE(engine->state().picture->traced.needs.textures);
    const std::vector<Vec4> with = colours(*engine);
    ASSERT_EQ(with.size(), without.size());
    EXPECT_EQ(std::memcmp(with.data(), without.data(), with.size() * sizeof(Vec4)), 0);
}

TEST_P(EngineNeeds, ProgramsAreMadeOnceWhileTheOldPictureStays) {
    if (GetParam() == TracerKind::cpu) GTEST_SKIP() << "the CPU makes no programs";
    const auto engine = start();
    const int first = engine->state().compiled;
    EXPECT_GT(first, 0);
    EXPECT_EQ(engine->state().compiling, 0);

    const auto before = engine->state().picture;
    Session session = engine->state().session;
    session.trace.forced = Feature::textures;
    engine->set_session(session);
    // Nobody waits: poll() comes back while programs are being made, and the picture before is there.
    ASSERT_TRUE(wait_until(*engine, [&](const EngineState& s) {
        if (s.compiling > 0) {
            EXPECT_TRUE(s.stale() && s.picture == before);
        }
        EXPECT_NE(s.picture, nullptr);
        return s.compiled > first && s.compiling == 0;
    }));
    ASSERT_TRUE(patient_settle(*engine));
    EXPECT_EQ(engine->state().compiling, 0);
    const int second = engine->state().compiled;
    EXPECT_GT(second, first);

    ASSERT_TRUE(force(*engine, {}));
    ASSERT_TRUE(force(*engine, Feature::textures));
    EXPECT_EQ(engine->state().compiled, second) << "both are kept";
}

TEST_P(EngineNeeds, WhatIsLeftOutIsTimedWhenAskedFor) {
    const auto engine = start();
    EXPECT_TRUE(engine->state().needs.times.empty());
    engine->measure_needs();
    EXPECT_TRUE(engine->state().needs.active);
    ASSERT_TRUE(wait_until(
        *engine, [](const EngineState& s) { return !s.needs.active; }, 12 * test::patience()));
    const EngineState& state = engine->state();
    EXPECT_EQ(state.needs.error, "");
    EXPECT_EQ(state.needs.times.size(),
              removable(state.world->facts, state.session.trace, GetParam() == TracerKind::cpu).size());
    EXPECT_FALSE(state.needs_outdated());
    ASSERT_TRUE(force(*engine, Feature::normals));
    EXPECT_FALSE(engine->state().needs_outdated()) << "each was timed alone, whatever is put back now";
    Session session = engine->state().session;
    session.width = 80;
    engine->set_session(session);
    EXPECT_TRUE(engine->state().needs_outdated());
}

TEST_P(EngineNeeds, AChangeEndsTheMeasurement) {
    const auto engine = start();
    engine->measure_needs();
    Session session = engine->state().session;
    session.trace.traversal = Traversal::restart;
    engine->set_session(session);
    EXPECT_FALSE(engine->state().needs.active);
    ASSERT_TRUE(patient_settle(*engine));
    EXPECT_TRUE(engine->state().needs.times.empty());
    engine->measure_needs();
    engine->cancel_needs();
    EXPECT_FALSE(engine->state().needs.active);
    EXPECT_TRUE(patient_settle(*engine));
}

}  // namespace
}  // namespace kd

// Features put back and left out while the window goes on: programs are made in the background, once.
#include <condition_variable>
#include <cstring>
#include <functional>
#include <mutex>

#include "tests/app/engine_run.h"

namespace kd {
namespace {

/// Why there is no OpenGL; empty where there is.
std::string no_context() {
    try {
        (void)Context::create(ContextKind::automatic);
        return "";
    } catch (const ContextError& error) {
        return error.what();
    }
}

/// Compiling may take a while on a busy machine.
bool patient_settle(Engine& engine) { return settle(engine, 6 * test::patience()); }

std::unique_ptr<Engine> start_engine(TracerKind tracer, std::function<void()> wake = {}) {
    Session session = small_session("cornell");
    session.tracer = tracer;
    EngineOptions options = quiet();
    options.open_gl = [] { return Context::create(ContextKind::automatic); };
    options.wake = std::move(wake);
    auto engine = std::make_unique<Engine>(session, options);
    EXPECT_TRUE(patient_settle(*engine));
    return engine;
}

bool force(Engine& engine, FeatureSet features) {
    Session session = engine.state().session;
    session.trace.forced = features;
    engine.set_session(session);
    return patient_settle(engine);
}

/// Of GL where there is some, and of the CPU.
class EngineNeeds : public testing::TestWithParam<TracerKind> {
  protected:
    void SetUp() override {
        if (GetParam() == TracerKind::cpu) return;
        if (const std::string why = no_context(); !why.empty()) GTEST_SKIP() << "NO CONTEXT: " << why;
    }

    static std::unique_ptr<Engine> start() { return start_engine(GetParam()); }

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
              timed_features(state.world->facts, state.session.trace, GetParam() == TracerKind::cpu).size());
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

/// Holds threads that bring news until it is opened.
class Gate {
  public:
    void close() {
        const std::scoped_lock lock(mutex_);
        open_ = false;
    }
    void open() {
        const std::scoped_lock lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }
    void pass() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return open_; });
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = true;
};

TEST(EngineNeedsGl, ProgramsAreMadeOnceWhileTheOldPictureStays) {
    if (const std::string why = no_context(); !why.empty()) GTEST_SKIP() << "NO CONTEXT: " << why;
    Gate gate;
    const auto engine = start_engine(TracerKind::gl_fragment, [&] { gate.pass(); });
    const int first = engine->state().compiled;
    EXPECT_GT(first, 0);
    EXPECT_EQ(engine->state().compiling, 0);

    // The tracing thread tells that it compiles, and is held there.
    const auto before = engine->state().picture;
    gate.close();
    Session session = engine->state().session;
    session.trace.forced = Feature::textures;
    engine->set_session(session);
    const bool compiles = wait_until(
        *engine, [](const EngineState& s) { return s.compiling > 0; }, 6 * test::patience());
    for (int i = 0; i < 20; ++i) engine->poll();
    EXPECT_TRUE(compiles);
    EXPECT_TRUE(engine->state().stale());
    EXPECT_EQ(engine->state().picture, before);
    gate.open();
    ASSERT_TRUE(patient_settle(*engine));
    EXPECT_NE(engine->state().picture, before);
    EXPECT_EQ(engine->state().compiling, 0);
    const int second = engine->state().compiled;
    EXPECT_GT(second, first);

    ASSERT_TRUE(force(*engine, {}));
    ASSERT_TRUE(force(*engine, Feature::textures));
    EXPECT_EQ(engine->state().compiled, second) << "both are kept";
}

}  // namespace
}  // namespace kd

// Light by samples in the engine: pictures that grow while nothing changes.

#include <cmath>
#include <glm/geometric.hpp>

#include "app/frame/sampled_frame.h"
#include "tests/app/engine_run.h"

namespace kd {
namespace {

Session sampled(int samples) {
    Session session = small_session("cornell");
    session.view.show_map = false;
    session.samples = samples;
    return session;
}

TEST(EngineLight, GathersAllSamplesAndShowsTheirMean) {
    Engine engine(sampled(40), quiet());
    const auto whole = [](const EngineState& s) {
        return s.picture && s.picture->traced.samples && s.picture->traced.samples->samples == 40;
    };
    ASSERT_TRUE(wait_until(engine, whole));
    ASSERT_TRUE(settle(engine));
    const EngineState& state = engine.state();
    ASSERT_TRUE(whole(state)) << "nothing older comes after it";

    // The same as without a window.
    const World& world = *state.world;
    const auto tracer = make_frame_tracer(TracerKind::cpu, world.scene(), world.tree, 2, {});
    const SampledFrame alone = trace_samples(*tracer, first_sample(state.session), state.picture->traced.lens,
                                             state.session.width, state.session.height, {40, 0});
    EXPECT_TRUE(same_frame(*state.picture->traced.frame, alone.frame));
    EXPECT_EQ(state.picture->traced.samples->error, alone.count.error);
}

TEST(EngineLight, EndsEarlyWhereEverythingHasConverged) {
    Session session = sampled(1 << 20);
    session.sample_error = 1.0f;
    Engine engine(session, quiet());
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) {
        const auto* count = s.picture && s.picture->traced.samples ? &*s.picture->traced.samples : nullptr;
        return count && count->samples == Accumulator::fewest_samples && count->converged_tiles == count->tiles;
    }));
    ASSERT_TRUE(settle(engine)) << "nothing goes on";
}

TEST(EngineLight, AChangeBeginsAnewAndOffIsThePapersPicture) {
    Engine plain(sampled(0), quiet());
    ASSERT_TRUE(settle(plain));
    Engine engine(sampled(1 << 20), quiet());
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) {
        return s.picture && s.picture->traced.samples && s.picture->traced.samples->samples > 3;
    }));
    Session session = engine.state().session;
    session.samples = 0;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_FALSE(engine.state().picture->traced.samples);
    EXPECT_EQ(engine.state().picture->image, plain.state().picture->image);
}

/// Root mean square difference of colours.
double rmse(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.colour.pixels.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(a.colour.pixels[i]) - glm::dvec3(b.colour.pixels[i]);
        sum += glm::dot(d, d);
    }
    return std::sqrt(sum / (3.0 * double(a.colour.pixels.size())));
}

TEST(EngineLight, FramesOfErrorDrawLightOfTheirOwn) {
    Engine engine(sampled(1), quiet());
    ASSERT_TRUE(settle(engine));
    const Frame one = *engine.state().picture->traced.frame;
    engine.sample_picture(Sampler::regular);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.convergence.samples >= 64; }));
    engine.stop_sampling();
    ASSERT_TRUE(settle(engine));
    const EngineState& state = engine.state();
    const World& world = *state.world;
    const auto tracer = make_frame_tracer(TracerKind::cpu, world.scene(), world.tree, 2, {});
    const SampledFrame many = trace_samples(*tracer, first_sample(state.session), state.picture->traced.lens,
                                            state.session.width, state.session.height, {256, 0});
    // Edges are smooth in one and not in the other, so that they never become equal; one sample is all grain.
    EXPECT_LT(rmse(*state.picture->traced.frame, many.frame), 0.6 * rmse(one, many.frame));
}

}  // namespace
}  // namespace kd

#include "app/engine/convergence.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "app/choices.h"
#include "app/cli/error_text.h"
#include "app/engine/engine.h"
#include "app/tracer_choices.h"
#include "renderer/trace/walk_choices.h"

namespace kd {

namespace {

constexpr int strata = 16;  // cells of a stratified set
constexpr double quiet_before_sample_s = 0.3;
constexpr std::size_t most_curves = 12;

/// All of the session that makes the picture, but for how it is traced.
Session picture_of(Session session) {
    session.trace.traversal = Traversal::stack;
    session.trace.rules = Rules::robust;
    session.trace.leaf_lists = LeafLists::references;
    session.trace.step_budget = 0;
    session.trace.packet_size = TraceConfig{}.packet_size;
    session.tracer = TracerKind::cpu;
    session.early_z = EarlyZ::working;
    session.build = {};
    session.view = {};
    session.threads = 0;
    return session;
}

/// All of the session that a frame's time depends on, but for the camera.
Session configuration_of(Session session) {
    session.view = {};
    session.camera.reset();
    return session;
}

double steps_per_pixel(const Frame& frame) {
    double steps = 0;
    for (const RayLayer& layer : frame.layers)
        for (const RayCounters& c : layer.counters.pixels)
            steps += double(c.interior_first) + double(c.interior_again) + double(c.leaves);
    return steps / double(std::max<std::size_t>(frame.colour.pixels.size(), 1));
}

std::string how_text(const Session& s) {
    std::string text = fmt::format("{}, {}", info(s.trace.traversal).name, tracer_text(s.tracer, s.trace));
    if (const Rules rules = rules_in_force(s.trace); rules != Rules::robust)
        text += fmt::format(", {}", info(rules).name);
    return text;
}

}  // namespace

std::string ConvergenceCurve::name() const {
    const std::string& builder = session.build.builder;
    return fmt::format("{}, {}{}", name_of(sampler), how_text(session),
                       builder == BuildConfig{}.builder ? "" : ", " + builder);
}

std::string TriedConfiguration::name() const {
    return fmt::format("{}, {}, {}", session.scene, session.build.builder, how_text(session));
}

void ConvergenceState::note_tried(const Session& session, double steps, const TimeSummary& time, bool is_counted) {
    const auto same = [&](const TriedConfiguration& t) {
        return configuration_of(t.session) == configuration_of(session);
    };
    auto found = std::ranges::find_if(tried, same);
    if (found == tried.end()) {
        if (tried.size() == most_tried) tried.erase(tried.begin());
        found = tried.insert(tried.end(), TriedConfiguration{});
    }
    // Rounds of another camera are no rounds of this frame.
    const bool other_view = found->session.camera != session.camera;
    found->session = session;
    found->steps_per_pixel = steps;
    if (!is_counted || found->counted || other_view) {
        found->time = time;
        found->counted = is_counted;
    }
}

void Convergence::start(Sampler sampler) {
    state_.active = true;
    const bool other = std::exchange(state_.sampler, sampler) != sampler;
    if (other || state_.samples >= ConvergenceState::most_samples) halves_.clear();
}

void Convergence::follow(const Session& now) {
    if (state_.curves.empty()) return;
    const Session& of = state_.curves.back().session;
    if (picture_of(of) != picture_of(now)) state_.curves.clear();
    if (state_.curves.empty() || configuration_of(of) != configuration_of(now)) {
        halves_.clear();
        state_.samples = 0;
        state_.seconds = 0;
    }
}

void Convergence::begin_curve(const Session& session) {
    halves_ = std::vector<SampleMean>(2, SampleMean(session.width, session.height));
    for (auto& offsets : offsets_) offsets.clear();
    sets_ = 0;  // the same samples for each curve of a sampler: what differs is what they cost
    state_.samples = 0;
    state_.seconds = 0;
    ConvergenceCurve curve{session, state_.sampler, {}};
    std::erase_if(state_.curves, [&](const ConvergenceCurve& c) { return c.name() == curve.name(); });
    if (state_.curves.size() == most_curves) state_.curves.erase(state_.curves.begin());
    state_.curves.push_back(std::move(curve));
}

bool Convergence::wants_sample() const {
    return state_.active && (halves_.empty() || state_.samples < ConvergenceState::most_samples);
}

glm::dvec2 Convergence::next_offset() {
    std::vector<glm::dvec2>& offsets = offsets_[state_.samples % 2];
    if (offsets.empty()) offsets = sample_offsets(state_.sampler, strata, ++sets_);
    const glm::dvec2 offset = offsets.back();
    offsets.pop_back();
    return offset;
}

void Convergence::add(const Image<Vec4>& colour, double ms) {
    halves_[std::size_t(state_.samples % 2)].add(colour);
    ++state_.samples;
    state_.seconds += 1e-3 * ms;
    if (!at_power_of_two()) return;
    const double rmse = 0.5 * std::sqrt(mean_square_error(halves_[0].mean(), halves_[1].mean()));
    state_.curves.back().points.push_back({state_.samples, state_.seconds, rmse});
}

Image<glm::dvec3> Convergence::mean() const {
    SampleMean both(state_.curves.back().session.width, state_.curves.back().session.height);
    for (const SampleMean& half : halves_) both.add(half.mean());
    return both.mean();
}

glm::dvec2 Convergence::begin_or_go_on(const Session& session) {
    follow(session);
    if (halves_.empty()) begin_curve(session);
    return next_offset();
}

Session Engine::configuration_shown() const {
    Session session = state_.session;
    session.camera = state_.camera;
    return session;
}

void Engine::sample_picture(Sampler sampler) {
    convergence_.start(sampler);
    stop_duel();
}

void Engine::note_frame(const TracedFrame& traced) {
    if (traced.scale != 1 || traced.generation != state_.generation || !traced.config.counters) return;
    TimeSummary time{traced.time.total_ms, traced.time.total_ms, traced.time.total_ms, 1};
    Session session = state_.session;
    session.camera = traced.camera;
    state_.convergence.note_tried(session, steps_per_pixel(*traced.frame), time, true);
}

void Engine::note_rounds() {
    if (!state_.picture || state_.stale() || state_.duel.scale != 1 || !state_.duel.decided()) return;
    Session session = configuration_shown();
    const double steps = steps_per_pixel(*state_.picture->traced.frame);
    // Counters of both machines agree.
    for (const TracerKind tracer : {TracerKind::cpu, TracerKind::gl_fragment}) {
        const TimeSummary& time = tracer == TracerKind::cpu ? state_.duel.cpu : state_.duel.gl;
        session.tracer = tracer;
        if (time.samples >= DuelState::least_rounds) state_.convergence.note_tried(session, steps, time, false);
    }
}

void Engine::start_sample() {
    if (!convergence_.wants_sample() || !state_.world || state_.stale() || state_.working()) return;
    if (state_.paper.active || state_.stability.active || state_.motion.playing || tracer_.busy()) return;
    if (now() - last_input_ < quiet_before_sample_s) return;
    const glm::dvec2 offset = convergence_.begin_or_go_on(configuration_shown());
    duelling_ = true;
    TraceRequest request = trace_request();
    // Each frame draws its own sample of light too, so that the mean converges to that of all of them.
    if (request.config.sampling.sample >= 0) request.config.sampling.sample = state_.convergence.samples;
    tracer_.submit(
        [this, request = std::move(request), offset, generation = trace_generation_](const std::stop_token& stop) {
            std::optional<SampleReply> reply;
            std::string error;
            try {
                reply = tracing_->sample(request, offset, stop);
            } catch (const std::exception& e) {
                error = error_text(e, "the frame");
            }
            mailbox_.post([this, reply = std::move(reply), error, generation] {
                duelling_ = false;
                if (!error.empty()) {
                    convergence_.stop();
                    say(true, "sampling: " + error);
                }
                if (reply && generation == trace_generation_ && state_.convergence.active) receive(*reply);
            });
        });
}

void Engine::receive(const SampleReply& reply) {
    convergence_.add(reply.colour, reply.ms);
    if (!convergence_.at_power_of_two() || !traced_.frame) return;
    // The same hits and counters under the mean of the colours.
    const auto frame = std::make_shared<Frame>(*traced_.frame);
    const Image<glm::dvec3> mean = convergence_.mean();
    if (mean.pixels.size() != frame->colour.pixels.size()) return;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) frame->colour.pixels[i] = Vec4(Vec3(mean.pixels[i]), 1.0f);
    traced_.frame = frame;
    start_paint();
}

}  // namespace kd

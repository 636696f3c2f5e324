// Error against time behind the window: estimates, configurations tried, and curves that look as on the page.
#include <gtest/gtest.h>
#include <tuple>

#include "app/error_time/error_time_charts.h"
#include "app/report/convergence_charts.h"

namespace kd {
namespace {

TEST(ConvergenceTest, TwoHalvesEstimateTheErrorOfTheirMean) {
    ConvergenceState state;
    Convergence convergence(state);
    Session session;
    session.width = session.height = 1;
    convergence.start(Sampler::independent);
    ASSERT_TRUE(convergence.wants_sample());
    // Samples 0 and 1 of a pixel that is 0.5: the mean is right, the halves differ by 1, so the estimate is 0.5.
    for (const float value : {0.0f, 1.0f}) {
        (void)convergence.begin_or_go_on(session);
        convergence.add(Image<Vec4>(1, 1, Vec4(value)), 250);
    }
    ASSERT_EQ(state.curves.size(), 1u);
    ASSERT_EQ(state.curves[0].points.size(), 1u);
    EXPECT_EQ(state.curves[0].points[0].rmse, 0.5);
    EXPECT_EQ(state.curves[0].points[0].seconds, 0.5);
    EXPECT_EQ(convergence.mean().at(0, 0).x, 0.5);
    // Another traversal is another curve of the same picture, another camera another picture.
    session.trace.traversal = Traversal::restart;
    (void)convergence.begin_or_go_on(session);
    EXPECT_EQ(state.curves.size(), 2u);
    EXPECT_EQ(state.samples, 0);
    session.camera = Camera{};
    convergence.follow(session);
    EXPECT_TRUE(state.curves.empty());
}

TEST(ConvergenceTest, NamesTellTheRulesThatTheWalkFollows) {
    Session session;
    session.trace.rules = Rules::as_published;
    EXPECT_NE((ConvergenceCurve{session, Sampler::regular, {}}.name().find(", as-published")), std::string::npos);
    session.trace.traversal = Traversal::ropes;  // has no form as published and walks robustly
    EXPECT_EQ((ConvergenceCurve{session, Sampler::regular, {}}.name().find("published")), std::string::npos);
    TriedConfiguration tried;
    tried.session = session;
    EXPECT_EQ(tried.name().find("published"), std::string::npos);
}

TEST(ConvergenceTest, CurvesOfOneSamplerDifferInTimeAlone) {
    for (const Sampler sampler : {Sampler::independent, Sampler::stratified}) {
        ConvergenceState state;
        Convergence convergence(state);
        Session session;
        session.width = session.height = 1;
        convergence.start(sampler);
        // An edge through the pixel, which all walks see alike; one takes three times as long.
        const auto sample = [&](Traversal traversal, double ms) {
            session.trace.traversal = traversal;
            for (int i = 0; i < 64; ++i) {
                const glm::dvec2 offset = convergence.begin_or_go_on(session);
                convergence.add(Image<Vec4>(1, 1, Vec4(offset.x + 0.3 * offset.y > 0.1 ? 1.0f : 0.0f)), ms);
            }
        };
        sample(Traversal::stack, 10);
        sample(Traversal::restart, 30);
        ASSERT_EQ(state.curves.size(), 2u);
        ASSERT_EQ(state.curves[0].points.size(), 6u);
        ASSERT_EQ(state.curves[1].points.size(), 6u);
        for (std::size_t i = 0; i < 6; ++i) {
            const auto &stack = state.curves[0].points[i], &restart = state.curves[1].points[i];
            EXPECT_EQ(stack.samples, restart.samples);
            EXPECT_EQ(stack.rmse, restart.rmse) << name_of(sampler) << ", " << stack.samples << " samples";
            EXPECT_NEAR(restart.seconds, 3 * stack.seconds, 1e-9);
        }
    }
}

TEST(ConvergenceTest, CurvesLookAsOnThePageOfErrortime) {
    ConvergenceState state;
    const auto add = [&](Sampler sampler, Traversal traversal, TracerKind tracer, const std::string& builder) {
        ConvergenceCurve curve;
        curve.sampler = sampler;
        curve.session.trace.traversal = traversal;
        curve.session.tracer = tracer;
        curve.session.build.builder = builder;
        curve.points = {{2, 1, 0.5}};
        state.curves.push_back(curve);
    };
    add(Sampler::independent, Traversal::stack, TracerKind::cpu, "paper");
    add(Sampler::stratified, Traversal::restart, TracerKind::gl_fragment, "paper");
    add(Sampler::independent, Traversal::stack, TracerKind::cpu, "exact");
    const Chart window = convergence_chart(state);
    SceneErrorTime scene;
    ImageReport& report = scene.images.emplace();
    for (const auto& [sampler, machine, traversal] : {std::tuple(Sampler::independent, "cpu", "stack"),
                                                      std::tuple(Sampler::stratified, "gl-fragment", "restart")}) {
        ImageCurve curve;
        curve.sampler = sampler;
        curve.machine = machine;
        curve.traversal = traversal;
        ImagePoint& point = curve.points.emplace_back();
        point.seconds = 1;
        point.rmse = 0.5;
        report.curves.push_back(curve);
    }
    const auto figures = image_figures(scene);
    for (const std::size_t i : {0u, 1u}) {
        const ChartCurve& on_page = figures[i].chart.curves[0];  // a figure for each machine
        EXPECT_EQ(window.curves[i].ink, on_page.ink) << i;
        EXPECT_EQ(window.curves[i].stroke, on_page.stroke) << i;
        EXPECT_EQ(marker_of(window.curves[i]), marker_of(on_page)) << i;
    }
    EXPECT_NE(window.curves[2].ink, window.curves[0].ink) << "another tree is another curve";
}

TEST(ConvergenceTest, EachConfigurationIsKeptOnceAndRoundsWinOverOneFrame) {
    ConvergenceState state;
    Session session;
    state.note_tried(session, 20, {5, 5, 5, 1}, true);
    session.view.show_map = !session.view.show_map;
    state.note_tried(session, 20, {4, 3, 6, 9}, false);
    state.note_tried(session, 20, {7, 7, 7, 1}, true);
    ASSERT_EQ(state.tried.size(), 1u);
    EXPECT_EQ(state.tried[0].time.median_ms, 4);
    session.tracer = TracerKind::gl_fragment;
    state.note_tried(session, 20, {9, 9, 9, 1}, true);
    const TriedChart chart = tried_chart(state, session);
    ASSERT_EQ(chart.chart.curves.size(), 2u);
    ASSERT_TRUE(chart.current.has_value());
    EXPECT_EQ(chart.current->first, 1u);
    EXPECT_EQ(chart.tried[1][0], 1u);
}

TEST(ConvergenceTest, ConfigurationsThatLoseHitsHaveMarksOfTheirOwn) {
    ConvergenceState state;
    Session session;
    state.note_tried(session, 20, {5, 5, 5, 6}, false);
    EXPECT_FALSE(tried_chart(state, session).loses_hits);
    session.trace.rules = Rules::as_published;
    session.trace.traversal = Traversal::ropes;  // has no form as published and walks robustly
    state.note_tried(session, 19, {4, 4, 4, 6}, false);
    EXPECT_FALSE(tried_chart(state, session).loses_hits);
    session.trace.traversal = Traversal::stack;
    state.note_tried(session, 18, {3, 3, 3, 6}, false);
    const TriedChart tried = tried_chart(state, session);
    EXPECT_TRUE(tried.loses_hits);
    ASSERT_EQ(tried.chart.curves.size(), 2u);
    EXPECT_EQ(tried.chart.curves[0].name, "CPU");
    EXPECT_EQ(tried.chart.curves[0].points.size(), 2u);
    EXPECT_EQ(tried.chart.curves[1].name, "CPU, rules that lose hits");
    EXPECT_NE(marker_of(tried.chart.curves[1]), marker_of(tried.chart.curves[0]));
    EXPECT_EQ(tried.tried[1], std::vector<std::size_t>{2});
    EXPECT_EQ(tried.current, std::pair(std::size_t(1), std::size_t(0)));
}

}  // namespace
}  // namespace kd

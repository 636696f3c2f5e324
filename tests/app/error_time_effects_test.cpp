// P6: sampled light converges as theory says, and what it is measured by is right.

#include <cmath>
#include <gtest/gtest.h>

#include "app/error_time/error_time_charts.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/error_time/effect_report.h"
#include "renderer/measure/error_time/relative_error.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/accumulator.h"

namespace kd {
namespace {

TEST(RelativeError, IsTheSquareOfTheErrorOverThatOfTheReference) {
    Image<glm::dvec3> image(1, 1, glm::dvec3(0.3, 0.1, 2.0)), reference(1, 1, glm::dvec3(0.2, 0.0, 2.0));
    // 0.01 / (0.04 + 0.01), 0.01 / 0.01, 0.
    EXPECT_NEAR(relative_mean_square_error(image, reference), (0.2 + 1.0 + 0.0) / 3, 1e-12);
    EXPECT_EQ(relative_mean_square_error(reference, reference), 0);
}

TEST(LightEffects, AreThoseThatTheSceneHas) {
    const auto names = [](const FlatScene& scene, const TraceConfig& config = {}) {
        std::vector<std::string> found;
        for (const LightEffect& effect : light_effects(scene, config)) found.push_back(effect.name);
        return found;
    };
    using Names = std::vector<std::string>;
    Scene scene = *make_procedural("cornell");
    EXPECT_EQ(names(flatten(scene)), (Names{"soft shadows", "gloss", "indirect light", "all effects"}));
    EXPECT_EQ(names(flatten(scene), {.reflection_depth = 0}), (Names{"soft shadows", "indirect light", "all effects"}));
    for (Light& light : scene.lights) light.radius = 0;
    for (Material& material : scene.materials) material.roughness = 0;
    EXPECT_EQ(names(flatten(scene)), (Names{"indirect light"})) << "alone it is all";
    for (Material& material : scene.materials) material.diffuse = Vec3(0.0f);
    EXPECT_EQ(names(flatten(scene)), Names());
    const auto effects = light_effects(flatten(*make_procedural("cornell")), {});
    for (std::size_t i = 0; i < 3; ++i) {
        const Sampling& s = effects[i].sampling;
        EXPECT_EQ(int(s.soft_shadows) + int(s.gloss) + int(s.indirect), 1) << effects[i].name << " alone";
    }
}

/// By the CPU, whose clock stands still: a whole frame is a millisecond, and so are as many tiles as make one.
struct Effects {
    static constexpr int side = 48;  // four tiles
    FlatScene scene = flatten(*make_procedural("cornell"));
    KdTree tree = build_tree(scene.triangles, {});
    TriangleBoxes boxes{scene.triangles};
    CpuTracer tracer{scene, tree};
    EffectTask task{.scene = scene, .boxes = boxes, .config = {}, .plan = {}, .effects = {}, .methods = {}};
    int whole_frames = 0;

    Effects() {
        task.config.counters = false;
        task.plan = {side, side, 32, 128, 4, 0};
        task.frame_seconds = 0;
        task.effects = light_effects(scene, task.config);
        task.methods = {{"cpu", "none",
                         [this](const TraceConfig& config, Image<Vec4>& colour) {
                             ++whole_frames;
                             colour = traced(config).colour;
                             return TimeSample{1.0};
                         },
                         [this](const TraceConfig& config, int samples, double error) {
                             return gathered(config, samples, error);
                         }}};
    }

    Frame traced(const TraceConfig& config) {
        Frame frame(side, side);
        tracer.trace_frame(config, effect_camera(scene, side, side), frame, 2);
        return frame;
    }

    GatheredImage gathered(TraceConfig config, int samples, double error) {
        Accumulator all(side, side);
        std::vector<Tile> active = all.tiles();
        double ms = 0;
        for (int sample = 0; sample < samples && !active.empty(); ++sample) {
            config.sampling.sample = sample;
            all.add(traced(config), active);
            for (const Tile& tile : active) ms += double((tile.x1 - tile.x0) * (tile.y1 - tile.y0)) / (side * side);
            active = all.active(error);
        }
        return {all.frame().colour, ms, all.average_samples(), all.average_samples() < samples};
    }
};

const EffectCurve& curve_of(const MeasuredEffect& measured, LightPoints points) {
    return *std::ranges::find(measured.curves, points, &EffectCurve::light_points);
}

TEST(EffectReportTest, IndependentSamplesFallByTheirNumberAndTheSequenceFaster) {
    Effects effects;
    const EffectReport report = report_effects(effects.task);
    ASSERT_TRUE(report.complete);
    ASSERT_EQ(report.effects.size(), 4u);
    for (const MeasuredEffect& measured : report.effects) {
        SCOPED_TRACE(measured.effect.name);
        const EffectCurve& independent = curve_of(measured, LightPoints::independent);
        const EffectCurve& sequence = curve_of(measured, LightPoints::sequence);
        ASSERT_EQ(independent.points.size(), 6u);
        // The variance of a mean. Measured: off by up to 0.04 (four sets, 64 x 64 pixels).
        EXPECT_NEAR(independent.fit.slope, -1, 0.1);
        // Measured at 96 x 96: -1.31 to -1.62.
        EXPECT_LT(sequence.fit.slope, -1.2);
        EXPECT_TRUE(sequence.fit.interval.holds(sequence.fit.slope));
        // One sample of either is one point anywhere. Measured: 0.9 to 1.2, for few pixels see gloss.
        EXPECT_NEAR(sequence.points[0].relative_mse / independent.points[0].relative_mse, 1, 0.4);
        EXPECT_LT(sequence.points.back().relative_mse, 0.7 * independent.points.back().relative_mse);
        for (const EffectPoint& point : sequence.points) {
            EXPECT_NEAR(point.seconds, 1e-3 * point.samples, 1e-12);
            EXPECT_TRUE(point.relative_mse_interval.holds(point.relative_mse));
            EXPECT_GT(point.relative_mse_interval.high, point.relative_mse_interval.low);
        }
        // 128 samples, as two halves of the sequence, beside 32: less by 4^1.3 = 6 and what two seeds more save.
        EXPECT_LT(measured.reference_relative_mse, 0.3 * sequence.points.back().relative_mse);
        EXPECT_GT(measured.reference_relative_mse, 0);
        EXPECT_EQ(independent.gap, 0) << "one machine";
    }
    EXPECT_GT(effects.whole_frames, 4 * 2 * 4 * 32);
}

TEST(EffectReportTest, TilesThatPauseTakeLessTimeAndKeepTheirError) {
    Effects effects;
    effects.task.plan.most_samples = 64;
    effects.task.effects = {effects.task.effects.front()};
    const EffectReport report = report_effects(effects.task);
    ASSERT_EQ(report.effects.size(), 1u);
    const EffectCurve& adaptive = curve_of(report.effects[0], LightPoints::adaptive);
    const EffectCurve& sequence = curve_of(report.effects[0], LightPoints::sequence);
    ASSERT_GE(adaptive.points.size(), 2u);
    for (const EffectPoint& point : adaptive.points) {
        SCOPED_TRACE(point.asked_error);
        EXPECT_GE(point.average_samples, 16) << "the fewest before a tile may pause";
        EXPECT_LT(point.average_samples, 64);
        EXPECT_NEAR(point.seconds, 1e-3 * point.average_samples, 2e-3);
        // The sequence does better than the standard error that is asked for, which takes samples as independent.
        EXPECT_LT(point.rmse, point.asked_error);
        EXPECT_GE(point.rmse, 0.999 * sequence.points.back().rmse) << "less than all samples";
    }
    EXPECT_LT(adaptive.points[1].rmse, adaptive.points[0].rmse + 1e-12) << "a smaller error was asked for";
}

TEST(EffectReportTest, MachinesAreComparedByTheirOwnSamples) {
    Effects effects;
    effects.task.plan.most_samples = 2;
    effects.task.plan.sets = 2;
    effects.task.plan.reference_samples = 8;
    effects.task.effects = {effects.task.effects.front()};
    EffectMethod other = effects.task.methods.front();
    other.machine = "other";
    other.trace = [trace = other.trace](const TraceConfig& config, Image<Vec4>& colour) {
        const TimeSample time = trace(config, colour);
        for (Vec4& pixel : colour.pixels) pixel += Vec4(0.2f);
        return time;
    };
    effects.task.methods.push_back(other);
    const EffectReport report = report_effects(effects.task);
    for (const EffectCurve& curve : report.effects.at(0).curves)
        if (curve.machine == "other" && curve.light_points != LightPoints::adaptive) {
            EXPECT_GT(curve.gap, 0.05);
        } else {
            EXPECT_EQ(curve.gap, 0);
        }
}

TEST(EffectReportTest, StopsWhereAsked) {
    for (const float from : {0.0f, 0.12f, 0.23f}) {
        Effects effects;
        std::stop_source stop;
        const auto progress = [&](float done, const std::string&) {
            if (done >= from) stop.request_stop();
        };
        EXPECT_FALSE(report_effects(effects.task, progress, stop.get_token()).complete);
    }
}

TEST(EffectPlans, AimAtTheTime) {
    const std::vector<EffectCost> costs{{{1, 2}, 3}, {{2, 4}, 6}};
    double last = 0;
    for (const double seconds : {1.0, 10.0, 100.0, 1000.0}) {
        const EffectPlan plan = plan_effects(seconds, costs, 64 * 64);
        EXPECT_LE(plan.predicted_seconds, seconds);
        EXPECT_GT(plan.predicted_seconds, last) << "more time, more samples";
        EXPECT_GE(plan.reference_samples, 8 * plan.most_samples);
        last = plan.predicted_seconds;
    }
    EXPECT_EQ(plan_effects(0, costs, 64 * 64).most_samples, 8) << "the cheapest";
}

TEST(EffectFigures, AdaptiveMarksSayWhatWasAskedFor) {
    SceneErrorTime scene;
    scene.name = {"made:1", "made-1"};
    MeasuredEffect measured{.effect = {"all effects", {}}, .reference_relative_mse = 1e-6, .curves = {}};
    for (const LightPoints points : {LightPoints::sequence, LightPoints::adaptive}) {
        EffectCurve curve{
            .light_points = points, .machine = "cpu", .clock = "none", .frame = {}, .points = {}, .fit = {}};
        EffectPoint& point = curve.points.emplace_back();
        point.asked_error = 0.02;
        point.seconds = 1;
        point.relative_mse = 0.1;
        measured.curves.push_back(curve);
    }
    scene.effects.emplace().effects = {measured};
    const auto figures = effect_figures(scene);
    ASSERT_EQ(figures.size(), 1u);
    EXPECT_EQ(figures[0].name, "p6-made-1-all-effects");
    const Chart& chart = figures[0].chart;
    EXPECT_EQ(chart.curves.at(0).points.at(0).label, "");
    EXPECT_EQ(chart.curves.at(1).points.at(0).label, "0.02");
    EXPECT_EQ(chart.lines.at(0).value, 1e-6);
}

}  // namespace
}  // namespace kd

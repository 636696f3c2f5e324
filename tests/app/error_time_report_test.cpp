// The reports of error against run time, on scenes small enough for a test: what has to come out whatever the machine.

#include <cmath>
#include <gtest/gtest.h>

#include "app/error_time/error_time_charts.h"
#include "app/frame/frame_tracer.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/double_path.h"
#include "renderer/measure/error_time/hit_report.h"
#include "renderer/measure/error_time/image_error.h"
#include "renderer/measure/error_time/image_report.h"
#include "renderer/measure/error_time/lines.h"
#include "renderer/measure/error_time/tree_report.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/upper_bound.h"

namespace kd {
namespace {

FlatScene scene_of(std::string_view name) { return flatten(*make_procedural(name)); }

/// A method of the CPU; its clock stands still, so that nothing depends on the machine.
ImageMethod cpu_method(const FlatScene& scene, const KdTree& tree, TraceConfig config, int side) {
    const auto tracer = std::make_shared<CpuTracer>(scene, tree);
    config.counters = false;
    const std::string traversal(info(config.traversal).name);
    return {"cpu", traversal, "none", [=](const PinholeCamera& camera, Image<Vec4>& colour) {
                Frame frame(side, side);
                tracer->trace_frame(config, camera, frame, 0);
                colour = frame.colour;
                return TimeSample{1.0};
            }};
}

struct Images {
    FlatScene scene = scene_of("ball:300");
    KdTree tree = build_tree(scene.triangles, {});
    TriangleBoxes boxes{scene.triangles};
    ImageTask task{scene, boxes, {}, {24, 24, 16, 128, 6, 0}, {}, 0, 1, 0};
    explicit Images(const TraceConfig& config = {}) {
        task.config = config;
        for (const Traversal t : {Traversal::stack, Traversal::restart, Traversal::backtrack}) {
            task.config.traversal = t;
            task.methods.push_back(cpu_method(scene, tree, task.config, task.plan.width));
        }
    }
};

TEST(ImageReportTest, TraversalsDifferInTimeAlone) {
    Images images;
    const ImageReport report = report_images(images.task);
    ASSERT_TRUE(report.complete);
    ASSERT_EQ(report.curves.size(), 9u);
    for (const ImageCurve& curve : report.curves) {
        // Colours are floats below 1: one that is added up in another order differs by 6e-8, their RMSE by less.
        EXPECT_LE(curve.worst_gap, 1e-7) << name_of(curve.sampler) << ' ' << curve.traversal;
        ASSERT_EQ(curve.points.size(), 5u);
        EXPECT_EQ(curve.points.back().samples, 16);
        EXPECT_NEAR(curve.points.back().seconds, 0.016, 1e-12);
        EXPECT_EQ(curve.frame.samples, 6) << "the least that a 95 % interval of a ratio takes";
        EXPECT_TRUE(curve.of_first.sure());
        EXPECT_EQ(curve.of_first.median, 1) << "the clock stands still";
        const bool random = curve.sampler != Sampler::regular;
        for (const ImagePoint& point : curve.points) {
            const double width = point.rmse_interval.high - point.rmse_interval.low;
            EXPECT_EQ(width > 0, random) << name_of(curve.sampler) << ": chance alone has an interval";
            EXPECT_LT(width, point.rmse) << "six sets tell it better than that";
            const double flip_width = point.flip_interval.high - point.flip_interval.low;
            EXPECT_EQ(flip_width > 0, random) << name_of(curve.sampler);
            EXPECT_LT(flip_width, point.flip);
            EXPECT_LE(point.flip_interval.low, point.flip);
            EXPECT_GE(point.flip_interval.high, point.flip);
            EXPECT_LT(point.rmse_interval.low, random ? point.rmse : point.rmse + 1e-12);
            EXPECT_GT(point.rmse_interval.high, random ? point.rmse : point.rmse - 1e-12);
        }
        // RMSE falls to 16^-0.5 = 0.25 and below; FLIP raises differences to the power of 0.7 before they are
        // compressed.
        EXPECT_LT(curve.points.back().flip, 0.6 * curve.points.front().flip) << "16 samples instead of one";
    }
}

TEST(ImageReportTest, FlipIsDrawnWithItsInterval) {
    Images images;
    images.task.methods.resize(1);
    images.task.plan.sets = 3;
    images.task.plan.most_samples = 2;
    SceneErrorTime scene;
    scene.images = report_images(images.task);
    const std::vector<ErrorFigure> figures = image_figures(scene);
    const Chart& flip = figures.back().chart;
    ASSERT_EQ(flip.curves.size(), scene.images->curves.size());
    for (std::size_t i = 0; i < flip.curves.size(); ++i)
        for (std::size_t k = 0; k < flip.curves[i].points.size(); ++k) {
            const Interval& interval = scene.images->curves[i].points[k].flip_interval;
            ASSERT_TRUE(flip.curves[i].points[k].y_interval.has_value());
            EXPECT_EQ(flip.curves[i].points[k].y_interval->low, interval.low);
            EXPECT_EQ(flip.curves[i].points[k].y_interval->high, interval.high);
        }
}

TEST(ImageReportTest, EachMachineIsHeldToItsOwnFirstMethod) {
    // What the second machine's traversal adds to each colour is no matter of rounding, though its first method's image
    // differs from the first machine's by more.
    Images images;
    const auto offset = [&](const char* machine, float added) {
        ImageMethod method = images.task.methods.front();
        method.machine = machine;
        method.trace = [trace = method.trace, added](const PinholeCamera& camera, Image<Vec4>& colour) {
            const TimeSample time = trace(camera, colour);
            for (Vec4& pixel : colour.pixels) pixel += Vec4(added);
            return time;
        };
        return method;
    };
    images.task.plan.sets = 2;
    images.task.plan.most_samples = 2;
    images.task.methods.resize(2);
    images.task.methods.push_back(offset("other", 0.2f));
    images.task.methods.push_back(offset("other", 0.2f));
    const ImageReport same = report_images(images.task);
    EXPECT_EQ(same.machines(), (std::vector<std::string>{"cpu", "other"}));
    EXPECT_GT(same.curves.back().worst_gap, 0.1);
    EXPECT_EQ(same.own_gap("other"), 0);
    EXPECT_TRUE(same.same_images());
    images.task.methods.push_back(offset("other", 0.21f));
    const ImageReport faulty = report_images(images.task);
    EXPECT_LE(faulty.own_gap("cpu"), ImageReport::most_own_gap);
    EXPECT_GT(faulty.own_gap("other"), 0.005);
    EXPECT_FALSE(faulty.same_images());
}

TEST(ImageReportTest, TraversalsDifferInTimeAloneByOpenGlToo) {
    Images images;
    images.task.plan.sets = 2;
    images.task.plan.most_samples = 4;
    images.task.methods.resize(1);
    std::unique_ptr<FrameTracer> gl;
    try {
        gl = make_frame_tracer(TracerKind::gl_fragment, images.scene, images.tree, 0, {.context = ContextKind::osmesa});
    } catch (const ContextError& error) {
        GTEST_SKIP() << "NO CONTEXT: " << error.what();
    }
    for (const Traversal t : {Traversal::stack, Traversal::restart, Traversal::backtrack}) {
        TraceConfig config{.traversal = t, .counters = false};
        images.task.methods.push_back({"gl-fragment", std::string(info(t).name), gl->clock(),
                                       [&gl, config](const PinholeCamera& camera, Image<Vec4>& colour) {
                                           gl->prepare(config, 24, 24);
                                           (void)gl->trace(config, camera, 24, 24);
                                           colour = gl->frame(config).colour;
                                           return TimeSample{1.0};
                                       }});
    }
    const ImageReport report = report_images(images.task);
    ASSERT_EQ(report.curves.size(), 12u);
    EXPECT_LE(report.own_gap("gl-fragment"), ImageReport::most_own_gap);
    EXPECT_TRUE(report.same_images());
    for (const ImageCurve& curve : report.curves) EXPECT_LE(curve.worst_gap, 1e-7) << curve.machine << curve.traversal;
}

TEST(ImageReportTest, IndependentSamplesConvergeByTheRootAndStratifiedOnesFaster) {
    Images images;
    images.task.methods.resize(1);
    images.task.plan.sets = 12;
    const ImageReport report = report_images(images.task);
    double slopes[3] = {};
    for (const ImageCurve& curve : report.curves) slopes[std::size_t(curve.sampler)] = curve.fit.slope;
    // Theory: -0.5, and -0.75 where edges make the error. Twelve sets tell a slope to about 0.05, so 0.1 is two of
    // that.
    EXPECT_NEAR(slopes[std::size_t(Sampler::independent)], -0.5, 0.1);
    EXPECT_LT(slopes[std::size_t(Sampler::stratified)], slopes[std::size_t(Sampler::independent)] - 0.1);
    // Eight times as many samples, stratified: 8^-0.75 = 0.21 of the error of the best curve.
    EXPECT_LT(report.reference_rmse, 0.3 * report.curves.back().points.back().rmse);
}

TEST(ImageReportTest, ReferenceOfOneSampleIsTheFrame) {
    // The middle of the pixel, in double and in single precision: but for pixels at edges the same colours.
    std::vector<Image<glm::dvec3>> frames;
    for (const TraceConfig& config :
         {TraceConfig{}, TraceConfig{.shadows = false}, TraceConfig{.shadows = false, .reflection_depth = 0}}) {
        Images images(config);
        const PinholeCamera camera = pinhole(images.scene.camera, 24, 24);
        SampleMean single(24, 24);
        Image<Vec4> colour;
        images.task.methods[0].trace(camera, colour);
        single.add(colour);
        const PathConfig path = path_config(images.scene, config);
        const Image<glm::dvec3> wide = double_frame(images.scene, camera, 24, 24, path, 0, {}, &images.boxes);
        // Single precision rounds colours to 6e-8 after some hundred operations; a pixel at an edge that fell on the
        // other side would alone make 1/24 of a colour's step, 1e-2 and more.
        EXPECT_LT(std::sqrt(mean_square_error(single.mean(), wide)), 1e-4);
        const Image<glm::dvec3> slow = double_frame(images.scene, camera, 24, 24, path);
        EXPECT_EQ(wide.pixels, slow.pixels);
        for (const Image<glm::dvec3>& other : frames)
            EXPECT_GT(std::sqrt(mean_square_error(other, wide)), 1e-2) << "another picture";
        frames.push_back(wide);
    }
}

TEST(ImageReportTest, ErrorsFallWithoutShadowsToo) {
    Images images({.shadows = false});
    images.task.methods.resize(1);
    const ImageReport report = report_images(images.task);
    for (const ImageCurve& curve : report.curves) {
        // The regular grid falls in steps, so its five points lie about a slope less well than 0.5 has it; 16^-0.35 is
        // 0.38.
        EXPECT_LT(curve.fit.slope, -0.35) << name_of(curve.sampler);
        EXPECT_LT(curve.points.back().rmse, 0.4 * curve.points.front().rmse) << name_of(curve.sampler);
    }
}

TEST(ImageReportTest, ShiftedCameraSeesTheNextPixel) {
    Images images;
    const PinholeCamera camera = pinhole(images.scene.camera, 24, 24);
    Image<Vec4> here, there;
    images.task.methods[0].trace(camera, here);
    images.task.methods[0].trace(shifted(camera, {1, 2}, 24, 24), there);
    int differing = 0;
    for (int y = 0; y < 22; ++y)
        for (int x = 0; x < 23; ++x)
            differing += glm::any(glm::greaterThan(glm::abs(there.at(x, y) - here.at(x + 1, y + 2)), Vec4(1e-3f)));
    EXPECT_LE(differing, 3);  // an edge may run through a pixel's very middle
}

TEST(ImageReportTest, StopsWhereAsked) {
    Images images;
    std::stop_source stop;
    const auto progress = [&](float done, const std::string&) {
        if (done > 0.5f) stop.request_stop();
    };
    EXPECT_FALSE(report_images(images.task, progress, stop.get_token()).complete);
}

TEST(HitReportTest, RobustWatertightLosesNothingAndTheOthersDo) {
    HitTask task;
    task.rays = 500;
    task.seconds_per_family = 0;
    const HitReport report = report_hits(task);
    ASSERT_TRUE(report.complete);
    ASSERT_EQ(report.rows.size(), hit_families().size() * 24);
    std::int64_t plain_misses_edges = 0, published_wrong = 0;
    for (const HitRow& row : report.rows) {
        const std::string name = row.family + ": " + row.method.family_name();
        const bool robust = row.method.rules == Rules::robust;
        if (robust && row.method.test == TriangleTest::woop) {
            EXPECT_EQ(row.missed + row.wrong, 0) << name;
        }
        if (row.family == "T14") {
            EXPECT_EQ(row.missed + row.wrong, 0) << name << ": these rays are benign";
        }
        if (row.family == "T15" && robust && row.method.test == TriangleTest::moeller_trumbore && !row.method.in_double)
            plain_misses_edges += row.missed;
        if (row.family == "T10" && !robust) published_wrong += row.missed + row.wrong;
        if (row.family == "T14" && row.method.in_double) {
            // 2^-29 = 2e-9 ulp of a float for each rounding; the worst t in single precision, some hundred ulp, would
            // be 1e-6 or less, and all were below 3e-6.
            EXPECT_LT(row.ulp_most, 1e-4) << name << ": a double has 29 bits more";
        }
        if (row.family == "T14" && !row.method.in_double) {
            // Rounding t alone errs by a quarter of an ulp in the median, so a twentieth would be no float's. 99.9 %
            // were within 13 ulp by either test, and three times of that allows for other rays.
            EXPECT_GT(row.ulp_p50, 0.05) << name << ": a float rounds";
            EXPECT_GT(row.ulp_p999, 1.5 * row.ulp_p50) << name;
            EXPECT_GT(row.ulp_most, 1) << name;
            EXPECT_LT(row.ulp_p999, 40) << name;
        }
        EXPECT_EQ(row.upper95, upper_bound_95(row.missed + row.wrong, row.n)) << name;
        if (row.missed + row.wrong == 0) {
            EXPECT_EQ(row.upper95, 3.0 / double(row.n)) << name;
        }
        EXPECT_EQ(row.rounds, 6) << "the least that a 95 % interval of a ratio takes";
        EXPECT_TRUE(row.of_first.sure()) << name;
    }
    for (std::size_t i = 0; i < report.rows.size(); i += 24)
        EXPECT_EQ(report.rows[i].of_first, (MedianInterval{1, 1, 1, report.rows[i].of_first.confidence, 6}));
    EXPECT_GT(plain_misses_edges, 0);
    EXPECT_GT(published_wrong, 0);
}

TEST(HitReportTest, WalksAnswerAsTheTracersDo) {
    const FlatScene scene = scene_of("ball:300");
    const KdTree tree = build_tree(scene.triangles, {});
    Random random(4);
    const std::vector<Ray> rays = uniform_lines(scene.bounds, 500, random);
    const WalkScene walks(scene, tree);
    CpuTracer tracer(scene, tree);
    for (const Rules rules : {Rules::robust, Rules::as_published})
        for (const Traversal traversal : {Traversal::stack, Traversal::restart, Traversal::backtrack}) {
            TraceConfig config;
            config.rules = rules;
            config.traversal = traversal;
            std::vector<Hit> expected(rays.size());
            tracer.trace_rays(config, rays, false, expected, {});
            std::vector<HitAnswer> found(rays.size());
            walk_rays(walks, {TriangleTest::woop, false, rules, traversal}, rays, found);
            for (std::size_t i = 0; i < rays.size(); ++i)
                EXPECT_EQ(found[i], (HitAnswer{expected[i].triangle, double(expected[i].t)}))
                    << info(traversal).name << ", rules " << int(rules) << ", ray " << i;
        }
}

TEST(TreeReportTest, LinesPayWhatTheHeuristicPredicts) {
    for (const char* name : {"ball:2000", "scatter:2000", "cornell"}) {
        const FlatScene scene = scene_of(name);
        const bool dense = std::string_view(name) != "scatter:2000";
        TreeTask task{.scene = scene,
                      .build = {},
                      .trace = {},
                      .width = 32,
                      .height = 32,
                      .lines = 40000,
                      .build_seconds = 0,
                      .frame_seconds = 0};
        const TreeReport report = report_trees(task);
        ASSERT_TRUE(report.complete);
        ASSERT_GE(report.rows.size(), 6u);
        for (const TreeRow& row : report.rows) {
            for (const LineRatio& one : row.line_ratios.all()) {
                EXPECT_NEAR(one.ratio, 1, LineRatios::most_error) << name << ' ' << row.name();
                EXPECT_TRUE(one.interval.holds(one.ratio)) << name << ' ' << row.name();
                if (row.stats.nodes > 3) {  // every line meets the one inner node of three
                    EXPECT_GT(one.interval.high, one.interval.low) << name << ' ' << row.name();
                }
                EXPECT_LT(one.interval.high - one.interval.low, 2 * LineRatios::most_error) << name << row.name();
            }
            // Surfaces stop camera rays early, but where there are gaps they cross more than a line that enters
            // anywhere.
            const double paid = row.cost_per_ray[0] / row.stats.sah_cost;
            // So they pay less than is predicted on the one scene and more on the other; by a factor of two either
            // way they would not be rays of the scene (the trees paid 0.5 to 0.9 and 1.1 to 1.3).
            EXPECT_GT(paid, dense ? 0.25 : 1.0) << name << ' ' << row.name();
            EXPECT_LT(paid, dense ? 1.0 : 2.6) << name << ' ' << row.name();
            EXPECT_EQ(row.build.samples, 6);
            EXPECT_EQ(row.frame_ratio.samples, 6);
            EXPECT_TRUE(row.frame_ratio.sure());
        }
        const TreeRow& reference = report.rows[report.reference];
        EXPECT_EQ(reference.name(), "exact, leaves of 2");
        EXPECT_EQ(reference.frame_ratio.median, 1);
        for (const TreeRow& row : report.rows)
            EXPECT_EQ(row.sah_ratio, row.stats.sah_cost / reference.stats.sah_cost) << name << ' ' << row.name();
        ASSERT_TRUE(report.tau[0].has_value());
        EXPECT_GT(report.tau[0]->interval.low, 0) << name << ": better trees are better for camera rays, too";
        EXPECT_EQ(report.line_verdict(), LineVerdict::right);
    }
}

}  // namespace
}  // namespace kd

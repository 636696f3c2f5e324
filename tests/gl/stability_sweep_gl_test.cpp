// Sweeps of the stability suite: their table, what they measure, and the scenes by name.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "renderer/gl/context.h"
#include "renderer/gl/gl_limits.h"
#include "renderer/measure/oracle.h"
#include "renderer/measure/path_rays.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/measure/stability/distances.h"
#include "renderer/measure/stability/stability.h"
#include "renderer/measure/stability/stress_scene.h"
#include "renderer/measure/stability/sweep_run.h"
#include "renderer/trace/counters.h"
#include "tests/support/refusal.h"

namespace kd {
namespace {

using test::refusal;

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// On the CPU, without as many rays as people get.
SweepReport quick(std::string_view id, std::size_t rays = 200) {
    SweepConfig config;
    config.id = id;
    config.rays = rays;
    return run_sweep(config);
}

TEST(Sweeps, AreWellFormed) {
    EXPECT_GE(sweeps().size(), 10u);
    std::set<std::string_view> ids;
    for (const Sweep& sweep : sweeps()) {
        EXPECT_TRUE(ids.insert(sweep.id).second) << sweep.id;
        EXPECT_NE(std::ranges::find(stability_cases(), sweep.id, &StabilityCase::id), stability_cases().end())
            << sweep.id;
        EXPECT_FALSE(sweep.parameter.empty()) << sweep.id;
        EXPECT_LE(sweep.parameter.size() + sweep.unit.size(), 45u) << sweep.id << ": too long for an axis";
        ASSERT_GE(sweep.values.size(), 5u) << sweep.id;
        EXPECT_EQ(std::ranges::adjacent_find(sweep.values, std::ranges::greater_equal{}), sweep.values.end())
            << sweep.id << " does not ascend";
        EXPECT_TRUE(!sweep.logarithmic || sweep.values.front() > 0) << sweep.id;
    }
    EXPECT_TRUE(std::ranges::is_sorted(sweeps(), {}, &Sweep::id));
}

TEST(Sweeps, MakeScenesRaysAndCamerasAtEveryValue) {
    for (const Sweep& sweep : sweeps())
        for (const double value : sweep.values) {
            Random random = sweep_random(sweep, 1);
            SweepScene made = sweep.make(value, 20, random);
            EXPECT_FALSE(made.triangles.empty()) << sweep.id << " " << value;
            EXPECT_EQ(made.rays.size(), 20u) << sweep.id << " " << value;
            const std::size_t count = made.triangles.size();
            const FlatScene scene = flat_scene(made);
            EXPECT_EQ(scene.triangles.size(), count);
            EXPECT_TRUE(is_valid(scene.camera)) << sweep.id << " " << value;
        }
}

/// What the cases are held against passes over triangles by their boxes: no bit may hang on it, however stiff the
/// scene.
TEST(Sweeps, TheBoxesChangeNoAnswerOfTheLoop) {
    for (const Sweep& sweep : sweeps())
        for (const double value : {sweep.values.front(), sweep.values[sweep.values.size() / 2], sweep.values.back()}) {
            Random random = sweep_random(sweep, 2);
            SweepScene made = sweep.make(value, 60, random);
            const FlatScene scene = flat_scene(made);
            const DoubleOracle oracle(scene);
            const std::vector<Hit> loop = brute_force(scene, made.rays);
            const std::vector<Hit> boxes = plain_nearest_hits(scene, oracle.boxes(), made.rays);
            const std::vector<f64::Hit> exact = double_brute_force(scene, made.rays), quick = oracle.nearest(made.rays);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                EXPECT_TRUE(bit_equal(loop[i], boxes[i])) << sweep.id << " at " << value;
                EXPECT_TRUE(exact[i].triangle == quick[i].triangle && exact[i].t == quick[i].t)
                    << sweep.id << " at " << value;
            }
        }
}

TEST(Sweeps, TheRobustRulesLoseNothingAnywhere) {
    for (const Sweep& sweep : sweeps()) {
        const SweepReport report = quick(sweep.id);
        EXPECT_TRUE(report.complete);
        for (const SweepRow& row : report.rows) {
            if (row.method.rules != "robust" && row.method.tracer != "double") continue;
            // From an origin nearer to a triangle than single precision resolves, its side is a matter of rounding.
            if (sweep.id == "T57" && row.value < 1e-7) continue;
            EXPECT_EQ(row.missed + row.wrong, 0)
                << sweep.id << " at " << row.value << " by " << row.method.name() << ": " << row.missed << " missed";
            EXPECT_DOUBLE_EQ(row.upper95, std::min(1.0, 3.0 / double(row.n))) << "none seen: 3/n";
        }
    }
}

TEST(Sweeps, ThePublishedRulesLoseWhereTheSuiteMeasuredIt) {
    for (const char* id : {"T10", "T11", "T12", "T15", "T16", "T32"}) {
        const SweepReport report = quick(id, 1000);
        const auto lost = [&](double value) {
            const auto row = std::ranges::find_if(
                report.rows, [&](const SweepRow& r) { return r.value == value && r.method.rules == "as-published"; });
            return row == report.rows.end() ? -1 : row->missed + row->wrong;
        };
        EXPECT_GT(lost(report.values.front()), 0) << id << ": right at it";
        EXPECT_LT(lost(report.values.back()), lost(report.values.front())) << id << ": well away from it";
    }
}

TEST(Sweeps, AGrazingRaysErrorGrowsAsItsAngleShrinks) {
    const SweepReport report = quick("T27", 500);
    std::vector<double> robust, exact;
    for (const SweepRow& row : report.rows) {
        if (row.method.tracer == "double") exact.push_back(row.worst_ulp);
        if (row.method.rules == "robust") robust.push_back(row.worst_ulp);
        EXPECT_LE(row.p99_ulp, row.worst_ulp);
    }
    ASSERT_EQ(robust.size(), report.values.size());
    EXPECT_GT(robust.front(), 1e4) << "at 1e-8";  // the direction itself rounds by more than that
    EXPECT_LT(robust.back(), 100) << "at 0.1";
    for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_LT(exact[i], 1e-4 * robust[i]) << report.values[i];
}

TEST(Sweeps, TheTraversalsAskedForAreMeasured) {
    SweepConfig config;
    config.id = "T16";
    config.rays = 50;
    config.traversals = {"restart", "backtrack"};
    std::set<std::string> names;
    for (const SweepMethod& method : run_sweep(config).methods()) names.insert(method.name());
    const std::set<std::string> expected{"robust, cpu, restart",
                                         "robust, cpu, backtrack",
                                         "as-published, cpu, restart",
                                         "as-published, cpu, backtrack",
                                         "first-edition, cpu, restart",
                                         "first-edition, cpu, backtrack",
                                         "double"};
    EXPECT_EQ(names, expected);
}

TEST(Sweeps, OpenGlGivesTheCpusCurves) {
    for (const char* id : {"T16", "T11"}) {  // T11: components that a shader may take as zero
        SweepConfig config;
        config.id = id;
        config.rays = 300;
        config.contexts = {ContextKind::osmesa};
        const SweepReport report = run_sweep(config);
        if (!report.notes.empty()) GTEST_SKIP() << "NO CONTEXT: " << report.notes[0];
        const auto of = [&](const char* tracer) {
            std::vector<std::int64_t> faults;
            for (const SweepRow& row : report.rows)
                if (row.method.tracer == tracer && row.method.rules == "robust")
                    faults.push_back(row.missed + row.wrong);
            return faults;
        };
        EXPECT_EQ(of("gl-fragment"), of("cpu")) << id;
    }
}

/// 1e5 copies in one leaf are more than a shader has steps: what it ends is flagged, and no answer is wrong.
TEST(Sweeps, WhatAShaderGivesUpIsNotTakenForLost) {
    SweepConfig config;
    config.id = "T04";
    config.contexts = {ContextKind::osmesa};
    const SweepReport report = run_sweep(config);
    if (!report.notes.empty()) GTEST_SKIP() << "NO CONTEXT: " << report.notes[0];
    std::int64_t on_gl = 0;
    for (const SweepRow& row : report.rows) {
        EXPECT_EQ(row.missed + row.wrong, 0) << row.method.name() << " at " << row.value;
        const bool on_cpu = row.method.tracer == "cpu";
        if (row.method.rules == "robust" && !on_cpu && row.value == 1e5) on_gl += row.given_up;
        if (row.method.rules == "robust" && (on_cpu || row.value < gl_sure_steps)) {
            EXPECT_EQ(row.given_up, 0) << row.method.name() << " at " << row.value;
        }
        EXPECT_DOUBLE_EQ(row.upper95, std::min(1.0, 3.0 / double(row.answered())));
    }
    EXPECT_GT(on_gl, 0);
}

TEST(Sweeps, StopBetweenValuesAndKeepWhatTheyHave) {
    SweepConfig config;
    config.id = "T25";
    config.rays = 50;
    std::stop_source stop;
    const SweepReport report = run_sweep(
        config,
        [&](float fraction, const std::string& what, const SweepReport& so_far) {
            EXPECT_TRUE(holds(what, "width of the triangles"));
            EXPECT_EQ(so_far.id, "T25");
            if (fraction > 0) stop.request_stop();
        },
        stop.get_token());
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(report.rows.size(), report.methods().size()) << "one value";
}

TEST(Sweeps, WhatHasNoneIsRefusedWithThoseThatHave) {
    EXPECT_TRUE(holds(refusal([] { (void)sweep_of("T01"); }), "case 'T01': has no sweep; try one of T04, T10"));
    EXPECT_TRUE(holds(refusal([] { (void)sweep_of("T99"); }), "case 'T99': not known; try one of T04"));
}

TEST(Distances, ARayIsAsFarFromEdgesAsItLooks) {
    const Triangle t{{Vec3(0, 0, 5), Vec3(4, 0, 5), Vec3(0, 4, 9)}};
    const Ray ray{Vec3(1, 0.25f, 0), Vec3(0, 0, 2), 0, KD_T_LIMIT, -1};
    EXPECT_NEAR(distance_to_edges(ray, t), 0.25, 1e-12) << "the edge along x, seen along z";
    EXPECT_NEAR(distance_to_edges(glm::dvec3(1, 0, 5), corners_of(t)), 0, 1e-12);
}

TEST(Distances, TIsOffThePlaneOfTheTriangleFoundByUlpsOfTheExactOne) {
    const Triangle t{{Vec3(0, 0, 5), Vec3(4, 0, 5), Vec3(0, 4, 9)}};  // z = 5 + y
    const Ray ray{Vec3(9, 0.25f, 0), Vec3(0, 0, 2), 0, KD_T_LIMIT, -1};
    constexpr double exact = 2.625, ulp = 0x1p-22;
    EXPECT_EQ(ulps_off_plane(ray, t, exact), 0) << "the plane goes on beyond the triangle";
    EXPECT_EQ(ulps_off_plane(ray, t, exact - 3 * ulp), 3);
    EXPECT_EQ(ulps_off_plane(ray, t, exact + 0x1p-6 * ulp), 0x1p-6);
    const Ray along{Vec3(9, 0.25f, 0), Vec3(1, 0, 0), 0, KD_T_LIMIT, -1};
    EXPECT_TRUE(std::isinf(ulps_off_plane(along, t, 1))) << "it is never met";
    const Ray within{Vec3(9, 0.25f, 5.25f), Vec3(0, 0, 2), 0, KD_T_LIMIT, -1};
    EXPECT_TRUE(std::isinf(ulps_off_plane(within, t, 1e-7))) << "0 has no last place";
}

TEST(StressScenes, EveryCaseHasOneOrSaysThatItHasNone) {
    int scenes = 0;
    for (const StabilityCase& info : stability_cases()) {
        const std::string name = "stress:" + std::string(info.id);
        const std::string refused = refusal([&] {
            const auto scene = make_stress_scene(name, 1);
            ASSERT_TRUE(scene);
            EXPECT_EQ(scene->name, name);
            ++scenes;
        });
        EXPECT_TRUE(refused == "accepted" || holds(refused, name + ": this case traces no scene")) << refused;
    }
    EXPECT_GT(scenes, 45);
}

TEST(StressScenes, AValueIsThatOfTheSweep) {
    const Sweep& sweep = sweep_of("T25");
    Random random = sweep_random(sweep, 3);
    SweepScene made = sweep.make(1e-5, 0, random);
    EXPECT_EQ(make_stress_scene("stress:T25=1e-5", 3)->triangles, flat_scene(made).triangles);
    EXPECT_NE(make_stress_scene("stress:T25=1e-4", 3)->triangles, make_stress_scene("stress:T25=1e-5", 3)->triangles);
    EXPECT_TRUE(make_stress_scene("stress:T25=0.00317", 1)) << "between the values measured";
    for (const Sweep& each : sweeps())
        for (const double value : each.values) EXPECT_TRUE(make_stress_scene(stress_name(each.id, value), 1));
}

TEST(StressScenes, OtherNamesAreLeftAlone) {
    EXPECT_FALSE(make_stress_scene("ball:9000", 1));
    EXPECT_FALSE(make_stress_scene("stress.glb", 1));
}

TEST(StressScenes, WhatCannotBeMadeIsRefusedInOneLine) {
    const auto why = [](const char* name) { return refusal([&] { (void)make_stress_scene(name, 1); }); };
    EXPECT_EQ(why("stress:T999"),
              "there is no stability case 'T999'; there are T01 to T65, without T17, T39, T53, T56");
    EXPECT_TRUE(holds(why("stress:"), "there is no stability case ''"));
    EXPECT_TRUE(holds(why("stress:T01=3"), "case 'T01': has no sweep; try one of"));
    for (const char* value : {"", "x", "1e", "nan", "inf", "-1", "0", "1e-12", "2", "1e-4x"})
        EXPECT_TRUE(holds(why(("stress:T25=" + std::string(value)).c_str()),
                          "width of the triangles is not a number from 1e-09 to 0.1; try stress:T25="))
            << value << ": " << why(("stress:T25=" + std::string(value)).c_str());
}

}  // namespace
}  // namespace kd

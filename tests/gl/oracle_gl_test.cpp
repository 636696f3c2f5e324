// The double-precision oracle of renderer/measure, and how a hit is judged by it.

#include "renderer/measure/oracle.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/tree.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

TEST(UlpsBetween, CountsUnitsInTheLastPlaceOfTheExactNumber) {
    EXPECT_EQ(ulps_between(1.0f, 1.0), 0);
    EXPECT_EQ(ulps_between(std::nextafter(1.0f, 2.0f), 1.0), 1);
    EXPECT_EQ(ulps_between(1.0f, 1.0 + 0x1p-25), 0.25) << "a float cannot do better";
    EXPECT_EQ(ulps_between(8.0f, 8.0 + 3 * 0x1p-20), 3);
    EXPECT_EQ(ulps_between(-8.0f, -8.0 - 3 * 0x1p-20), 3);
    EXPECT_TRUE(std::isinf(ulps_between(std::numeric_limits<float>::quiet_NaN(), 1.0)));
    EXPECT_TRUE(std::isinf(ulps_between(1.0f, std::numeric_limits<double>::infinity())));
    EXPECT_TRUE(std::isinf(ulps_between(1.0f, 1e300))) << "beyond any float";
}

const f64::Hit exact_hit{4, 2.0, 0.25, 0.5};
const f64::Hit exact_miss{-1, 10.0, 0, 0};
constexpr float one_ulp = 0x1p-22f;  // of a t in [2, 4)

TEST(HitJudge, AcceptsWhatAgrees) {
    const HitJudge judge;
    EXPECT_EQ(judge.judge({4, 2.0f, 0.25f, 0.5f}, exact_hit).fault, HitFault::none);
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, exact_miss).fault, HitFault::none);
    const HitError near = judge.judge({4, 2.0f + 64 * one_ulp, 0.25f, 0.5f}, exact_hit);
    EXPECT_EQ(near.fault, HitFault::none);
    EXPECT_EQ(near.ulps, 64);
}

TEST(HitJudge, NamesTheFault) {
    const HitJudge judge;
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, exact_hit).fault, HitFault::missed);
    EXPECT_EQ(judge.judge({4, 2.0f, 0.25f, 0.5f}, exact_miss).fault, HitFault::false_hit);
    EXPECT_EQ(judge.judge({4, 2.0f + 65 * one_ulp, 0.25f, 0.5f}, exact_hit).fault, HitFault::wrong_t);
    EXPECT_EQ(judge.judge({4, 2.0f + 65 * one_ulp, 0.25f, 0.5f}, exact_hit).ulps, 65);
    EXPECT_EQ(judge.judge({5, 2.5f, 0.25f, 0.5f}, exact_hit).fault, HitFault::wrong_triangle);
    EXPECT_EQ(judge.judge({4, std::nanf(""), 0.25f, 0.5f}, exact_hit).fault, HitFault::wrong_t);
}

TEST(HitJudge, DoubtAndTiesAreNoFault) {
    const HitJudge judge;
    const f64::Hit at_edge{4, 2.0, 1e-6, 0.5}, at_corner{4, 2.0, 0.5, 0.5 - 1e-6};
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, at_edge).fault, HitFault::none);
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, at_corner).fault, HitFault::none) << "the third edge counts too";
    EXPECT_EQ(judge.judge({4, 2.0f, 1e-6f, 0.5f}, exact_miss).fault, HitFault::none);
    EXPECT_EQ(judge.judge({7, 3.0f, 0.3f, 0.3f}, at_edge).fault, HitFault::none) << "past the edge, what lies behind";
    const HitError tie = judge.judge({5, 2.0f + one_ulp, 0.3f, 0.3f}, exact_hit);
    EXPECT_EQ(tie.fault, HitFault::none);
    EXPECT_EQ(tie.ulps, 1);
    const HitJudge strict{.most_ulps = 0.5, .tie_ulps = 0.5, .margin = 0};
    EXPECT_EQ(strict.judge({-1, 10.0f, 0, 0}, at_edge).fault, HitFault::missed);
    EXPECT_EQ(strict.judge({5, 2.0f + one_ulp, 0.3f, 0.3f}, exact_hit).fault, HitFault::wrong_triangle);
}

TEST(DoubleBruteForce, KnowsWhatAFloatCannotHold) {
    // The plane z = 1 met by a ray that climbs a third per unit: t = 1 / (1/3 as a float).
    const FlatScene scene = test::scene_of({{{Vec3(-9, -9, 1), Vec3(9, -9, 1), Vec3(0, 9, 1)}}});
    const float third = 1.0f / 3.0f;
    const std::vector<Ray> rays{{Vec3(0), Vec3(0, 0, third), 0, 100, -1},
                                {Vec3(0), Vec3(0, 0, -third), 0, 100, -1},
                                {Vec3(0), Vec3(0, 0, third), 0, 2.9f, -1},
                                {Vec3(0), Vec3(0, 0, third), 0, 100, 0}};
    const std::vector<f64::Hit> hits = double_brute_force(scene, rays, 1);
    ASSERT_EQ(hits.size(), 4u);
    EXPECT_EQ(hits[0].triangle, 0);
    EXPECT_EQ(hits[0].t, 1.0 / double(third));
    EXPECT_NE(hits[0].t, double(float(hits[0].t)));
    EXPECT_EQ(hits[1].triangle, -1) << "behind";
    EXPECT_EQ(hits[2].triangle, -1) << "past tmax";
    EXPECT_EQ(hits[3].triangle, -1) << "its own source";
}

TEST(DoubleBruteForce, SinglePrecisionFindsTheSameTriangles) {
    const FlatScene scene = test::scene_of(test::random_soup(200, 0.2f, 3));
    test::Random random(5);
    std::vector<Ray> rays;
    for (int i = 0; i < 5000; ++i) rays.push_back({random.point(-1, 2), random.point(-1, 1), 0.0f, KD_T_LIMIT, -1});
    const std::vector<f64::Hit> exact = double_brute_force(scene, rays);
    std::vector<Hit> found(rays.size());
    const KdTree no_tree;
    CpuTracer(scene, no_tree).trace_rays({.traversal = Traversal::naive}, rays, false, found, {});
    int hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(HitJudge{}.judge(found[i], exact[i]).fault, HitFault::none) << test::hex(rays[i]);
        hits += exact[i].triangle >= 0;
    }
    EXPECT_GT(hits, 300);
}

}  // namespace
}  // namespace kd

// The double-precision oracle of renderer/measure, and how a hit is judged by it.

#include "renderer/measure/oracle.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/tree.h"
#include "renderer/measure/path_rays.h"
#include "renderer/measure/ray_judge.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/trace/counters.h"
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
    EXPECT_EQ(judge.judge({4, 2.0f, 0.25f, 0.5f}, exact_hit).verdict, HitVerdict::agrees);
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, exact_miss).verdict, HitVerdict::agrees);
    const HitError near = judge.judge({4, 2.0f + 64 * one_ulp, 0.25f, 0.5f}, exact_hit);
    EXPECT_EQ(near.verdict, HitVerdict::agrees);
    EXPECT_EQ(near.ulps, 64);
}

TEST(HitJudge, NamesTheFault) {
    const HitJudge judge;
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, exact_hit).verdict, HitVerdict::missed);
    EXPECT_EQ(judge.judge({4, 2.0f, 0.25f, 0.5f}, exact_miss).verdict, HitVerdict::false_hit);
    EXPECT_EQ(judge.judge({4, 2.0f + 65 * one_ulp, 0.25f, 0.5f}, exact_hit).verdict, HitVerdict::wrong_t);
    EXPECT_EQ(judge.judge({4, 2.0f + 65 * one_ulp, 0.25f, 0.5f}, exact_hit).ulps, 65);
    EXPECT_EQ(judge.judge({5, 2.5f, 0.25f, 0.5f}, exact_hit).verdict, HitVerdict::wrong_triangle);
    EXPECT_EQ(judge.judge({4, std::nanf(""), 0.25f, 0.5f}, exact_hit).verdict, HitVerdict::wrong_t);
}

TEST(HitJudge, DoubtAndTiesAreNoFault) {
    const HitJudge judge;
    const f64::Hit at_edge{4, 2.0, 1e-6, 0.5}, at_corner{4, 2.0, 0.5, 0.5 - 1e-6};
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, at_edge).verdict, HitVerdict::tie);
    EXPECT_EQ(judge.judge({-1, 10.0f, 0, 0}, at_corner).verdict, HitVerdict::tie) << "the third edge counts too";
    EXPECT_EQ(judge.judge({4, 2.0f, 1e-6f, 0.5f}, exact_miss).verdict, HitVerdict::tie);
    EXPECT_EQ(judge.judge({7, 3.0f, 0.3f, 0.3f}, at_edge).verdict, HitVerdict::tie)
        << "past the edge, what lies behind";
    const HitError tie = judge.judge({5, 2.0f + one_ulp, 0.3f, 0.3f}, exact_hit);
    EXPECT_EQ(tie.verdict, HitVerdict::tie);
    EXPECT_EQ(tie.ulps, 1);
    const HitJudge strict{.most_ulps = 0.5, .tie_ulps = 0.5, .margin = 0};
    EXPECT_EQ(strict.judge({-1, 10.0f, 0, 0}, at_edge).verdict, HitVerdict::missed);
    EXPECT_EQ(strict.judge({5, 2.0f + one_ulp, 0.3f, 0.3f}, exact_hit).verdict, HitVerdict::wrong_triangle);
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
        EXPECT_FALSE(is_wrong(HitJudge{}.judge(found[i], exact[i]).verdict)) << test::hex(rays[i]);
        hits += exact[i].triangle >= 0;
    }
    EXPECT_GT(hits, 300);
}

FlatScene far_scene() {
    std::vector<Triangle> triangles = test::random_soup(100, 0.3f, 9);
    for (Triangle& triangle : triangles)
        for (Vec3& corner : triangle.corner) corner = corner * 0.01f + Vec3(1000, -2000, 30);
    return test::scene_of(std::move(triangles));
}

/// The boxes may save time and nothing else: every bit is that of the loop over all triangles.
TEST(DoubleOracle, AnswersAsBruteForceDoes) {
    const FlatScene scenes[] = {test::scene_of(test::random_soup(3000, 0.1f, 11)),
                                test::scene_of(test::stress_sphere(40, 20)),
                                test::mirror_scene(500, 2),
                                far_scene(),
                                test::scene_of({}),
                                test::scene_of(test::random_soup(1, 1, 1))};
    for (const FlatScene& scene : scenes) {
        std::vector<Ray> rays;
        if (!scene.triangles.empty()) rays = test::unkind_rays(scene.triangles, 4000, 3);
        test::Random random(6);
        for (int i = 0; i < 1000; ++i)
            rays.push_back({random.point(-1, 1) * std::ldexp(1.0f, random.below(40) - 20),
                            random.point(-1, 1) * std::ldexp(1.0f, random.below(40) - 20), 0.0f, KD_T_LIMIT, -1});
        rays.push_back({Vec3(0), Vec3(0), 0.0f, KD_T_LIMIT, -1});
        rays.push_back({Vec3(std::nanf("")), Vec3(1, 0, 0), 0.0f, KD_T_LIMIT, -1});
        const DoubleOracle oracle(scene);
        const std::vector<f64::Hit> expected = double_brute_force(scene, rays), found = oracle.nearest(rays);
        const std::vector<Hit> single = brute_force(scene, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const f64::Hit &a = expected[i], &b = found[i];
            EXPECT_TRUE(a.triangle == b.triangle && a.t == b.t && a.u == b.u && a.v == b.v) << test::hex(rays[i]);
            EXPECT_TRUE(bit_equal(single[i], plain_nearest_hit(scene, oracle.boxes(), rays[i]))) << test::hex(rays[i]);
        }
    }
}

/// Two triangles that share the edge from (0, -1, 0) to (0, 1, 0).
FlatScene square() {
    return test::scene_of(
        {{{Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0)}}, {{Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}});
}

JudgedHit judged(const FlatScene& scene, const Ray& ray, const Hit& found, int exit_reason) {
    const DoubleOracle oracle(scene);
    return judge_ray(oracle, ray, oracle.nearest(ray), found, uint(exit_reason));
}

const Hit no_hit_found{-1, KD_T_LIMIT, 0, 0};

TEST(JudgeRay, AWalkThatWasGivenUpIsUnfinishedWhateverItFound) {
    const FlatScene scene = square();
    const Ray ray{Vec3(0.25f, 0, 1), Vec3(0, 0, -1), 0, KD_T_LIMIT, -1};
    const Hit right = brute_force(scene, std::span(&ray, 1))[0];
    EXPECT_EQ(judged(scene, ray, right, KD_EXIT_HIT).verdict, HitVerdict::agrees);
    EXPECT_EQ(judged(scene, ray, right, KD_EXIT_STEP_CAP).verdict, HitVerdict::unfinished);
    EXPECT_EQ(judged(scene, ray, right, KD_EXIT_STACK_OVERFLOW).verdict, HitVerdict::unfinished);
    EXPECT_EQ(judged(scene, ray, no_hit_found, KD_EXIT_MISS).verdict, HitVerdict::missed);
    EXPECT_EQ(judged(scene, ray, no_hit_found, KD_EXIT_INVALID_RAY).verdict, HitVerdict::unfinished) << "it was a ray";
}

TEST(JudgeRay, ARayThatIsNoneHasNoFault) {
    const Ray ray{Vec3(0.25f, 0, 1), Vec3(0), 0, KD_T_LIMIT, -1};
    EXPECT_EQ(judged(square(), ray, no_hit_found, KD_EXIT_INVALID_RAY).verdict, HitVerdict::agrees);
}

TEST(JudgeRay, ThereIsNoDoubtWhereBruteForceHasNone) {
    const FlatScene scene = square();
    const Ray through_edge{Vec3(0, 0.25f, 1), Vec3(0, 0, -1), 0, KD_T_LIMIT, -1};
    EXPECT_EQ(judged(scene, through_edge, no_hit_found, KD_EXIT_MISS).verdict, HitVerdict::missed) << "a hole";
    const Hit first = brute_force(scene, std::span(&through_edge, 1))[0];
    EXPECT_EQ(judged(scene, through_edge, first, KD_EXIT_HIT).verdict, HitVerdict::agrees);
    Hit other = hit_of_triangle(scene, 1 - first.triangle, through_edge);
    EXPECT_EQ(judged(scene, through_edge, other, KD_EXIT_HIT).verdict, HitVerdict::tie) << "both lie there";
    other.u = first.u + 0.125f;
    EXPECT_EQ(judged(scene, through_edge, other, KD_EXIT_HIT).verdict, HitVerdict::wrong_triangle)
        << "the ray meets it elsewhere";
}

TEST(JudgeRay, NearItsOriginThePointCountsAndNotTheDigitsOfT) {
    const FlatScene scene = square();
    // A float of t = 2^-12 has digits that coordinates near 1 have not.
    const Ray close{Vec3(0.75f, 0, 0x1p-12f), Vec3(0, 0, -1), 0, KD_T_LIMIT, -1};
    Hit hit = brute_force(scene, std::span(&close, 1))[0];
    ASSERT_EQ(hit.t, 0x1p-12f);
    hit.t += 0x1p-20f;
    EXPECT_EQ(judged(scene, close, hit, KD_EXIT_HIT).verdict, HitVerdict::agrees);
    EXPECT_GT(judged(scene, close, hit, KD_EXIT_HIT).ulps, 1000);
    hit.t += 0x1p-14f;
    EXPECT_EQ(judged(scene, close, hit, KD_EXIT_HIT).verdict, HitVerdict::wrong_t);
}

}  // namespace
}  // namespace kd

// Fits, intervals, fronts, ranks and image errors, on numbers that can be checked by hand.

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "renderer/measure/error_time/break_even.h"
#include "renderer/measure/error_time/fit.h"
#include "renderer/measure/error_time/flip.h"
#include "renderer/measure/error_time/image_error.h"
#include "renderer/measure/error_time/image_report.h"
#include "renderer/measure/error_time/lines.h"
#include "renderer/measure/error_time/ranking.h"
#include "renderer/measure/error_time/sampling.h"
#include "renderer/measure/error_time/tree_report.h"

namespace kd {
namespace {

using Colours = Image<glm::dvec3>;

TEST(Fit, PowerLawIsFoundWithItsSlopeAndScale) {
    const std::array x{1.0, 2.0, 4.0, 8.0, 16.0};
    std::vector<double> y;
    for (const double v : x) y.push_back(3 * std::pow(v, -0.75));
    const PowerFit fit = fit_power(x, y);
    EXPECT_NEAR(fit.slope, -0.75, 1e-12);
    EXPECT_NEAR(fit.scale, 3, 1e-12);
    EXPECT_NEAR(fit.interval.low, -0.75, 1e-6);
    EXPECT_NEAR(fit.interval.high, -0.75, 1e-6);
}

TEST(Fit, IntervalIsStudents) {
    // Residuals +e, -2e, +e about a line through three points at log x = 0, 1, 2: s^2 = 6 e^2, S_xx = 2.
    const double e = 0.01;
    const std::array x{1.0, std::exp(1.0), std::exp(2.0)};
    const std::array y{std::exp(e), std::exp(-1 - 2 * e), std::exp(-2 + e)};
    const PowerFit fit = fit_power(x, y);
    EXPECT_NEAR(fit.slope, -1, 1e-12);
    EXPECT_NEAR(fit.interval.high - fit.slope, 12.7062 * e * std::sqrt(3.0), 1e-6);
}

TEST(Fit, ZerosAreLeftOutAndTwoPointsPromiseNothing) {
    const std::array x{1.0, 2.0, 4.0};
    const std::array y{1.0, 0.0, 0.5};
    const PowerFit fit = fit_power(x, y);
    EXPECT_EQ(fit.points, 2);
    EXPECT_NEAR(fit.slope, -0.5, 1e-12);
    EXPECT_TRUE(std::isinf(fit.interval.low));
    EXPECT_EQ(fit_power(x, std::array{0.0, 0.0, 0.0}).points, 0);
}

TEST(Fit, StudentQuantilesAreThoseOfTables) {
    for (const auto& [n, exact] : std::vector<std::pair<int, double>>{{1, 12.706},
                                                                      {2, 4.3027},
                                                                      {3, 3.1824},
                                                                      {4, 2.7764},
                                                                      {5, 2.5706},
                                                                      {10, 2.2281},
                                                                      {30, 2.0423},
                                                                      {1000, 1.9623}})
        EXPECT_NEAR(student_quantile(n) / exact, 1, 0.01) << n;
}

TEST(Fit, IntervalsOverSetsAreStudents) {
    const SquaredErrors sets{{1.0, 0.25}, {1.2, 0.27}, {0.8, 0.26}, {1.1, 0.22}};
    EXPECT_NEAR(root_means(sets)[0], std::sqrt(1.025), 1e-12);
    const Interval interval = root_mean_interval(sets, 0);
    EXPECT_LT(interval.low, std::sqrt(1.025));
    EXPECT_GT(interval.high, std::sqrt(1.025));
    const PowerFit fit = fit_power_over_sets(std::array{1.0, 4.0}, sets);
    EXPECT_LT(fit.interval.low, fit.slope);
    EXPECT_GT(fit.interval.high, fit.slope);
    // Of the logarithm of a mean: 3.182 standard errors of the mean (0.0854 of 1.025), but for terms of second order.
    const Interval mean = mean_interval({1.0, 1.2, 0.8, 1.1});
    EXPECT_NEAR(std::log(mean.high / 1.025), 3.182 * 0.0854 / 1.025, 0.01);
    EXPECT_NEAR(mean.low * mean.high, 1.025 * 1.025, 1e-9);
    EXPECT_EQ(root_mean_interval({{4.0}}, 0).low, 2.0);
    EXPECT_EQ(mean_interval({0.123477}).low, 0.123477) << "one set: itself, not nearly";
    EXPECT_EQ(mean_interval({0.123477}).high, 0.123477);
    EXPECT_EQ(mean_interval({0.0, 0.0}).high, 0.0);
}

TEST(Ranking, FrontHoldsWhatNothingBeatsInBoth) {
    const std::array<TimeAndError, 6> methods{{{1, 10}, {2, 5}, {2, 6}, {3, 5}, {4, 1}, {std::nan(""), 0}}};
    EXPECT_EQ(pareto_front(methods), (std::vector<bool>{true, true, false, false, true, false}));
    // Equals do not beat each other.
    EXPECT_EQ(pareto_front(std::array<TimeAndError, 2>{{{1, 1}, {1, 1}}}), (std::vector<bool>{true, true}));
}

TEST(Ranking, KendallsTauCountsPairs) {
    const std::array a{1.0, 2.0, 3.0, 4.0};
    EXPECT_EQ(kendall_tau(a, std::array{10.0, 20.0, 30.0, 40.0}), 1);
    EXPECT_EQ(kendall_tau(a, std::array{4.0, 3.0, 2.0, 1.0}), -1);
    EXPECT_NEAR(kendall_tau(a, std::array{1.0, 2.0, 4.0, 3.0}), 4.0 / 6, 1e-12);  // five pairs agree, one does not
    EXPECT_NEAR(kendall_tau(a, std::array{1.0, 1.0, 2.0, 3.0}), 5 / std::sqrt(30.0), 1e-12);  // tau-b: one pair tied
    EXPECT_EQ(kendall_tau(a, std::array{5.0, 5.0, 5.0, 5.0}), 0);
}

TEST(Ranking, SpearmansRho) {
    const std::array a{1.0, 2.0, 3.0, 4.0};
    EXPECT_DOUBLE_EQ(spearman_rho(a, std::array{1.0, 10.0, 100.0, 1000.0}), 1) << "of ranks alone";
    EXPECT_DOUBLE_EQ(spearman_rho(a, std::array{4.0, 3.0, 2.0, 1.0}), -1);
    EXPECT_DOUBLE_EQ(spearman_rho(a, std::array{1.0, 2.0, 4.0, 3.0}), 0.8);  // 1 - 6 (1 + 1) / (4 * 15)
    // Ranks 1.5 1.5 3 4 against 1 2 3 4: covariance 4.5, variances 4.5 and 5.
    EXPECT_DOUBLE_EQ(spearman_rho(a, std::array{7.0, 7.0, 8.0, 9.0}), 4.5 / std::sqrt(22.5));
    EXPECT_TRUE(std::isnan(spearman_rho(a, std::array{5.0, 5.0, 5.0, 5.0})));
    EXPECT_TRUE(std::isnan(spearman_rho({}, {})));
}

TEST(Ranking, FramesUntilABetterTreePays) {
    const MedianInterval slower = median_interval({1.1, 1.1, 1.2, 1.2, 1.3, 1.3});
    EXPECT_NEAR(break_even(100, 300, 10, slower).value(), 100, 1e-9);
    EXPECT_EQ(break_even(300, 100, 10, slower).value(), 0) << "no slower to build";
    EXPECT_FALSE(break_even(100, 300, 10, median_interval({0.9, 1.1, 1.2, 1.2, 1.3, 1.3})).has_value()) << "holds 1";
    EXPECT_FALSE(break_even(100, 300, 10, median_interval({0.5, 0.5, 0.5, 0.5, 0.5, 0.5})).has_value());
    EXPECT_FALSE(break_even(100, 300, 10, median_interval({1.1, 1.2, 1.3})).has_value()) << "too few rounds";
}

Colours plain(int width, int height, glm::dvec3 colour) { return {width, height, colour}; }

Colours checked(int width, int height) {
    Colours image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = (x / 4 + y / 4) % 2 ? glm::dvec3(0.9, 0.2, 0.1) : glm::dvec3(0.1, 0.4, 0.8);
    return image;
}

TEST(ErrorTimeMath, BreakEvenHasAnIntervalOverRounds) {
    const std::vector<double> builds_a{90, 100, 100, 100, 110, 100}, builds_b{290, 300, 300, 300, 310, 300};
    const std::vector<double> frames_a{11.9, 12, 12, 12, 12.1, 12}, frames_b{10, 10, 10, 10, 10, 10};
    const Interval pays = break_even_interval({builds_a, frames_a}, {builds_b, frames_b}, 1);
    EXPECT_TRUE(pays.holds(100)) << pays.low << ' ' << pays.high;
    EXPECT_GT(pays.low, 85);
    EXPECT_LT(pays.high, 115);
    EXPECT_LT(pays.low, pays.high) << "rounds differ";
    // Builds of b alone differ, so n* is half of what their median is above 100. Six are drawn from these six: their
    // median is 280 where four or more are 280 (0.9 %), and at most 285 where three are and one is 290 (2.6 % more).
    // The 2.5 % at either end lie in the second step.
    const std::vector<double> alike(6, 100), varying{280, 290, 300, 300, 310, 320}, slower(6, 12);
    const Interval of_builds = break_even_interval({alike, slower}, {varying, frames_b}, 1);
    EXPECT_NEAR(of_builds.low, 92.5, 1e-9);
    EXPECT_NEAR(of_builds.high, 107.5, 1e-9);
    // Half of the rounds say that b never pays.
    const std::vector<double> unsure{9, 9, 9, 12, 12, 12};
    EXPECT_EQ(break_even_interval({builds_a, unsure}, {builds_b, frames_b}, 1).high,
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(break_even_interval({builds_b, frames_a}, {builds_a, frames_b}, 1).high, 0) << "no slower to build";
}

TEST(ErrorTimeMath, RankCorrelationHasAnIntervalOverPairs) {
    std::vector<double> x, y, noise;
    for (int i = 0; i < 20; ++i) {
        x.push_back(i);
        y.push_back(i % 7 == 3 ? i - 4.5 : i);
        noise.push_back(std::abs(i - 9.4));  // falls as long as it rises
    }
    const RankCorrelation alike = rank_correlation(x, x, 1), close = rank_correlation(x, y, 1),
                          none = rank_correlation(x, noise, 1);
    EXPECT_EQ(alike.interval.low, 1);
    EXPECT_EQ(close.tau, kendall_tau(x, y));
    EXPECT_TRUE(close.interval.holds(close.tau));
    EXPECT_GT(close.interval.low, 0.4);
    EXPECT_LT(close.interval.low, close.tau);
    EXPECT_TRUE(none.interval.holds(0)) << none.interval.low << ' ' << none.interval.high;
}

TEST(ErrorTimeMath, LinesThatAreTooFewDecideNothing) {
    TreeStats predicted;
    predicted.sah_cost = predicted.expected_interior_visits = predicted.expected_triangle_tests = 2;
    const auto judged = [&](std::initializer_list<double> per_set) {
        std::vector<PassedCells> sets;
        for (const double met : per_set) sets.push_back({.rays = 100, .interior = met, .tests = met, .cost = met});
        return line_ratios(sets, predicted, 1);
    };
    EXPECT_EQ(judged({198, 200, 200, 202}).verdict(), LineVerdict::right);
    EXPECT_EQ(judged({218, 220, 220, 222}).verdict(), LineVerdict::wrong);
    EXPECT_NEAR(judged({218, 220, 220, 222}).error(), 0.1, 1e-12);
    EXPECT_EQ(judged({100, 300, 250, 190}).verdict(), LineVerdict::open);
    // What is met once in a million lines is not met by four hundred.
    predicted.expected_triangle_tests = predicted.expected_interior_visits = predicted.sah_cost = 1e-6;
    const LineRatios none = judged({0, 0, 0, 0});
    EXPECT_EQ(none.cost.ratio, 0);
    EXPECT_EQ(none.cost.interval.high, 3.0 / 400 / 1e-6);
    EXPECT_EQ(none.verdict(), LineVerdict::open);
}

TEST(ImageError, MeanSquareOfKnownImages) {
    EXPECT_EQ(mean_square_error(checked(8, 8), checked(8, 8)), 0);
    EXPECT_NEAR(mean_square_error(plain(5, 3, glm::dvec3(0)), plain(5, 3, {0.3, 0, 0})), 0.03, 1e-15);
}

TEST(ImageError, SamplesAreAveragedInDouble) {
    SampleMean mean(1, 1);
    for (int i = 0; i < 3; ++i) mean.add(Image<Vec4>(1, 1, Vec4(0.1f, 2.0f, -1.0f, 1.0f)));
    EXPECT_EQ(mean.samples(), 3);
    EXPECT_NEAR(mean.mean().at(0, 0).x, double(0.1f), 1e-16);
    EXPECT_EQ(mean.mean().at(0, 0).y, 2.0);  // not clipped
}

TEST(FlipError, NothingBetweenEqualImages) { EXPECT_EQ(Flip(checked(24, 16)).mean(checked(24, 16)), 0); }

TEST(FlipError, BlackToWhiteIsWhatThePaperDefines) {
    // Neither filters nor features act on plain images: |L - L'| = 100, then the paper's map of errors. The largest
    // distance is between green and blue: L* = 87.73 and 32.30, a* and b* after Hunt's adjustment.
    const double found = Flip(plain(16, 16, glm::dvec3(0))).mean(plain(16, 16, glm::dvec3(1)));
    const glm::dvec3 green(87.7350, 0.877350 * -86.1829, 0.877350 * 83.1795);
    const glm::dvec3 blue(32.3009, 0.323009 * 79.1952, 0.323009 * -107.8554);
    const double most = std::pow(std::abs(green.x - blue.x) + std::hypot(green.y - blue.y, green.z - blue.z), 0.7);
    const double expected = 0.95 + (std::pow(100.0, 0.7) - 0.4 * most) / (0.6 * most) * 0.05;
    EXPECT_NEAR(found, expected, 1e-4);
}

TEST(FlipError, IsSymmetricAndWithinItsRange) {
    const Colours a = checked(20, 20), b = plain(20, 20, {0.5, 0.3, 0.4});
    EXPECT_NEAR(Flip(a).mean(b), Flip(b).mean(a), 1e-12);
    for (const double v : Flip(a).map(b).pixels) {
        EXPECT_GE(v, 0);
        EXPECT_LE(v, 1);
    }
}

TEST(FlipError, GrowsWithTheDifferenceAndSeesEdgesMore) {
    const Colours grey = plain(32, 32, glm::dvec3(0.5));
    const Flip flip(grey);
    double before = 0;
    for (const double step : {0.01, 0.05, 0.2, 0.5}) {
        const double now = flip.mean(plain(32, 32, glm::dvec3(0.5 + step)));
        EXPECT_GT(now, before);
        before = now;
    }
    Colours edge = grey;
    for (int y = 0; y < 32; ++y)
        for (int x = 16; x < 32; ++x) edge.at(x, y) = glm::dvec3(0.6);
    const Image<double> map = flip.map(edge);
    EXPECT_GT(map.at(16, 16), map.at(31, 16));  // the same colours, but an edge that is not there
}

TEST(FlipError, FineDetailFadesWithDistance) {
    Colours lines = plain(48, 48, glm::dvec3(0.5));
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) lines.at(x, y) = glm::dvec3(x % 2 ? 0.6 : 0.4);
    const Colours grey = plain(48, 48, glm::dvec3(0.5));
    EXPECT_GT(Flip(grey, 20).mean(lines), Flip(grey, 120).mean(lines));
}

TEST(Sampling, OffsetsLieWhereTheSamplerSays) {
    for (const Sampler sampler : {Sampler::regular, Sampler::independent, Sampler::stratified})
        for (const int n : {1, 2, 3, 8, 16}) {
            const auto offsets = sample_offsets(sampler, n, 7);
            ASSERT_EQ(int(offsets.size()), n);
            for (const glm::dvec2 o : offsets)
                EXPECT_TRUE(o.x >= -0.5 && o.x < 0.5 && o.y >= -0.5 && o.y < 0.5) << name_of(sampler);
        }
    EXPECT_EQ(sample_offsets(Sampler::regular, 1, 1)[0], glm::dvec2(0));
    EXPECT_EQ(sample_offsets(Sampler::regular, 8, 1)[5], glm::dvec2(-0.125, 0.25));  // 4 columns, 2 rows
    std::vector<int> taken(16, 0);
    for (const glm::dvec2 o : sample_offsets(Sampler::stratified, 16, 3))
        ++taken[std::size_t(std::floor((o.x + 0.5) * 4) + 4 * std::floor((o.y + 0.5) * 4))];
    EXPECT_EQ(taken, std::vector<int>(16, 1));
    const auto few = sample_offsets(Sampler::independent, 4, 5), many = sample_offsets(Sampler::independent, 9, 5);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(Sampling, PlanFitsItsBudgetWhereOneDoes) {
    const std::vector<double> methods{4, 8, 20};
    const ImagePlan cheap = plan_images(5, methods, 30, 96 * 96), dear = plan_images(500, methods, 30, 96 * 96);
    EXPECT_LE(cheap.predicted_seconds, 5);
    EXPECT_LE(dear.predicted_seconds, 500);
    EXPECT_GT(dear.predicted_seconds, cheap.predicted_seconds);
    EXPECT_GE(dear.reference_samples, 8 * dear.most_samples);
}

TEST(Lines, EnterAsOftenAsFacesAreLarge) {
    const Aabb box{Vec3(0, 0, 0), Vec3(1, 2, 4)};
    Random random(1);
    const std::vector<Ray> lines = uniform_lines(box, 40000, random);
    ASSERT_EQ(lines.size(), 40000u);
    // Of parallel planes x = 0 and x = 1 with area 8 each, of 28 in all: entered there as often.
    int across_x = 0;
    for (const Ray& ray : lines) {
        glm::dvec3 enter((ray.direction.x > 0 ? 0.0 : 1.0) - double(ray.origin.x),
                         (ray.direction.y > 0 ? 0.0 : 2.0) - double(ray.origin.y),
                         (ray.direction.z > 0 ? 0.0 : 4.0) - double(ray.origin.z));
        enter /= glm::dvec3(ray.direction);
        across_x += enter.x > enter.y && enter.x > enter.z;
    }
    EXPECT_NEAR(across_x / 40000.0, 16.0 / 28, 0.01);
    EXPECT_TRUE(uniform_lines(Aabb{Vec3(0), Vec3(0)}, 5, random).empty());
}

}  // namespace
}  // namespace kd

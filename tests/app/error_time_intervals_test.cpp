// Whether intervals of 95 % hold the truth that often: trials at the sizes at which errortime uses each.

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "renderer/measure/error_time/break_even.h"
#include "renderer/measure/error_time/fit.h"
#include "renderer/measure/error_time/line_ratios.h"
#include "renderer/measure/error_time/ranking.h"

namespace kd {
namespace {

constexpr int trials = 400;
constexpr int as_promised = 380;  // 95 % of them
constexpr int by_chance = 13;     // three standard deviations of that binomial

/// Trials whose interval holds the truth; `measure` makes one, from its number.
template <class Measure>
int held(double truth, const Measure& measure) {
    int count = 0;
    for (int trial = 0; trial < trials; ++trial) count += measure(std::uint64_t(trial)).holds(truth);
    return count;
}

/// Of the normal distribution (Box and Muller).
double normal(Random& random) {
    const double u = random.unit(), v = random.unit();
    return std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * std::numbers::pi * v);
}

/// Errors of slope -1/2 (squares: -1) by some sets of samples, each as much as 30 % off, in part all of a set together.
class NoisySets {
  public:
    static constexpr std::array samples{1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};

    SquaredErrors draw(int count) {
        SquaredErrors sets;
        for (int i = 0; i < count; ++i) {
            const double together = noise();
            sets.emplace_back();
            for (const double n : samples) sets.back().push_back((1 + together + noise()) / n);
        }
        return sets;
    }

  private:
    Random random_{1};
    double noise() { return random_.between(-0.3, 0.3); }
};

/// The slope's interval by the percentiles of sets drawn again, which errortime does not use.
Interval slope_by_percentiles(const SquaredErrors& sets, std::uint64_t seed) {
    return bootstrap_interval(seed, [&](Random& random) {
        SquaredErrors drawn;
        for (const std::size_t place : drawn_again(sets.size(), random)) drawn.push_back(sets[place]);
        return fit_power(NoisySets::samples, root_means(drawn)).slope;
    });
}

TEST(Intervals, OverSetsByTheJackknifeNotByPercentiles) {
    for (const int count : {4, 8}) {
        NoisySets noisy;
        int by_percentiles = 0, means = 0;
        const int slopes = held(-0.5, [&](std::uint64_t seed) {
            const SquaredErrors sets = noisy.draw(count);
            by_percentiles += slope_by_percentiles(sets, seed).holds(-0.5);
            means += root_mean_interval(sets, 0).holds(1);
            return fit_power_over_sets(NoisySets::samples, sets).interval;
        });
        EXPECT_NEAR(slopes, as_promised, by_chance) << count;
        EXPECT_NEAR(means, as_promised, by_chance) << count;
        // In 4000 trials: 80 % with four sets, 89 % with eight. Three standard deviations of 400 are 24 and 19.
        EXPECT_NEAR(by_percentiles, count == 4 ? 320 : 356, count == 4 ? 24 : 19) << count;
    }
}

TEST(Intervals, OfBreakEvenOverRounds) {
    Random random(1);
    const auto spread = [&](double middle, double share) { return middle * std::exp(share * normal(random)); };
    for (const auto& [rounds, of_builds] : {std::pair(6, 0.02), std::pair(6, 0.1), std::pair(31, 0.02)}) {
        // Median frames of 12 and 10 ms, which a round slows down together; builds of 100 and 300 ms.
        const int count = held(100, [&](std::uint64_t seed) {
            std::array<std::vector<double>, 2> builds, frames;
            for (int i = 0; i < rounds; ++i) {
                const double together = spread(1, 0.01);
                for (const std::size_t tree : {0u, 1u}) {
                    builds[tree].push_back(spread(tree == 0 ? 100 : 300, of_builds));
                    frames[tree].push_back(together * spread(tree == 0 ? 12 : 10, 0.005));
                }
            }
            return break_even_interval({builds[0], frames[0]}, {builds[1], frames[1]}, seed);
        });
        EXPECT_NEAR(count, as_promised, by_chance) << rounds << " rounds, builds " << of_builds;
    }
}

TEST(Intervals, OfKendallsTauOverTrees) {
    Random random(1);
    for (const auto& [tau, usual_width] : {std::pair(0.0, 0.62), std::pair(0.6, 0.43), std::pair(0.8, 0.28)}) {
        // Of two normal numbers of correlation r it is 2/pi asin r (Kendall).
        const double r = std::sin(tau * std::numbers::pi / 2);
        double width = 0;
        const int count = held(tau, [&](std::uint64_t seed) {
            std::vector<double> x, y;
            for (int i = 0; i < 23; ++i) {
                x.push_back(normal(random));
                y.push_back(r * x.back() + std::sqrt(1 - r * r) * normal(random));
            }
            const Interval interval = rank_correlation(x, y, seed).interval;
            width += (interval.high - interval.low) / trials;
            return interval;
        });
        EXPECT_GE(count, as_promised - by_chance) << tau;
        EXPECT_NEAR(width, usual_width, 0.02) << "it holds more than it says, but not by being as wide as can be";
    }
}

TEST(Intervals, OfLinesOverSets) {
    // What a line meets: 1 on average, as skewed as exponential numbers are. A set has 100 of them.
    Random random(1);
    const auto met_by_a_set = [&] {
        double met = 0;
        for (int line = 0; line < 100; ++line) met -= std::log(1 - random.unit());
        return met;
    };
    TreeStats predicted;
    predicted.sah_cost = predicted.expected_interior_visits = predicted.expected_triangle_tests = 1;
    const int count = held(1, [&](std::uint64_t seed) {
        std::vector<PassedCells> sets;
        for (int i = 0; i < 40; ++i) sets.push_back({.rays = 100, .cost = met_by_a_set()});
        return line_ratios(sets, predicted, seed).cost.interval;
    });
    EXPECT_NEAR(count, as_promised, by_chance);
}

}  // namespace
}  // namespace kd

// renderer/measure: the timing service, and comparisons that know what they do not know.
#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "renderer/measure/measured_on.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {
namespace {

TEST(Timing, QuartilesLieBetweenSamples) {
    const TimeSummary four = summarise({4, 1, 3, 2});
    EXPECT_EQ(four.median_ms, 2.5);
    EXPECT_EQ(four.p25_ms, 1.75);
    EXPECT_EQ(four.p75_ms, 3.25);
    EXPECT_EQ(four.samples, 4);
    EXPECT_EQ(summarise({7}).p75_ms, 7);
    EXPECT_EQ(summarise({}).samples, 0);
}

TEST(Timing, ContestantsTakeTurnsForwardAndBackward) {
    std::string order;
    const std::vector<Contestant> two{{"a", [&] { return order += 'a', TimeSample{1.0}; }},
                                      {"b", [&] { return order += 'b', TimeSample{2.0}; }}};
    std::vector<int> told;
    const auto times =
        time_in_turn(two, {.warmup = 2, .rounds = 3}, [&](int rounds, std::span<const TimedRounds> so_far) {
            told.push_back(rounds);
            EXPECT_EQ(int(so_far[1].rounds.size()), rounds);
        });
    EXPECT_EQ(order, "aabb"
                     "abbaab");
    EXPECT_EQ(told, (std::vector<int>{1, 2, 3}));
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].name, "a");
    EXPECT_EQ(times[0].total().median_ms, 1.0);
    EXPECT_EQ(times[1].total().samples, 3);
}

TEST(Timing, ARoundEndsWhereSomebodyGivesUp) {
    std::vector<std::size_t> ran;
    const auto until = [&](std::size_t last) {
        return [&ran, last](std::size_t i) { return ran.push_back(i), i != last; };
    };
    EXPECT_FALSE(take_turns(3, 0, until(1)));
    EXPECT_FALSE(take_turns(3, 1, until(1)));
    EXPECT_TRUE(take_turns(2, 3, until(9)));
    EXPECT_EQ(ran, (std::vector<std::size_t>{0, 1, 2, 1, 1, 0}));
}

TEST(Timing, ABudgetEndsTheRoundsButNotBeforeTheLeast) {
    const std::vector<Contestant> one{{"a", [] { return TimeSample{1.0}; }}};
    const TimingPlan plan{.warmup = 0, .rounds = 100, .budget_s = 1e-9, .least_rounds = 6};
    EXPECT_EQ(time_in_turn(one, plan)[0].rounds.size(), 6u);
    EXPECT_EQ(time_in_turn(one, {.warmup = 0, .rounds = 4, .budget_s = 1e-9})[0].rounds.size(), 4u);
}

TEST(Timing, RoundsWithinNoTimeAtAllAreTheLeastThatSayAnything) {
    const std::vector<Contestant> one{{"a", [] { return TimeSample{1.0}; }}};
    for (const double seconds : {0.0, 1e-12}) {
        const TimedRounds timed = time_in_turn(one, rounds_within(seconds))[0];
        EXPECT_EQ(timed.rounds.size(), 6u);
        EXPECT_TRUE(ratio_interval(timed.ms(), timed.ms()).sure());
    }
    EXPECT_EQ(time_in_turn(one, rounds_within(1e6))[0].rounds.size(), 31u);
}

/// Two contestants that take a second each by a clock of their own, warmed up once, and a claim that is open until
/// there are `closes_at` rounds of them.
struct OpenClaim {
    int closes_at;
    double clock_s = 0;
    std::string order = {};
    std::vector<int> looks = {}, told = {};

    std::vector<TimedRounds> time(TimingPlan plan) {
        const auto run = [this](char name) {
            order += name;
            clock_s += 1;
            return TimeSample{double(order.size())};  // no two are alike
        };
        plan.warmup = 1;
        plan.clock = [this] { return clock_s; };
        plan.is_open = [this] {
            looks.push_back(told.empty() ? 0 : told.back());
            return looks.back() < closes_at;
        };
        return time_in_turn({{"a", [=] { return run('a'); }}, {"b", [=] { return run('b'); }}}, plan,
                            [&](int rounds, std::span<const TimedRounds>) { told.push_back(rounds); });
    }
};

/// All rounds, in the order in which they were run: forward and backward by turns, none twice and none lost.
void expect_every_round(const OpenClaim& claim, const std::vector<TimedRounds>& timed, int rounds) {
    std::string order = "ab";
    for (int round = 0; round < rounds; ++round) order += round % 2 == 0 ? "ab" : "ba";
    EXPECT_EQ(claim.order, order);
    ASSERT_EQ(timed.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_EQ(int(timed[i].rounds.size()), rounds);
        for (int round = 0; round < rounds; ++round)
            EXPECT_EQ(timed[i].rounds[std::size_t(round)].ms, 3 + 2 * round + int((i + std::size_t(round)) % 2));
    }
    ASSERT_EQ(int(claim.told.size()), rounds);
    for (int round = 0; round < rounds; ++round) EXPECT_EQ(claim.told[std::size_t(round)], round + 1);
}

TEST(Timing, RoundsGoOnWhileAClaimIsOpen) {
    OpenClaim never{.closes_at = 9}, twice{.closes_at = 19};
    expect_every_round(never, never.time({.rounds = 9}), 9);
    EXPECT_EQ(never.looks, (std::vector<int>{9}));
    // Seven rounds at first: the turns of those that follow go on from there.
    expect_every_round(twice, twice.time({.rounds = 7}), 19);
    EXPECT_EQ(twice.looks, (std::vector<int>{7, 13, 19})) << "no look after every round";
    // The same where a budget ends the first: round 9 begins after 16 of 17 seconds.
    OpenClaim in_time{.closes_at = 15};
    expect_every_round(in_time, in_time.time({.rounds = 31, .budget_s = 17}), 15);
    EXPECT_EQ(in_time.looks, (std::vector<int>{9, 15}));
}

TEST(Timing, NoRoundBeginsThatWouldEndTooLate) {
    // By the clock 10 seconds have passed before the warm-up, which takes 2: round n ends at 12 + 2 n.
    const auto timed_until = [](double ends_at_s, TimingPlan plan) {
        OpenClaim claim{.closes_at = 1000, .clock_s = 10};
        plan.ends_at_s = ends_at_s;
        const std::vector<TimedRounds> timed = claim.time(plan);
        expect_every_round(claim, timed, int(timed[0].rounds.size()));
        return claim.clock_s;
    };
    EXPECT_EQ(timed_until(50, {.rounds = 9}), 50) << "the last may end on time";
    EXPECT_EQ(timed_until(49.9, {.rounds = 9}), 48) << "in the midst of those that follow";
    EXPECT_EQ(timed_until(40, {.rounds = 31}), 40) << "and before the plan is done";
    EXPECT_EQ(timed_until(5, {.rounds = 31}), 24) << "but the least are made in any case";
}

TEST(Timing, ClocksAreHeldAgainstEachOther) {
    TimedRounds rounds;
    EXPECT_EQ(rounds.clock_discrepancy(), 0);
    rounds.rounds = {{10, 11, {}}, {10, 12, {}}, {10, 13, {}}, {10, -1, {}}};
    EXPECT_NEAR(rounds.clock_discrepancy(), 0.2, 1e-12);
    EXPECT_EQ(rounds.pass(0).samples, 4);
}

TEST(MedianInterval, IsTheSignTestsWithItsConfidence) {
    std::vector<double> values;
    for (int i = 15; i >= 1; --i) values.push_back(i);
    const MedianInterval fifteen = median_interval(values);
    EXPECT_EQ(fifteen.median, 8);
    EXPECT_EQ(fifteen.low, 4);  // tables of the sign test: n = 15, k = 4, 96.5 %
    EXPECT_EQ(fifteen.high, 12);
    EXPECT_NEAR(fifteen.confidence, 0.9648, 1e-4);
    const MedianInterval six = median_interval({6, 1, 5, 2, 4, 3});
    EXPECT_EQ(six.low, 1);
    EXPECT_EQ(six.high, 6);
    EXPECT_NEAR(six.confidence, 0.96875, 1e-9);
    EXPECT_TRUE(six.sure());
    EXPECT_EQ(six.samples, MedianInterval::least_samples);
    const MedianInterval five = median_interval({1, 2, 3, 4, 5});
    EXPECT_FALSE(five.sure());
    EXPECT_EQ(five.high, 5);
    EXPECT_EQ(median_interval({}).samples, 0);
    EXPECT_EQ(median_interval({NAN, 2, INFINITY}).samples, 1);
    EXPECT_GE(median_interval(std::vector<double>(5000, 1.0)).confidence, 0.95);
}

/// Share of `trials` in which the interval of n draws holds the true median.
template <class Draw>
double coverage(int n, double truth, Draw draw) {
    constexpr int trials = 4000;
    int held = 0;
    for (int i = 0; i < trials; ++i) {
        std::vector<double> values;
        for (int j = 0; j < n; ++j) values.push_back(draw());
        held += median_interval(values).holds(truth);
    }
    return double(held) / trials;
}

TEST(MedianInterval, CoversTheTrueMedianAsOftenAsItSaysWhateverTheDistribution) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(1.37, 0.05);
    std::lognormal_distribution<double> skewed(0, 1);  // median 1: rounds that something disturbed
    for (const int n : {6, 9, 15, 30}) {
        // 4000 trials of a 95 % interval scatter by 0.35 %.
        EXPECT_GE(coverage(n, 1.37, [&] { return normal(random); }), 0.94) << n;
        EXPECT_GE(coverage(n, 1.0, [&] { return skewed(random); }), 0.94) << n;
    }
    EXPECT_LE(coverage(30, 1.0, [&] { return skewed(random); }), 0.98) << "and not by being as wide as can be";
}

TEST(RatioInterval, PairsRoundsSoThatADriftOfTheMachineCancels) {
    std::vector<double> slow, fast;
    for (int i = 0; i < 15; ++i) {
        const double drift = 1 + 0.2 * i;  // the machine grows four times slower
        fast.push_back(10 * drift);
        slow.push_back(13 * drift * (1 + 0.001 * (i % 3 - 1)));
    }
    const MedianInterval ratio = ratio_interval(slow, fast);
    EXPECT_NEAR(ratio.median, 1.3, 1e-3);
    EXPECT_LT(ratio.high - ratio.low, 0.01);
    slow[0] = -1;
    EXPECT_EQ(ratio_interval(slow, fast).samples, 14);
}

TEST(RatioInterval, SaysNoDifferenceWhereTheIntervalHoldsOne) {
    EXPECT_EQ(ratio_text(median_interval({0.98, 0.99, 1.0, 1.01, 1.02, 1.03})), "no difference seen (0.98 – 1.03)");
    EXPECT_EQ(ratio_text(median_interval({1.35, 1.36, 1.37, 1.37, 1.38, 1.40})), "1.37× (1.35 – 1.40)");
    EXPECT_EQ(ratio_text(median_interval({1.35, 1.36, 1.37})), "1.36× (too few rounds)");
    EXPECT_EQ(ratio_text({}), "–");
    EXPECT_EQ(verdict_of(median_interval({0.98, 0.99, 1.0, 1.01, 1.02, 1.03})), RatioVerdict::no_difference);
    EXPECT_EQ(verdict_of(median_interval({1.35, 1.36, 1.37, 1.37, 1.38, 1.40})), RatioVerdict::above);
    EXPECT_EQ(verdict_of(median_interval({0.35, 0.36, 0.37, 0.37, 0.38, 0.40})), RatioVerdict::below);
    EXPECT_EQ(verdict_of(median_interval({1.35, 1.36, 1.37})), RatioVerdict::too_few);
    EXPECT_EQ(verdict_of({}), RatioVerdict::none);
    const auto marked = [](const char* part, double value) { return fmt::format("[{} {}]", part, value); };
    EXPECT_EQ(ratio_text(median_interval({2, 2, 2, 2, 2, 3}), marked), "[median 2]× ([low 2] – [high 3])");
    EXPECT_EQ(interval_text(exactly(4.96)), "4.96");
    EXPECT_EQ(interval_text(median_interval({1, 1, 1, 2, 2, 2})), "1.50 (1.00 – 2.00)");
}

TEST(MeasuredOn, TellsEverythingThatARepetitionNeeds) {
    MeasuredOn on;
    on.renderer = "llvmpipe";
    on.software_gl = true;
    on.commit = "abc";
    const std::vector<std::string> lines = on.lines();
    for (const char* line : {"renderer: llvmpipe (software, not a GPU)", "commit: abc", "seed: 1", "load: unknown"})
        EXPECT_NE(std::ranges::find(lines, line), lines.end()) << line;
}

}  // namespace
}  // namespace kd

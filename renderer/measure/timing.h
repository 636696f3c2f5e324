// Honest time: warm-up apart, repetitions in turn, median and quartiles, passes and clocks told apart.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "renderer/trace/frame.h"

namespace kd {

/// One run of something, in ms. A negative time means: not measured.
struct TimeSample {
    double ms = -1;       // by the clock of what ran
    double wall_ms = -1;  // the same run by the steady clock, where `ms` is from another clock
    std::array<double, pass_count> pass_ms = for_each_pass(-1.0);  // of ms
};

struct TimeSummary {
    double median_ms = 0, p25_ms = 0, p75_ms = 0;
    int samples = 0;
};

/// All zero where there are no samples.
[[nodiscard]] TimeSummary summarise(std::vector<double> samples_ms);

/// Over the rounds in which `field` was measured.
template <class Rounds, class Field>
[[nodiscard]] TimeSummary summarise(const Rounds& rounds, const Field& field) {
    std::vector<double> samples;
    for (const auto& round : rounds)
        if (const double ms = field(round); ms >= 0) samples.push_back(ms);
    return summarise(std::move(samples));
}

/// One thing to time. `run` does it once.
struct Contestant {
    std::string name;
    std::function<TimeSample()> run;
};

/// A contestant's rounds, oldest first. Round i of one met the same machine as round i of the others.
struct TimedRounds {
    std::string name;
    std::vector<TimeSample> rounds;

    [[nodiscard]] TimeSummary total() const;
    [[nodiscard]] TimeSummary pass(std::size_t index) const;
    [[nodiscard]] std::vector<double> ms() const;
    /// Wall clock over own clock less 1, as the median of the rounds in which both ran: how far the clocks disagree. 0
    /// where there is one clock.
    [[nodiscard]] double clock_discrepancy() const;
};

/// "; the steady clock says +0.3 %" of a clock discrepancy; nothing for 0.
[[nodiscard]] std::string clock_check_text(double discrepancy);

/// Of a clock that never goes back.
[[nodiscard]] double steady_seconds();

/// How often. With a budget the rounds end after `budget_s` seconds, but not before `least_rounds`.
struct TimingPlan {
    int warmup = 3, rounds = 15;
    double budget_s = 0;  // 0: no limit
    int least_rounds = 6;
    /// Asked when these are done and after every `further_rounds` more: rounds go on while what they shall decide is
    /// open. Each look is another chance to close it by luck, so there is none after every single round.
    std::function<bool()> is_open = {};
    int further_rounds = 6;
    /// By `clock`. But for `least_rounds` none begins that would end later, were it as long as the one before.
    double ends_at_s = std::numeric_limits<double>::infinity();
    std::function<double()> clock = steady_seconds;
};

/// As many rounds as begin within `seconds`, up to 31, but at least the six that a 95 % interval of a median takes.
[[nodiscard]] TimingPlan rounds_within(double seconds, int warmup = 1);

/// One round of `count` contestants: `run` each by its place, in one order and the reverse of it by turns, so that a
/// machine that grows slower favours nobody. Ends where one gives up and returns false; true where none did.
bool take_turns(std::size_t count, int round, const std::function<bool(std::size_t)>& run);

/// Told after each round of all contestants: how many rounds are done, and all that was measured.
using RoundDone = std::function<void(int rounds, std::span<const TimedRounds> so_far)>;

/// Runs every contestant `warmup` times, then rounds of all of them by take_turns().
[[nodiscard]] std::vector<TimedRounds> time_in_turn(const std::vector<Contestant>& contestants, const TimingPlan& plan,
                                                    const RoundDone& round_done = {});

/// Wall clock of one call, in ms.
[[nodiscard]] double wall_ms(const std::function<void()>& work);

}  // namespace kd

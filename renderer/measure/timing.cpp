#include "renderer/measure/timing.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <utility>

#include "renderer/geometry/order_statistics.h"

namespace kd {

TimeSummary summarise(std::vector<double> samples_ms) {
    TimeSummary summary;
    if (samples_ms.empty()) return summary;
    std::ranges::sort(samples_ms);
    summary.samples = int(samples_ms.size());
    summary.median_ms = quantile(samples_ms, 0.5);
    summary.p25_ms = quantile(samples_ms, 0.25);
    summary.p75_ms = quantile(samples_ms, 0.75);
    return summary;
}

TimeSummary TimedRounds::total() const {
    return summarise(rounds, [](const TimeSample& s) { return s.ms; });
}

TimeSummary TimedRounds::pass(std::size_t index) const {
    return summarise(rounds, [index](const TimeSample& s) { return s.pass_ms[index]; });
}

std::vector<double> TimedRounds::ms() const {
    std::vector<double> all;
    for (const TimeSample& sample : rounds) all.push_back(sample.ms);
    return all;
}

double TimedRounds::clock_discrepancy() const {
    std::vector<double> ratios;
    for (const TimeSample& s : rounds)
        if (s.ms > 0 && s.wall_ms > 0) ratios.push_back(s.wall_ms / s.ms);
    return ratios.empty() ? 0 : summarise(std::move(ratios)).median_ms - 1;
}

TimingPlan rounds_within(double seconds, int warmup) {
    constexpr double at_once = 1e-9;  // 0 would be no limit
    return {.warmup = warmup, .rounds = 31, .budget_s = std::max(seconds, at_once), .least_rounds = 6};
}

std::string clock_check_text(double discrepancy) {
    return discrepancy == 0 ? "" : fmt::format("; the steady clock says {:+.1f} %", 100 * discrepancy);
}

bool take_turns(std::size_t count, int round, const std::function<bool(std::size_t)>& run) {
    for (std::size_t turn = 0; turn < count; ++turn)
        if (!run(round % 2 == 0 ? turn : count - 1 - turn)) return false;
    return true;
}

namespace {

/// Says before each round whether it is to be.
class Pace {
  public:
    explicit Pace(const TimingPlan& plan) : plan_(plan), begin_s_(plan.clock()), now_s_(begin_s_) {}

    bool goes_on(int done) {
        const double before_s = std::exchange(now_s_, plan_.clock());
        if (planned_ < 0 && !is_planned(done)) planned_ = done;
        if (planned_ >= 0 && !goes_further(done - planned_)) return false;
        return done < plan_.least_rounds || now_s_ + (now_s_ - before_s) <= plan_.ends_at_s;
    }

  private:
    [[nodiscard]] bool is_planned(int done) const {
        if (done >= plan_.rounds) return false;
        return plan_.budget_s <= 0 || done < plan_.least_rounds || now_s_ - begin_s_ < plan_.budget_s;
    }
    [[nodiscard]] bool goes_further(int more) const {
        return plan_.is_open && (more % plan_.further_rounds != 0 || plan_.is_open());
    }

    const TimingPlan& plan_;
    double begin_s_, now_s_;
    int planned_ = -1;  // rounds that the plan came to; negative while it asks for more
};

}  // namespace

std::vector<TimedRounds> time_in_turn(const std::vector<Contestant>& contestants, const TimingPlan& plan,
                                      const RoundDone& round_done) {
    std::vector<TimedRounds> timed;
    for (const Contestant& contestant : contestants) {
        for (int i = 0; i < plan.warmup; ++i) (void)contestant.run();
        timed.push_back({contestant.name, {}});
    }
    Pace pace(plan);
    for (int round = 0; pace.goes_on(round); ++round) {
        take_turns(contestants.size(), round, [&](std::size_t i) {
            timed[i].rounds.push_back(contestants[i].run());
            return true;
        });
        if (round_done) round_done(round + 1, timed);
    }
    return timed;
}

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double wall_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace kd

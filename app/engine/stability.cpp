#include "app/engine/stability.h"

#include <utility>

namespace kd {

void StabilityBench::start(const std::string& id, bool sweeping, BackgroundRun::Job job) {
    state_.active = true;
    state_.sweeping = sweeping;
    state_.id = id;
    state_.fraction = 0;
    state_.what.clear();
    state_.error.clear();
    run_.start(sweeping ? "the sweep" : "the case", std::move(job), [this](const std::string& error) {
        state_.active = false;
        state_.error = error;
    });
}

void StabilityBench::run_case(const StabilityConfig& config) {
    const std::string id = config.cases.front();
    state_.verdicts.erase(id);
    start(id, false, [this, config, id](const std::stop_token& stop, const BackgroundRun::Post& post) {
        const auto progress = [&](float fraction, const std::string& what, const StabilityReport& so_far) {
            const auto report = std::make_shared<const StabilityReport>(so_far);
            post([this, fraction, what, id, report] {
                state_.fraction = fraction;
                state_.what = what;
                if (!report->rows.empty()) state_.verdicts[id] = report;
            });
        };
        const auto report = std::make_shared<const StabilityReport>(kd::run_stability(config, progress, stop));
        post([this, id, report] { state_.verdicts[id] = report; });
    });
}

void StabilityBench::run_sweep(const SweepConfig& config) {
    state_.sweeps.erase(config.id);
    start(config.id, true, [this, config](const std::stop_token& stop, const BackgroundRun::Post& post) {
        const auto progress = [&](float fraction, const std::string& what, const SweepReport& so_far) {
            const auto report = std::make_shared<const SweepReport>(so_far);
            post([this, fraction, what, report] {
                state_.fraction = fraction;
                state_.what = what;
                state_.sweeps[report->id] = report;
            });
        };
        const auto report = std::make_shared<const SweepReport>(kd::run_sweep(config, progress, stop));
        post([this, report] { state_.sweeps[report->id] = report; });
    });
}

void StabilityBench::cancel() {
    if (!state_.active) return;
    run_.cancel();
    state_.active = false;
}

}  // namespace kd

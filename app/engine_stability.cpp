#include "app/engine_stability.h"

#include <utility>

namespace kd {

std::uint64_t StabilityBench::begin(const std::string& id, bool sweeping) {
    state_.active = true;
    state_.sweeping = sweeping;
    state_.id = id;
    state_.fraction = 0;
    state_.what = "starting";
    state_.error.clear();
    return ++ticket_;
}

void StabilityBench::post(std::uint64_t ticket, std::function<void()> change) {
    mailbox_.post([this, ticket, change = std::move(change)] {
        if (ticket == ticket_) change();
    });
}

void StabilityBench::submit(std::uint64_t ticket, std::function<void(std::stop_token)> job) {
    worker_.submit([this, ticket, job = std::move(job)](const std::stop_token& stop) {
        std::string error;
        try {
            job(stop);
        } catch (const std::exception& e) {
            error = e.what();
        }
        post(ticket, [this, error] {
            state_.active = false;
            state_.error = error;
        });
    });
}

void StabilityBench::run_case(const StabilityConfig& config) {
    const std::string id = config.cases.front();
    const std::uint64_t ticket = begin(id, false);
    submit(ticket, [this, config, id, ticket](const std::stop_token& stop) {
        const auto progress = [&](float, const std::string& what) {
            post(ticket, [this, what] { state_.what = what; });
        };
        const auto report = std::make_shared<const StabilityReport>(kd::run_stability(config, progress, stop));
        post(ticket, [this, id, report] {
            if (report->complete) state_.verdicts[id] = report;
        });
    });
}

void StabilityBench::run_sweep(const SweepConfig& config) {
    const std::uint64_t ticket = begin(config.id, true);
    state_.sweeps.erase(config.id);
    submit(ticket, [this, config, ticket](const std::stop_token& stop) {
        const auto progress = [&](float fraction, const std::string& what, const SweepReport& so_far) {
            const auto report = std::make_shared<const SweepReport>(so_far);
            post(ticket, [this, fraction, what, report] {
                state_.fraction = fraction;
                state_.what = what;
                state_.sweeps[report->id] = report;
            });
        };
        const auto report = std::make_shared<const SweepReport>(kd::run_sweep(config, progress, stop));
        post(ticket, [this, report] { state_.sweeps[report->id] = report; });
    });
}

void StabilityBench::cancel() {
    if (!state_.active) return;
    worker_.cancel();
    ++ticket_;
    state_.active = false;
}

}  // namespace kd

#include "app/engine/paper.h"

namespace kd {

namespace {

std::shared_ptr<const PaperReport> report_of(const PaperResults& results) {
    auto report = std::make_shared<PaperReport>();
    report->results = results;
    report->figures = paper_figures(results);
    report->claims = judge_claims(results);
    return report;
}

}  // namespace

void PaperBench::start(const PaperConfig& config) {
    state_ = {};
    state_.active = true;
    state_.what = "starting";
    const auto job = [this, config](const std::stop_token& stop, const BackgroundRun::Post& post) {
        const auto progress = [&](float fraction, const std::string& what, const PaperResults& so_far) {
            post([this, fraction, what, report = report_of(so_far)] {
                state_.fraction = fraction;
                state_.what = what;
                state_.report = report;
            });
        };
        const std::shared_ptr<const PaperReport> report = report_of(run_paper(config, progress, stop));
        post([this, report] { state_.report = report; });
    };
    run_.start("the experiments", job, [this](const std::string& error) {
        state_.active = false;
        state_.error = error;
    });
}

void PaperBench::cancel() {
    if (!state_.active) return;
    run_.cancel();
    state_.active = false;
}

}  // namespace kd

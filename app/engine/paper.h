// The paper's experiments behind the window: the same run as `kdscope paper`, its figures as they grow.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/engine/background.h"
#include "app/paper/paper_charts.h"
#include "app/paper/paper_run.h"
#include "renderer/measure/paper/paper_claims.h"

namespace kd {

/// What was measured so far, as figures and verdicts.
struct PaperReport {
    PaperResults results;
    std::vector<PaperFigure> figures;
    std::vector<PaperClaim> claims;
};

struct PaperState {
    bool active = false;
    float fraction = 0;                         // 0..1
    std::string what;                           // is being done
    std::string error;                          // why the last run came to nothing
    std::shared_ptr<const PaperReport> report;  // newest, also while it grows; null before the first
};

/// All member functions are called on the thread that owns `state`.
class PaperBench {
  public:
    /// Results go through `mailbox` into `state`; both must outlive this.
    PaperBench(Mailbox& mailbox, PaperState& state) : state_(state), run_(mailbox) {}

    void start(const PaperConfig& config);
    /// What was found so far stays.
    void cancel();

  private:
    PaperState& state_;
    BackgroundRun run_;
};

}  // namespace kd

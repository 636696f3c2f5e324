// The stability suite behind the window: one case, or its sweep, in the background.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/engine/background.h"
#include "renderer/measure/stability/stability.h"
#include "renderer/measure/stability/sweep_run.h"

namespace kd {

/// What runs, and what was found since the window was opened, by the case's id.
struct StabilityState {
    bool active = false, sweeping = false;
    std::string id;      // of what runs
    float fraction = 0;  // 0..1
    std::string what;    // empty until it begins: what was cancelled before it may take a moment to end
    std::string error;   // why the last run came to nothing
    // Also while they grow; what was cancelled keeps what it had.
    std::map<std::string, std::shared_ptr<const StabilityReport>> verdicts;
    std::map<std::string, std::shared_ptr<const SweepReport>> sweeps;
};

/// Runs the newest wish on a thread of its own. All member functions are called on the thread that owns `state`.
class StabilityBench {
  public:
    /// Results go through `mailbox` into `state`; both must outlive this.
    StabilityBench(Mailbox& mailbox, StabilityState& state) : state_(state), run_(mailbox) {}

    void run_case(const StabilityConfig& config);
    void run_sweep(const SweepConfig& config);
    /// What was found so far stays.
    void cancel();

  private:
    void start(const std::string& id, bool sweeping, BackgroundRun::Job job);

    StabilityState& state_;
    BackgroundRun run_;
};

}  // namespace kd

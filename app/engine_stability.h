// The stability suite behind the window: one case, or its sweep, in the background.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/engine_mailbox.h"
#include "app/engine_worker.h"
#include "renderer/measure/stability/stability.h"
#include "renderer/measure/stability/sweep_run.h"

namespace kd {

/// What runs, and what was found since the window was opened, by the case's id.
struct StabilityState {
    bool active = false, sweeping = false;
    std::string id;      // of what runs
    float fraction = 0;  // 0..1 of a sweep; a case does not tell
    std::string what;
    std::string error;  // why the last run came to nothing
    std::map<std::string, std::shared_ptr<const StabilityReport>> verdicts;
    std::map<std::string, std::shared_ptr<const SweepReport>> sweeps;  // also while they grow
};

/// Runs the newest wish on a thread of its own. All member functions are called on the thread that owns `state`.
class StabilityBench {
  public:
    /// Results go through `mailbox` into `state`; both must outlive this.
    StabilityBench(Mailbox& mailbox, StabilityState& state) : mailbox_(mailbox), state_(state) {}

    void run_case(const StabilityConfig& config);
    void run_sweep(const SweepConfig& config);
    /// What was found so far stays.
    void cancel();

  private:
    std::uint64_t begin(const std::string& id, bool sweeping);
    /// Runs `job` in the background and tells what it threw.
    void submit(std::uint64_t ticket, std::function<void(std::stop_token)> job);
    /// On the owner's thread, unless something newer has begun.
    void post(std::uint64_t ticket, std::function<void()> change);

    Mailbox& mailbox_;
    StabilityState& state_;
    std::uint64_t ticket_ = 0;
    Worker worker_{Worker::Priority::low};  // last: joined before what its jobs use goes
};

}  // namespace kd

// Poses of a moving scene with their trees, made one at a time behind the window.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "app/engine/background.h"
#include "app/engine/world.h"
#include "renderer/measure/motion/tree_maker.h"

namespace kd {

struct PoseTask {
    std::shared_ptr<const LoadedScene> of;  // which moves, in any pose
    double time = 0;                        // Session::time
    BuildConfig build;
    bool refit = false;
    int threads = 0;               // that build, 0 = all
    std::uint64_t generation = 0;  // EngineState::generation that asked for it
};

/// A pose, or why there is none.
struct Posed {
    PoseTask task;
    std::shared_ptr<const World> world;
    int made = 0, refused = 0;  // trees so far of this scene and configuration, and those that refitting refused
    std::string why_refused;
    double first_cost = 0;  // as MotionState
    std::string error;
};

/// All member functions are called on the thread that polls the mailbox.
class Posing {
  public:
    explicit Posing(Mailbox& mailbox) : run_(mailbox) {}

    /// `done` is called on the owner's thread, unless it is cancelled before.
    void start(const PoseTask& task, std::function<void(const Posed&)> done);
    void cancel();
    [[nodiscard]] bool busy() const { return busy_; }

  private:
    void make(Posed& posed, const std::stop_token& stop);

    /// What one scene's trees are made by under one configuration.
    struct Makers {
        Makers() = default;
        explicit Makers(const PoseTask& task);
        [[nodiscard]] bool serve(const PoseTask& task) const;

        std::shared_ptr<const MovingScene> of;
        BuildConfig build;
        bool refit = false;
        int threads = 0;
        std::unique_ptr<TreeMaker> maker;
        double first_cost = 0;
        int made = 0;
    };

    bool busy_ = false;
    Makers makers_;      // the running job's alone
    BackgroundRun run_;  // last: joined before what its jobs use goes
};

}  // namespace kd

// The judging thread's work, beside a frame: its hits against double precision, coarsely first, or its walks in groups.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

#include "app/engine/state.h"
#include "renderer/measure/oracle.h"

namespace kd {

/// Used by one thread alone.
class Judging {
  public:
    /// Judges the hits of `rays`: those of a sketch's pixels first where the frame is a whole picture, which is soon
    /// done and never stopped, so that something is seen while the camera moves; then all, unless stopped. Each is
    /// handed to `publish`.
    void judge(const TracedFrame& traced, Pass rays, int threads, const std::stop_token& stop,
               const std::function<void(std::shared_ptr<const JudgedLayer>)>& publish,
               const std::function<void(float)>& progress);

    /// The groups of the frame's rays as `map` asks for them; nothing where stopped.
    static std::shared_ptr<const LockstepLayer> walk(const TracedFrame& traced, const MapConfig& map, int threads,
                                                     const std::stop_token& stop,
                                                     const std::function<void(float)>& progress);

  private:
    std::shared_ptr<const LoadedScene> scene_;  // that oracle_ answers for
    std::unique_ptr<DoubleOracle> oracle_;
};

}  // namespace kd

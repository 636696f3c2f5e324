// The rounds of frames timed lately, each frame's apart: who goes on to another setting and back finds them again.
#pragma once

#include <deque>

#include "app/engine/duel.h"
#include "app/session.h"

namespace kd {

class DuelBook {
  public:
    explicit DuelBook(DuelState& shown) : shown_(shown) {}

    /// `session` is what the window shows now; its camera is the one in use. Shows its rounds, or, until there are
    /// some, those shown before as outdated. Which machine the picture is from, and what is painted over it, does not
    /// matter: both trace the same frame.
    void turn_to(Session session);
    /// A round of the frame turned to; the first one since then warms up and is not counted.
    void add(const DuelReply& reply, bool chosen);
    /// Rounds of every frame, because none of them can come back.
    void forget();

  private:
    struct Page {
        Session of;
        DuelState rounds;
    };
    [[nodiscard]] Page* find(const Session& of);
    void show(const DuelState& rounds);

    DuelState& shown_;
    Session of_;
    bool warm_ = false;
    std::deque<Page> pages_;  // newest first
};

}  // namespace kd

// The rounds of frames timed lately, each frame's apart: who goes on to another setting and back finds them again.
#pragma once

#include <deque>

#include "app/engine/duel.h"
#include "app/session.h"

namespace kd {

class DuelBook {
  public:
    explicit DuelBook(DuelState& shown) : shown_(shown) {}

    /// `session` is what the window shows now; its camera is the one in use. `scale` is of the frames timed, as it was
    /// asked for. Shows the rounds of both, or, until there are some, those shown before as outdated. Which machine the
    /// picture is from, and what is painted over it, does not matter: both trace the same frame.
    void turn_to(Session session, int scale = 0);
    /// A round of the frame turned to; the first one since then warms up and is not counted.
    void add(const DuelReply& reply);
    /// Rounds of every frame, where the same words may mean another one from now on.
    void forget();

  private:
    struct Subject {
        Session session;
        int scale = 0;
        bool operator==(const Subject&) const = default;
    };
    struct Page {
        Subject of;
        DuelState rounds;
    };
    [[nodiscard]] Page* find(const Subject& of);
    void show(const DuelState& rounds);

    DuelState& shown_;
    Subject of_;
    bool warm_ = false;
    std::deque<Page> pages_;  // newest first
};

}  // namespace kd

// Long work that a person starts and cancels behind the window: the newest run alone counts.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

#include "app/engine/mailbox.h"
#include "app/engine/worker.h"

namespace kd {

/// Has a thread of its own. All member functions are called on the thread that polls the mailbox.
class BackgroundRun {
  public:
    /// Brings a change to the owner's thread, unless something newer has begun by then.
    using Post = std::function<void(std::function<void()> change)>;
    using Job = std::function<void(std::stop_token, const Post&)>;

    /// `mailbox` must outlive this.
    explicit BackgroundRun(Mailbox& mailbox) : mailbox_(mailbox) {}

    /// Runs `job` once what runs has ended, which is asked to stop. `ended` is called on the owner's thread with what
    /// the job threw, or nothing; `what` it works on is named where memory runs out.
    void start(std::string what, Job job, std::function<void(const std::string& error)> ended);
    /// Asks what runs to stop; nothing of it arrives any more.
    void cancel();

  private:
    Mailbox& mailbox_;
    std::uint64_t ticket_ = 0;
    Worker worker_{Worker::Priority::low};  // last: joined before what its jobs use goes
};

}  // namespace kd

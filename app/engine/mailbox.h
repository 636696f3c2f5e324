// The way back from background threads: what they post runs on the thread that owns the engine.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace kd {

class Mailbox {
  public:
    /// `wake` is called after every post, from any thread: it brings the owner to deliver().
    explicit Mailbox(std::function<void()> wake = {}) : wake_(std::move(wake)) {}

    void post(std::function<void()> letter) {
        {
            const std::scoped_lock lock(mutex_);
            letters_.push_back(std::move(letter));
        }
        arrived_.notify_one();
        if (wake_) wake_();
    }

    /// Until there is a letter, or `seconds` have passed: false.
    bool wait(double seconds) {
        std::unique_lock lock(mutex_);
        return arrived_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return !letters_.empty(); });
    }

    /// Runs all letters in the order of posting; true where there was one.
    bool deliver() {
        std::vector<std::function<void()>> letters;
        {
            const std::scoped_lock lock(mutex_);
            letters.swap(letters_);
        }
        for (const auto& letter : letters) letter();
        return !letters.empty();
    }

  private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::vector<std::function<void()>> letters_;
    std::function<void()> wake_;
};

}  // namespace kd

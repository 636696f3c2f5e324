#include "app/engine/worker.h"

#include <utility>

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace kd {

namespace {

/// Of the calling thread, and so of the threads that it will make. On Linux alone is this a property of threads.
void step_back() {
#ifdef __linux__
    constexpr int steps = 5;
    (void)setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + steps);  // refused: then it does not
#endif
}

}  // namespace

Worker::Worker(Priority priority, std::function<void()> at_exit)
    : at_exit_(std::move(at_exit)), thread_([this, priority](const std::stop_token& quit) { run(quit, priority); }) {}

Worker::~Worker() {
    cancel();
    thread_.request_stop();
    thread_.join();
}

void Worker::submit(Job job) {
    const std::scoped_lock lock(mutex_);
    running_stop_.request_stop();
    next_ = std::move(job);
    changed_.notify_all();
}

void Worker::cancel() {
    const std::scoped_lock lock(mutex_);
    running_stop_.request_stop();
    next_ = nullptr;
}

bool Worker::busy() const {
    const std::scoped_lock lock(mutex_);
    return running_ || next_ != nullptr;
}

void Worker::run(const std::stop_token& quit, Priority priority) {
    if (priority == Priority::low) step_back();
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, quit, [this] { return next_ != nullptr; })) {
        const Job job = std::exchange(next_, nullptr);
        running_stop_ = std::stop_source();
        running_ = true;
        const std::stop_token stop = running_stop_.get_token();
        lock.unlock();
        job(stop);
        lock.lock();
        running_ = false;
    }
    lock.unlock();
    if (at_exit_) at_exit_();
}

}  // namespace kd

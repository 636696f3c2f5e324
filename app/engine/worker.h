// One background thread that runs the newest job: an older one is asked to stop, one not yet begun is dropped.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace kd {

class Worker {
  public:
    using Job = std::function<void(std::stop_token)>;

    /// Long work steps back for whoever waits in front of the window. Threads that the jobs start do the same.
    enum class Priority { normal, low };

    /// `at_exit` runs on the worker's thread after its last job: for what must die on the thread that made it.
    explicit Worker(Priority priority = Priority::normal, std::function<void()> at_exit = {});
    /// Stops the running job and waits for it.
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Runs `job` as soon as the running one has ended, which is asked to stop. Jobs must not throw.
    void submit(Job job);
    /// Asks the running job to stop and drops the one that waits.
    void cancel();
    /// True from submit() until the job submitted last has ended.
    [[nodiscard]] bool busy() const;

  private:
    void run(const std::stop_token& quit, Priority priority);

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    Job next_;
    std::stop_source running_stop_;
    bool running_ = false;
    std::function<void()> at_exit_;
    std::jthread thread_;
};

}  // namespace kd

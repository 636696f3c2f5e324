// Files are written in the background, one after another: a table of a large picture takes seconds.
#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "app/engine/worker.h"

namespace kd {

class Exporter {
  public:
    /// Writes a file into a folder that is there, and returns its path; tells the fraction done where it knows. Throws
    /// where it cannot.
    using Write = std::function<std::filesystem::path(const std::filesystem::path& folder,
                                                      const std::function<void(float)>& progress)>;

    struct Done {
        std::filesystem::path path;         // written; empty where that failed
        std::filesystem::path made_folder;  // that was not there before; empty where it was
        std::string error;
    };

    struct Progress {
        bool active = false;
        std::string what;  // "CSV"
        float fraction = 0;
    };

    /// `wake` is called on any thread when there is something to fetch.
    explicit Exporter(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Writes after all that was asked for before. The folder is made where it is missing, with those above it.
    void add(std::string what, std::filesystem::path folder, Write write);
    /// What has ended since the last call.
    [[nodiscard]] std::vector<Done> fetch();
    [[nodiscard]] Progress progress() const;

  private:
    struct Order {
        std::string what;
        std::filesystem::path folder;
        Write write;
    };

    void work();
    [[nodiscard]] Done carry_out(const Order& order);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::deque<Order> orders_;  // the first one is being carried out
    std::vector<Done> done_;
    std::atomic<float> fraction_ = 0;
    Worker worker_{Worker::Priority::low};  // last: joined before what its job uses goes
};

}  // namespace kd

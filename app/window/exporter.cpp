#include "app/window/exporter.h"

#include <fmt/format.h>
#include <utility>

#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

/// True where the folder was made. InputError where there is none and none can be made.
bool make_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) return false;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder))
        throw InputError(fmt::format("export: cannot make the folder '{}': {}; name another",
                                     printable(folder.string(), 1000), error.message()));
    return true;
}

}  // namespace

void Exporter::add(std::string what, fs::path folder, Write write) {
    {
        const std::scoped_lock lock(mutex_);
        orders_.push_back({std::move(what), std::move(folder), std::move(write)});
    }
    // Every job does all orders that it finds, so it does not matter which of the jobs submitted are dropped.
    worker_.submit([this](const std::stop_token&) { work(); });
}

void Exporter::work() {
    while (true) {
        Order order;
        {
            const std::scoped_lock lock(mutex_);
            if (orders_.empty()) return;
            order = orders_.front();
        }
        fraction_ = 0;
        Done done = carry_out(order);
        {
            const std::scoped_lock lock(mutex_);
            done_.push_back(std::move(done));
            orders_.pop_front();
        }
        wake_();
    }
}

Exporter::Done Exporter::carry_out(const Order& order) {
    Done done;
    try {
        if (make_folder(order.folder)) done.made_folder = order.folder;
        done.path = order.write(order.folder, [this](float fraction) { fraction_ = fraction; });
    } catch (const std::exception& error) {
        done.error = error.what();
    }
    return done;
}

std::vector<Exporter::Done> Exporter::fetch() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(done_, {});
}

Exporter::Progress Exporter::progress() const {
    const std::scoped_lock lock(mutex_);
    if (orders_.empty()) return {};
    return {true, orders_.front().what, fraction_};
}

}  // namespace kd

// Frames that are used again: a frame of a full-screen window takes hundreds of megabytes, and clearing it takes longer
// than tracing it coarsely.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include "renderer/trace/frame.h"

namespace kd {

/// Gives out frames whose pixels hold whatever was traced into them before. A frame comes back when its last owner lets
/// go, on any thread.
class FramePool {
  public:
    [[nodiscard]] std::shared_ptr<Frame> take(int width, int height) {
        std::unique_ptr<Frame> frame;
        {
            const std::scoped_lock lock(store_->mutex);
            auto& spare = store_->spare;
            const auto fits = [&](const auto& f) { return f->width == width && f->height == height; };
            if (const auto found = std::ranges::find_if(spare, fits); found != spare.end()) {
                frame = std::move(*found);
                spare.erase(found);
            }
        }
        if (!frame) frame = std::make_unique<Frame>(width, height);
        return {frame.release(), [store = store_](Frame* f) { store->give_back(std::unique_ptr<Frame>(f)); }};
    }

  private:
    struct Store {
        static constexpr std::size_t most_spare = 3;
        static constexpr int least_pixels = 1 << 16;  // smaller ones are made as fast as found, and crowd out the large
        std::mutex mutex;
        std::vector<std::unique_ptr<Frame>> spare;

        void give_back(std::unique_ptr<Frame> frame) {
            if (frame->width * frame->height < least_pixels) return;
            const std::scoped_lock lock(mutex);
            spare.push_back(std::move(frame));
            if (spare.size() > most_spare) spare.erase(spare.begin());
        }
    };
    std::shared_ptr<Store> store_ = std::make_shared<Store>();
};

}  // namespace kd

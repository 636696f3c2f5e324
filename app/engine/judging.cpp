#include "app/engine/judging.h"

#include <optional>
#include <utility>

#include "app/engine/paint.h"
#include "renderer/measure/frame_judge.h"
#include "renderer/measure/frame_walks.h"

namespace kd {

void Judging::judge(const TracedFrame& traced, Pass rays, int threads, const std::stop_token& stop,
                    const std::function<void(std::shared_ptr<const JudgedLayer>)>& publish,
                    const std::function<void(float)>& progress) {
    if (scene_ != traced.world->loaded) {
        scene_ = traced.world->loaded;
        oracle_ = std::make_unique<DoubleOracle>(scene_->flat);
    }
    const Frame& frame = *traced.frame;
    const auto publish_every = [&](int step, const std::stop_token& until, const std::function<void(float)>& told) {
        std::optional<JudgedLayer> judged =
            judge_frame(*oracle_, {frame, traced.lens, rays, step, threads}, until, told);
        if (judged) publish(std::make_shared<const JudgedLayer>(*std::move(judged)));
    };
    if (traced.scale == 1) publish_every(sketch_step, {}, {});
    publish_every(1, stop, progress);
}

std::shared_ptr<const LockstepLayer> Judging::walk(const TracedFrame& traced, const MapConfig& map, int threads,
                                                   const std::stop_token& stop,
                                                   const std::function<void(float)>& progress) {
    std::optional<LockstepLayer> walks = walk_frame(walk_request(traced, map.rays, threads), map.schedule,
                                                    map.tile_width, map.tile_height, stop, progress);
    return walks ? std::make_shared<const LockstepLayer>(*std::move(walks)) : nullptr;
}

}  // namespace kd

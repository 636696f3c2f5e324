// Every step of every ray of a frame, walked once more on the CPU, block by block.
#pragma once

#include <functional>
#include <span>
#include <stop_token>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/trace_config.h"
#include "renderer/trace/walk.h"

namespace kd {

/// What is walked. Blocks begin at the upper left corner of the picture; those at its right and lower edge are cut.
struct WalkRequest {
    const FlatScene& scene;
    const KdTree& tree;
    TraceConfig config;
    PinholeCamera camera;
    int width = 0, height = 0;  // of the picture
    Pass rays = Pass::rt_prim;
    int block_width = 32, block_height = 32;
    bool with_stack = false;  // fills PixelWalks::stack_interior and same_hit
    bool from_root = false;   // fills PixelWalks::root_steps
    int threads = 0;          // 0 = all
};

struct BlockWalks {
    Tile area;                       // cut to the picture
    std::vector<PixelWalks> pixels;  // row by row

    [[nodiscard]] const PixelWalks& at(int x, int y) const {
        return pixels[std::size_t(y - area.y0) * std::size_t(area.x1 - area.x0) + std::size_t(x - area.x0)];
    }
};

/// Hands every block to `consume`, which is called from several threads, for different blocks, and lets go of it after:
/// only as many blocks as threads are held. False where stopped before the end. `progress` gets the fraction done, from
/// several threads too.
bool record_walks(const WalkRequest& request, const std::function<void(const BlockWalks&)>& consume,
                  std::stop_token stop = {}, const std::function<void(float)>& progress = {});

/// The walks of one pixel; the request's blocks do not matter.
[[nodiscard]] PixelWalks record_pixel(const WalkRequest& request, int x, int y);

}  // namespace kd

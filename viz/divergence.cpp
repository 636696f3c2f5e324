#include "viz/divergence.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/trace/counters.h"

namespace kd {
namespace {

struct TileWork {
    Tile area;  // cut to the image
    std::uint64_t sum = 0, max = 0;
};

/// Calls visit(TileWork) for every tile, row by row.
template <class Visit>
void for_each_tile(const RayLayer& layer, int tile_width, int tile_height, Visit visit) {
    const Image<RayCounters>& counters = layer.counters;
    for (int y = 0; y < counters.height; y += tile_height) {
        for (int x = 0; x < counters.width; x += tile_width) {
            TileWork work{{x, y, std::min(x + tile_width, counters.width), std::min(y + tile_height, counters.height)}};
            for (int row = work.area.y0; row < work.area.y1; ++row) {
                for (int column = work.area.x0; column < work.area.x1; ++column) {
                    const std::uint64_t n = lane_steps(counters.at(column, row));
                    work.sum += n;
                    work.max = std::max(work.max, n);
                }
            }
            visit(work);
        }
    }
}

template <class Value>
void fill_tile(Image<float>& image, const Tile& area, Value value) {
    for (int y = area.y0; y < area.y1; ++y) {
        for (int x = area.x0; x < area.x1; ++x) image.at(x, y) = value(x, y);
    }
}

}  // namespace

Image<float> step_efficiency(const RayLayer& layer, int tile_width, int tile_height) {
    Image<float> result(layer.counters.width, layer.counters.height, std::numeric_limits<float>::quiet_NaN());
    for_each_tile(layer, tile_width, tile_height, [&](const TileWork& work) {
        if (work.max == 0) return;
        const double efficiency = GroupTally{work.sum, work.max, 0}.efficiency(tile_width * tile_height);
        fill_tile(result, work.area, [&](int, int) { return float(efficiency); });
    });
    return result;
}

Image<float> idle_steps(const RayLayer& layer, int tile_width, int tile_height) {
    Image<float> result(layer.counters.width, layer.counters.height);
    for_each_tile(layer, tile_width, tile_height, [&](const TileWork& work) {
        fill_tile(result, work.area,
                  [&](int x, int y) { return float(work.max - lane_steps(layer.counters.at(x, y))); });
    });
    return result;
}

EfficiencySummary summarise_divergence(const RayLayer& layer, int tile_width, int tile_height) {
    std::vector<GroupTally> groups;
    for_each_tile(layer, tile_width, tile_height, [&](const TileWork& work) {
        groups.push_back({work.sum, work.max, 0});
    });
    return summarise_efficiency(groups, tile_width * tile_height);
}

}  // namespace kd

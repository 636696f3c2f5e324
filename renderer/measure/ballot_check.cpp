#include "renderer/measure/ballot_check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/frame_judge.h"
#include "renderer/measure/path_rays.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

using Phases = std::vector<std::uint32_t>;

/// Draws no step out of any machine.
constexpr Ray no_ray{{0, 0, 0}, {0, 0, 0}, 0, 0, -1};

/// One round of rays: at most one per pixel, and what the CPU finds of each.
struct Round {
    std::vector<Ray> rays;
    std::vector<Phases> phases;
    std::vector<std::uint8_t> there;

    [[nodiscard]] PixelPhases walks() const {
        PixelPhases walks(rays.size(), nullptr);
        for (std::size_t i = 0; i < walks.size(); ++i)
            if (there[i]) walks[i] = &phases[i];
        return walks;
    }
};

/// All rays of a pass as rounds.
class Rounds {
  public:
    Rounds(const WalkRequest& request, const std::stop_token& stop)
        : request_(request), frame_(request.width, request.height) {
        request_.config.reflection_depth = std::min(request_.config.reflection_depth, 1);
        // The shader that counts takes rays from a table, each from the root, and lights' middles.
        request_.config.entry_tile = 0;
        request_.config.eye_leaf = false;
        request_.config.sampling = {};
        const WalkRequest& r = request_;
        CpuTracer(r.scene, r.tree).trace_frame(r.config, r.camera, frame_, r.threads, stop);
        const int count = shades(r.rays) ? int(r.scene.lights.size()) : 1;
        const std::size_t pixels = frame_.colour.pixels.size();
        rounds_.assign(std::size_t(count), {std::vector<Ray>(pixels, no_ray), std::vector<Phases>(pixels),
                                            std::vector<std::uint8_t>(pixels, 0)});
        record_walks(
            r, [&](const BlockWalks& block) { add(block); }, stop);
    }

    [[nodiscard]] const std::vector<Round>& all() const { return rounds_; }

  private:
    WalkRequest request_;
    Frame frame_;
    std::vector<Round> rounds_;

    void add(const BlockWalks& block) {
        for (int y = block.area.y0; y < block.area.y1; ++y)
            for (int x = block.area.x0; x < block.area.x1; ++x)
                for (const RayWalk& ray : block.at(x, y).rays) {
                    const std::size_t i = frame_.colour.index(x, y);
                    Round& round = rounds_[std::size_t(ray.round)];
                    round.rays[i] = ray_of(x, y, ray.round);
                    round.phases[i] = ray.phases;
                    round.there[i] = 1;
                }
    }

    /// The ray that the frame's passes have traced, from what they found.
    [[nodiscard]] Ray ray_of(int x, int y, int round) const {
        const std::size_t i = frame_.colour.index(x, y);
        const Pass arriving = of_reflections(request_.rays) ? Pass::rt_refl : Pass::rt_prim;
        const Ray ray = ray_of_pixel(request_.scene, request_.camera, frame_, arriving, x, y).value_or(no_ray);
        if (!shades(request_.rays)) return ray;
        return shadow_ray(request_.scene, ray, frame_.layer(arriving).hit.pixels[i],
                          request_.scene.lights[std::size_t(round)])
            .ray;
    }
};

/// The groups as the shader tells them: by the number of one of their pixels.
using Groups = std::map<std::uint32_t, std::vector<std::size_t>>;

Groups groups_of(const BallotLayer& layer) {
    Groups groups;
    for (std::size_t i = 0; i < layer.lanes.pixels.size(); ++i) groups[layer.lanes.pixels[i].group].push_back(i);
    return groups;
}

/// Whether every tile of this shape is one group and every group one tile.
bool are_tiles(const BallotLayer& layer, int tile_width, int tile_height) {
    const int width = layer.lanes.width;
    const int columns = (width + tile_width - 1) / tile_width;
    std::map<std::uint32_t, std::size_t> tile_of;
    std::map<std::size_t, std::uint32_t> group_of;
    for (std::size_t i = 0; i < layer.lanes.pixels.size(); ++i) {
        const int x = int(i) % width, y = int(i) / width;
        const std::size_t tile = std::size_t(y / tile_height) * std::size_t(columns) + std::size_t(x / tile_width);
        const std::uint32_t group = layer.lanes.pixels[i].group;
        if (tile_of.emplace(group, tile).first->second != tile) return false;
        if (group_of.emplace(tile, group).first->second != group) return false;
    }
    return true;
}

void find_tile(const BallotLayer& layer, BallotReport& report) {
    for (int width = 1; width <= layer.group_size; width *= 2)
        if (are_tiles(layer, width, layer.group_size / width)) {
            report.tile_width = width;
            report.tile_height = layer.group_size / width;
        }
}

std::string place(const BallotLayer& layer, std::size_t pixel) {
    const auto width = std::size_t(layer.lanes.width);
    return fmt::format("{}, {}", pixel % width, pixel / width);
}

void add_group(const BallotLayer& layer, std::size_t pixel, const GroupTally& measured, const GroupTally& computed,
               BallotReport& report) {
    ++report.groups;
    report.measured += measured;
    report.computed += computed;
    if (measured == computed) return;
    ++report.differ;
    if (report.first_difference.empty())
        report.first_difference =
            fmt::format("the group of pixel {}: {} iterations ({} at interior nodes) with {} active lanes measured, {} "
                        "({}) with {} computed",
                        place(layer, pixel), measured.iterations, measured.interior_iterations, measured.steps,
                        computed.iterations, computed.interior_iterations, computed.steps);
}

void compare_rays(CpuTracer& cpu, const WalkRequest& request, const Round& round, const BallotLayer& layer,
                  BallotReport& report) {
    std::vector<Hit> hits(round.rays.size());
    std::vector<RayCounters> counters(round.rays.size());
    cpu.trace_rays(request.config, round.rays, shades(request.rays), hits, counters, request.threads);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!round.there[i]) continue;
        ++report.rays;
        if (bit_equal(layer.hit.pixels[i], hits[i]) && layer.counters.pixels[i] == counters[i]) continue;
        ++report.unlike;
        if (report.first_difference.empty())
            report.first_difference = fmt::format("the ray of pixel {} differs from the CPU's: triangle {} and {}",
                                                  place(layer, i), layer.hit.pixels[i].triangle, hits[i].triangle);
    }
}

}  // namespace

void compare_groups(const BallotLayer& layer, const PixelPhases& walks, Schedule loop, BallotReport& report,
                    bool paint) {
    if (paint) report.measured_map = report.computed_map = Image<float>(layer.lanes.width, layer.lanes.height, NAN);
    for (const auto& [group, pixels] : groups_of(layer)) {
        GroupTally measured;
        std::vector<const Phases*> phases;
        for (const std::size_t i : pixels) {
            const LaneBallots& lane = layer.lanes.pixels[i];
            measured += {std::uint64_t(lane.led_lanes[0]) + lane.led_lanes[1], std::uint64_t(lane.led[0]) + lane.led[1],
                         lane.led[0]};
            if (walks[i]) phases.push_back(walks[i]);
        }
        // Without a ray there is nothing to do; a machine that did something all the same is not passed over.
        if (phases.empty() && measured == GroupTally{}) continue;
        const GroupTally computed = run_phases(phases, loop);
        add_group(layer, pixels.front(), measured, computed, report);
        if (!paint) continue;
        for (const std::size_t i : pixels) {
            report.measured_map.pixels[i] = float(measured.efficiency(layer.group_size));
            report.computed_map.pixels[i] = float(computed.efficiency(layer.group_size));
        }
    }
}

BallotReport check_ballots(GlTracer& tracer, const WalkRequest& request, Schedule loop, std::stop_token stop) {
    BallotReport report;
    const Rounds rounds(request, stop);
    CpuTracer cpu(request.scene, request.tree);
    for (const Round& round : rounds.all()) {
        if (stop.stop_requested()) return {};
        const BallotLayer layer = tracer.measure_ballots(request.config, loop, round.rays, shades(request.rays),
                                                         request.width, request.height);
        report.group_size = layer.group_size;
        find_tile(layer, report);
        compare_groups(layer, round.walks(), loop, report, &round == &rounds.all().front());
        compare_rays(cpu, request, round, layer, report);
        if (!layer.tells_multiprocessors) continue;
        for (const LaneBallots& lane : layer.lanes.pixels) ++report.multiprocessors[lane.multiprocessor];
    }
    return report;
}

}  // namespace kd

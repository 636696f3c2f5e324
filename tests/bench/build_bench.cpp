// kdscope's builders against Embree's builds of the same triangles, in turn, in one run.
//
// usage: build_bench [SCENE] [ROUNDS] [THREADS]      default ball:100000, 15 rounds, 2 threads
//
// Exit code 1 where a ratio's whole 95 % interval lies above what is asked. Where it holds what is asked the rounds do
// not tell, and that is said.

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/suited_tree.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/peers/peers.h"
#include "tests/bench/bench_scene.h"

namespace {

using namespace kd;

/// Builds of one quality by a device of so many threads.
class EmbreeBuilds {
  public:
    EmbreeBuilds(const std::vector<Triangle>& triangles, int threads, RTCBuildQuality quality)
        : count_(triangles.size()), quality_(quality),
          device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
        for (const Triangle& triangle : triangles)
            corners_.insert(corners_.end(), triangle.corner.begin(), triangle.corner.end());
        corners_.emplace_back();  // Embree reads 16 bytes of each
        for (unsigned i = 0; i < 3 * count_; ++i) indices_.push_back(i);
    }
    EmbreeBuilds(const EmbreeBuilds&) = delete;
    ~EmbreeBuilds() { rtcReleaseDevice(device_); }

    /// From memory that is there: no copy is timed.
    void build() const {
        RTCScene scene = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene, quality_);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, corners_.data(), 0,
                                   sizeof(Vec3), 3 * count_);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices_.data(), 0,
                                   3 * sizeof(unsigned), count_);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        rtcReleaseScene(scene);
    }

  private:
    std::vector<Vec3> corners_;
    std::vector<unsigned> indices_;
    std::size_t count_;
    RTCBuildQuality quality_;
    RTCDevice device_;
};

/// What is asked: at most so many times the time of a rival, of scenes below `large` triangles and of others. The lists
/// of large ones leave the caches, where a kd-tree's references, which grow as it is built, cost more than a BVH's.
struct Demand {
    const char* builder;
    std::size_t rival;  // 0 high quality, 1 medium
    double most, most_of_large;
};
constexpr std::size_t large = 500'000;
constexpr Demand demands[] = {{"exact", 0, 3.0, 5.0}, {"binned", 1, 6.0, 6.0}};

int run(const std::string& name, int rounds, int threads) {
    const FlatScene scene = bench_scene(name);
    const EmbreeBuilds high(scene.triangles, threads, RTC_BUILD_QUALITY_HIGH);
    const EmbreeBuilds medium(scene.triangles, threads, RTC_BUILD_QUALITY_MEDIUM);
    std::vector<Contestant> contestants;
    const auto compete = [&](std::string label, auto build) {
        contestants.push_back({std::move(label), [build] { return TimeSample{wall_ms(build)}; }});
    };
    compete("embree high", [&] { high.build(); });
    compete("embree medium", [&] { medium.build(); });
    std::vector<KdTree> trees(builders().size() + 1);
    const auto compete_tree = [&](std::string label, const BuildConfig& config, KdTree& tree) {
        compete("kdscope " + label,
                [&, config] { tree = build_tree(scene.triangles, config, nullptr, {}, {}, threads); });
    };
    for (std::size_t i = 0; i < builders().size(); ++i) {
        const BuildConfig config{.builder = std::string(builders()[i].name)};
        compete_tree(config.builder, config, trees[i]);
    }
    compete_tree("exact, cpu-wide's", suited_tree(CpuMode::wide, {}), trees.back());
    const std::vector<TimedRounds> times = time_in_turn(contestants, {.warmup = 2, .rounds = rounds});

    std::printf("%s, %zu triangles, %d threads, %d rounds in turn; %s, on a processor with %s\n", name.c_str(),
                scene.triangles.size(), threads, rounds, peers_version().c_str(), cpu_target_name().c_str());
    std::printf("%-24s %9s %19s %9s %9s %10s %11s\n", "build", "ms", "[p25 - p75]", "x high", "x medium", "nodes",
                "references");
    const auto median = [&](std::size_t i) { return times[i].total().median_ms; };
    bool holds = true;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const TimeSummary t = times[i].total();
        std::printf("%-24s %9.1f [%7.1f - %7.1f] %9.2f %9.2f", times[i].name.c_str(), t.median_ms, t.p25_ms, t.p75_ms,
                    median(i) / median(0), median(i) / median(1));
        if (i >= 2) std::printf(" %10zu %11zu", trees[i - 2].nodes.size(), trees[i - 2].references.size());
        std::printf("\n");
    }
    for (const auto& [builder, rival, most_of_small, most_of_large] : demands) {
        const double most = scene.triangles.size() < large ? most_of_small : most_of_large;
        const auto found = std::ranges::find(contestants, std::string("kdscope ") + builder, &Contestant::name);
        const std::vector<double> ours = times[std::size_t(found - contestants.begin())].ms();
        const MedianInterval ratio = ratio_interval(ours, times[rival].ms());
        const char* verdict = ratio.high <= most ? "holds" : ratio.low > most ? "FAILS" : "open, more rounds tell";
        holds &= ratio.low <= most;
        std::printf("kdscope %s takes %s times as long as %s; at most %g is asked: %s\n", builder,
                    interval_text(ratio).c_str(), contestants[rival].name.c_str(), most, verdict);
    }
    return holds ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? argv[1] : "ball:100000", argc > 2 ? std::stoi(argv[2]) : 15,
                   argc > 3 ? std::stoi(argv[3]) : 2);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "build_bench: %s\n", error.what());
        return 2;
    }
}

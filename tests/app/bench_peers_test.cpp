// bench --peers: the rays, what is told of those that differ, and the rows.

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/report/peers_report.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/ray_bench.h"
#include "renderer/peers/peers.h"
#include "renderer/scene/procedural.h"
#include "tests/app/cli_run.h"
#include "viz/text.h"

namespace kd {
namespace {

using json = nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;

std::vector<BenchRays> rays_of(const FlatScene& scene, unsigned seed = 1) {
    return bench_rays(scene, build_tree(scene.triangles, {}), 24, 20, seed);
}

TEST(BenchRays, AMortonCurveKeepsSquaresTogether) {
    const FlatScene scene = flatten(*make_procedural("cornell"));
    const PinholeCamera camera = pinhole(scene.camera, 12, 8);
    const std::vector<Ray> rays = morton_rays(camera, 12, 8);
    const auto across = [&](const Ray& ray) {  // on the picture's plane
        return glm::dot(ray.direction, camera.right) / glm::dot(ray.direction, camera.forward);
    };
    ASSERT_EQ(rays.size(), 96u);
    std::set<std::array<float, 3>> seen;
    for (const Ray& ray : rays) seen.insert({ray.direction.x, ray.direction.y, ray.direction.z});
    EXPECT_EQ(seen.size(), 96u) << "every pixel once";
    const auto side = [&](std::size_t first, std::size_t count) {  // of the square that they look through
        float low = 1e3f, high = -1e3f;
        for (std::size_t i = first; i < first + count; ++i) {
            low = std::min(low, across(rays[i]));
            high = std::max(high, across(rays[i]));
        }
        return high - low;
    };
    const float pixel = side(0, 2);
    EXPECT_NEAR(side(0, 4), pixel, 1e-5) << "2 x 2";
    EXPECT_NEAR(side(16, 16), 3 * pixel, 1e-5) << "4 x 4";
    EXPECT_NEAR(side(0, 64), 7 * pixel, 1e-5) << "8 x 8";
}

TEST(BenchRays, SecondaryOnesBeginAtHits) {
    const FlatScene scene = flatten(*make_procedural("ball:300"));
    const std::vector<BenchRays> all = rays_of(scene), again = rays_of(scene), other = rays_of(scene, 2);
    ASSERT_EQ(all.size(), 3u);
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].type, RayType(i));
    ASSERT_EQ(all[1].rays.size(), all[2].rays.size()) << "one of each for a hit";
    ASSERT_LE(all[1].rays.size(), all[0].rays.size());
    ASSERT_GT(all[1].rays.size(), 100u);
    const Vec3 light = scene.lights.front().position;
    // Both begin at most a margin from the hit: 2 gamma(7) |p| (shared/surface.glsl); their sums round off another.
    const float apart =
        5 * KD_GAMMA_7 * glm::length(glm::max(glm::abs(scene.bounds.lower), glm::abs(scene.bounds.upper)));
    // Two directions, each normalised with errors of at most four roundings; what the margin turns them by is squared.
    const float least_cosine = 1 - 8 * std::numeric_limits<float>::epsilon();
    std::size_t changed = 0;
    for (std::size_t i = 0; i < all[1].rays.size(); ++i) {
        const Ray& shadow = all[1].rays[i];
        const Vec3 way = glm::normalize(light - shadow.origin);
        EXPECT_GT(glm::dot(way, glm::normalize(shadow.direction)), least_cosine) << i;
        EXPECT_LT(shadow.t_max, KD_T_LIMIT) << "it ends at the light";
        EXPECT_LT(glm::length(all[2].rays[i].origin - shadow.origin), apart) << "of the same hit";
        EXPECT_EQ(shadow.source, -1) << "peers know of no source";
        EXPECT_GT(shadow.t_min, 0.0f);
        EXPECT_EQ(all[2].rays[i].direction, again[2].rays[i].direction) << "the seed makes them";
        changed += all[2].rays[i].direction != other[2].rays[i].direction;
    }
    EXPECT_EQ(changed, all[2].rays.size());
}

TEST(BenchRays, WithoutALightNoShadow) {
    FlatScene scene = flatten(*make_procedural("ball:300"));
    scene.lights.clear();
    const std::vector<BenchRays> all = rays_of(scene);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[1].type, RayType::random);
}

TEST(RayBench, AnswersDifferByHitAndByT) {
    const Hit hit{3, 2.0f, 0.5f, 0.25f}, none{-1, 9.0f, 0, 0};
    Hit off = hit;
    EXPECT_FALSE(differs(hit, off, false));
    off.t = 2.0001f;  // by half a part in ten thousand
    EXPECT_FALSE(differs(hit, off, false));
    off.t = 2.001f;
    EXPECT_TRUE(differs(off, hit, false));
    EXPECT_FALSE(differs(off, hit, true)) << "any hit will do";
    EXPECT_TRUE(differs(hit, none, true));
    EXPECT_FALSE(differs(none, none, false));
}

/// Answers every ray with this hit.
RayContestant answering(const char* name, const char* tree, Hit hit) {
    return {name, 1, tree, [hit](const BenchRays&, int, std::span<Hit> hits) { std::ranges::fill(hits, hit); }};
}

TEST(RayBench, TracersThatDisagreeAreTold) {
    const std::vector<BenchRays> rays{{RayType::primary, std::vector<Ray>(7)}, {RayType::shadow, std::vector<Ray>(5)}};
    const Hit hit{3, 2.0f, 0.5f, 0.25f};
    Hit bit = hit;
    bit.u = std::nextafter(hit.u, 1.0f);
    const std::vector<RayContestant> contestants{answering(reference_peer, "", {-1, 1, 0, 0}),
                                                 answering("cpu", "asked", hit), answering("cpu-wide", "asked", hit),
                                                 answering("cpu-packet", "cpu-wide", bit)};
    const RayBench bench = bench_tracers(rays, contestants, {.timing = {.warmup = 0, .rounds = 6}, .tell = {}});
    ASSERT_EQ(bench.disagreements.size(), 1u) << "of shadow rays only whether they hit counts";
    EXPECT_EQ(bench.disagreements[0],
              "7 of 7 primary rays: cpu, tree asked and cpu-packet, tree cpu-wide do not hit the same");
    ASSERT_EQ(bench.rows.size(), 8u);
    EXPECT_EQ(bench.rows[0].differ, 0) << "the reference itself";
    EXPECT_EQ(bench.rows[1].differ, 7);
    EXPECT_EQ(bench.rows[1].hits, 7);
    EXPECT_FALSE(bench.rows[1].gain.has_value());
    EXPECT_TRUE(bench.spins.empty());
}

TEST(RayBench, ThreadsAreHeldAgainstOne) {
    const std::vector<BenchRays> rays{{RayType::random, std::vector<Ray>(9)}};
    const std::vector<RayContestant> contestants{answering("cpu", "asked", {-1, 1, 0, 0})};
    const RayBench bench =
        bench_tracers(rays, contestants, {.timing = {.warmup = 0, .rounds = 6}, .threads = 2, .tell = {}});
    ASSERT_EQ(bench.rows.size(), 2u);
    EXPECT_EQ(bench.rows[0].threads, 1);
    EXPECT_FALSE(bench.rows[0].gain.has_value());
    EXPECT_EQ(bench.rows[1].threads, 2);
    ASSERT_TRUE(bench.rows[1].gain && bench.rows[1].gain_of_spin);
    ASSERT_EQ(bench.spins.size(), 1u);
    EXPECT_EQ(bench.spins[0].threads, 2);
    EXPECT_TRUE(bench.spins[0].gain.has_value());
}

TEST(BenchPeers, EveryContestantHasARowForEveryTypeOfRays) {
    if (peers_version().empty()) GTEST_SKIP() << "Embree 3 is not installed";
    const auto outcome =
        run_kdscope({"bench", "ball:300", "--peers", "--json", "--size", "33x21", "--rounds", "6", "--warmup", "0"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::map<std::string, int> rows;
    for (const json& row : json::parse(outcome.out)) {
        const auto tracer = row["tracer"].get<std::string>();
        ++rows[tracer + " " + row["ray_type"].get<std::string>()];
        const bool packets = row["packet"].get<int>() > 1, own = tracer.starts_with("cpu");
        EXPECT_EQ(row["threads"], 1);
        EXPECT_EQ(own, !row["tree"].is_null());
        EXPECT_EQ(own, !row["build"].is_null());
        EXPECT_EQ(own, !row["instructions"].is_null());
        EXPECT_EQ(row["rounds"], 6);
        EXPECT_GT(row["mrays_per_s"], 0.0);
        if (row["ray_type"] == "primary") {
            EXPECT_EQ(row["rays"], 33 * 21);
            EXPECT_EQ(row["differ"], 0) << tracer;
        }
        EXPECT_EQ(row["speed_of"].contains("embree-16-robust"), packets && tracer != "embree-16-robust") << tracer;
        EXPECT_EQ(row["speed_of"].contains("embree-1-robust"), !packets && tracer != "embree-1-robust") << tracer;
    }
    std::map<std::string, int> expected;
    for (const char* type : {"primary", "shadow", "random"}) {
        for (const char* peer : {"embree-1", "embree-1-robust", "embree-16", "embree-16-robust"})
            expected[std::string(peer) + " " + type] = 1;
        expected[std::string("cpu ") + type] = 1;
        expected[std::string("cpu-wide ") + type] = 2;
        expected[std::string("cpu-packet ") + type] = 6;
    }
    EXPECT_EQ(rows, expected);
}

TEST(BenchPeers, PrintsATableForEveryTypeOfRays) {
    if (peers_version().empty()) GTEST_SKIP() << "Embree 3 is not installed";
    const auto outcome =
        run_kdscope({"bench", "ball:300", "--peers", "--size", "64x64", "--rounds", "6", "--warmup", "0"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("tree asked: paper, t_t 1, t_i 1.5, empty bonus 0.2 from 0.1 on, empty cut 0, leaf 2, "
                               "blocks of 1, bad refines 0, nodes of 16 bytes, "),
              std::string::npos)
        << outcome.out;
    std::map<std::string, std::map<std::string, int>> rows;  // by type of rays and contestant
    std::istringstream lines(outcome.out);
    std::string type;
    for (std::string line; std::getline(lines, line);) {
        if (const std::size_t at = line.find(" rays: "); at != std::string::npos) type = line.substr(0, at);
        const std::string contestant = line.substr(0, line.find("  "));
        if (contestant.starts_with("embree-") || contestant.starts_with("cpu")) ++rows[type][contestant];
    }
    const std::map<std::string, int> each{
        {"embree-1", 1}, {"embree-1-robust", 1}, {"embree-16", 1},    {"embree-16-robust", 1}, {"cpu", 1},
        {"cpu-wide", 2}, {"cpu-packet 4", 2},    {"cpu-packet 8", 2}, {"cpu-packet 16", 2}};
    EXPECT_EQ(rows, (std::map<std::string, std::map<std::string, int>>{
                        {"primary", each}, {"shadow", each}, {"random", each}}));
}

/// A row of rays that took `ms`, and a percent more in every other round.
RayBenchRow row_of(const char* tracer, const char* tree, int packet, int threads, double ms) {
    RayBenchRow row{.tracer = tracer, .packet = packet, .tree = tree, .threads = threads, .rays = 262144};
    for (int i = 0; i < 12; ++i) row.timed.rounds.push_back({ms * (1 + 0.01 * (i % 2))});
    if (threads > 1) row.gain = row.gain_of_spin = {1.91, 1.90, 1.93, 0.98, 12};
    return row;
}

/// What bench --peers prints of these rows, with the longest names and times that a quiet machine gives.
std::string table_of(int threads) {
    PeersScene peers;
    peers.peers = "Embree 3.13.5";
    peers.trees["asked"] = peers.trees["cpu-packet"] = {};
    peers.result.rows = {
        row_of("embree-16-robust", "", 16, threads, 8765.43), row_of("embree-16", "", 16, threads, 999.4),
        row_of("cpu-packet", "cpu-packet", 16, threads, 812.3), row_of("cpu-packet", "asked", 8, threads, 43.21)};
    if (threads > 1) {
        peers.result.spins = {row_of("spin", "", 1, threads, 12.3)};
        peers.result.spins.front().spin = true;
    }
    std::ostringstream out;
    print(out, peers, 3);
    return out.str();
}

TEST(BenchPeers, TablesKeepWithinAHundredLetters) {
    // A busy machine's intervals, "0.0849 – 11.4", may take more.
    for (const int threads : {1, 2}) {
        std::istringstream lines(table_of(threads));
        int rows = 0;
        for (std::string line; std::getline(lines, line); rows += line.starts_with("cpu-packet ")) {
            // Processor and build, whose names are the machine's own, stand in the lines before the table.
            if (line.starts_with("tree ") || line.find("Embree 3.13.5") != std::string::npos) continue;
            EXPECT_LE(decode_utf8(line).size(), 100u) << line;
        }
        EXPECT_EQ(rows, 2) << threads;
    }
}

TEST(BenchPeers, WhatContradictsIsRefused) {
    if (peers_version().empty()) {
        expect_usage_error(run_kdscope({"bench", "cornell", "--peers"}),
                           {"--peers", "without Embree", "libembree-dev"});
        return;
    }
    expect_usage_error(run_kdscope({"bench", "cornell", "--peers", "--tracer", "gl-compute"}), {"--peers", "CPU"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--peers", "--traversal", "ropes"}), {"--peers", "stack"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--peers", "--naive"}), {"--naive", "stack"});
}

TEST(BenchPeers, RefusesHolesThatTheyDoNotKnow) {
    if (peers_version().empty()) GTEST_SKIP() << "Embree 3 is not installed";
    expect_usage_error(run_kdscope({"bench", "topiary:20", "--peers"}), {"--peers", "topiary:20", "holes"});
}

}  // namespace
}  // namespace kd

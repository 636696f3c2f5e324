#include "renderer/measure/paper/paper_claims.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/measure/paper/paper_growth.h"

namespace kd {

namespace {

using enum PaperMethod;

constexpr std::array<const char*, 3> sizes{"ball:1000", "ball:4000", "ball:9000"};
constexpr const char* scattered = "scatter:10000";
constexpr const char* sheet = "sheet:10000";

double logarithm(double n) { return std::log(n); }
double root(double n) { return std::sqrt(n); }
double line(double n) { return n; }

std::vector<double> ms_of(const PaperResults& r, std::string_view scene, PaperMethod method) {
    const PaperScene* found = r.scene(scene);
    return found ? found->ms(method) : std::vector<double>{};
}

MedianInterval time_ratio(const PaperResults& r, std::string_view scene, PaperMethod over, PaperMethod under) {
    return ratio_interval(ms_of(r, scene, over), ms_of(r, scene, under));
}

/// The geometric mean over `scenes` of a round's ratios; rounds in which one of them is missing are left out.
template <class Scenes>
MedianInterval mean_ratio(const PaperResults& r, const Scenes& scenes, PaperMethod over, PaperMethod under) {
    std::vector<double> product;
    double count = 0;
    for (const auto& scene : scenes) {
        const std::vector<double> a = ms_of(r, scene, over), b = ms_of(r, scene, under);
        const std::size_t rounds = std::min(a.size(), b.size());
        if (count == 0) product.assign(rounds, 1.0);
        product.resize(std::min(product.size(), rounds));
        for (std::size_t i = 0; i < product.size(); ++i) product[i] *= a[i] > 0 && b[i] > 0 ? a[i] / b[i] : NAN;
        ++count;
    }
    for (double& value : product) value = std::pow(value, 1 / count);
    return median_interval(std::move(product));
}

/// (over/under of `first`) / (over/under of `second`), round by round.
MedianInterval ratio_of_ratios(const PaperResults& r, std::string_view first, std::string_view second, PaperMethod over,
                               PaperMethod under) {
    std::vector<double> a = ms_of(r, first, over), b = ms_of(r, first, under);
    const std::vector<double> c = ms_of(r, second, over), d = ms_of(r, second, under);
    const std::size_t rounds = std::min(std::min(a.size(), b.size()), std::min(c.size(), d.size()));
    a.resize(rounds);
    b.resize(rounds);
    for (std::size_t i = 0; i < rounds; ++i) {
        a[i] *= d[i];
        b[i] *= c[i];
    }
    return ratio_interval(a, b);
}

PaperClaim judged(PaperClaim claim) {
    const Judged result = judge(claim.value, claim.accepted);
    claim.verdict = result.verdict;
    claim.reason = result.reason;
    return claim;
}

/// A claim about what GPUs do.
PaperClaim judged_on_gpu(const PaperResults& r, PaperClaim claim) {
    claim = judged(std::move(claim));
    if (!r.has_gpu_times())
        claim.reason = "no OpenGL here";
    else if (r.on.software_gl)
        claim.reason = "the shaders ran on the CPU: nothing is said of a GPU";
    else
        return claim;
    claim.verdict = PaperVerdict::undecided;
    return claim;
}

/// A time that does not grow at first has no law of growth, and one that may not grow leaves it open.
PaperClaim judged_growth(const Growth& growth, PaperClaim claim) {
    claim.value = growth.ratio;
    claim = judged(std::move(claim));
    const MedianInterval& first = growth.first_ms;
    if (first.samples == 0 || growth.ratio.samples > 0) return claim;
    if (!first.sure()) {
        claim.reason = judge(first, claim.accepted).reason;
        return claim;
    }
    const bool shrinks = first.high <= 0;
    claim.verdict = shrinks ? PaperVerdict::not_reproduced : PaperVerdict::undecided;
    claim.reason = fmt::format("from 1K to 9K triangles the time {} grow: by {} ms", shrinks ? "does not" : "may not",
                               interval_text(first));
    return claim;
}

PaperClaim never(std::string id, std::string where, std::string text, std::string why) {
    return {std::move(id), std::move(where), std::move(text), "–", {}, {}, PaperVerdict::undecided, std::move(why)};
}

void scene_size(const PaperResults& r, std::vector<PaperClaim>& claims) {
    // Half way between growing with the logarithm and with the square root, and as far the other way: a time that stops
    // growing is no logarithm either.
    const double edge = (growth_of(r, logarithm) + growth_of(r, root)) / 2;
    for (const PaperMethod method : {cpurt, cpu_restart, gpurt})
        claims.push_back(
            judged_growth(growth(r, method),
                          {fmt::format("E1a {}", info(method).name),
                           "4.1, Figure 9",
                           "Performance falls logarithmically with the number of triangles.",
                           fmt::format("growth of the time from 9K to 81K triangles over its growth from 1K to 9K: "
                                       "{:.2f} for a logarithm, {:.2f} for a square root, {:.2f} for a line",
                                       growth_of(r, logarithm), growth_of(r, root), growth_of(r, line)),
                           {},
                           {1 / edge, edge}}));
    claims.push_back(judged({"E1b", "4.1", "CPU Kd-restart is only 15 % behind CPURT.",
                             "time of CPU Kd-restart over CPURT, geometric mean of the three sizes",
                             mean_ratio(r, sizes, cpu_restart, cpurt), about_more(0.15)}));
    claims.push_back(judged_on_gpu(r, {"E1c",
                                       "4.1",
                                       "GPURT is an order of magnitude behind CPURT.",
                                       "time of GPURT over CPURT, geometric mean of the three sizes",
                                       mean_ratio(r, sizes, gpurt, cpurt),
                                       {std::sqrt(10.0), 10 * std::sqrt(10.0)}}));
}

void occluded(const PaperResults& r, std::vector<PaperClaim>& claims) {
    claims.push_back(
        judged({"E2a", "4.2, Figure 11", "GPURT is 2x faster on the rooms than on the ball of 9K triangles.",
                "time of GPURT on ball:9000 over its time on rooms",
                ratio_interval(ms_of(r, "ball:9000", gpurt), ms_of(r, "rooms", gpurt)), about(2)}));
    claims.push_back(judged_on_gpu(r, {"E2b", "4.2", "GPURT is on par with the others there, 13 % slower than CPURT.",
                                       "time of GPURT over CPURT on rooms", time_ratio(r, "rooms", gpurt, cpurt),
                                       about_more(0.13)}));
    claims.push_back(judged_on_gpu(r, {"E2c",
                                       "Figure 11",
                                       "The GPU does very well as long as few triangles are on the screen.",
                                       "GPURT over CPURT on ball:9000, over the same on rooms",
                                       ratio_of_ratios(r, "ball:9000", "rooms", gpurt, cpurt),
                                       {1, std::numeric_limits<double>::infinity()}}));
}

void diverging(const PaperResults& r, std::vector<PaperClaim>& claims) {
    for (const char* name : {scattered, sheet}) {
        const PaperScene* scene = r.scene(name);
        const std::string reading = name == std::string_view(scattered) ? "scatter" : "sheet";
        claims.push_back(judged({"E3a " + reading,
                                 "4.3, Figure 13",
                                 "The modified traversal accesses 5x (text) or nearly 4x (caption) the nodes required.",
                                 fmt::format("interior nodes of kd-restart over those of the stack, over {} made from "
                                             "other seeds",
                                             name),
                                 scene ? median_interval(scene->seed_node_ratios) : MedianInterval{},
                                 {3.5, 5.5}}));
    }
    for (const char* name : {scattered, sheet}) {
        const std::string reading = name == std::string_view(scattered) ? "scatter" : "sheet";
        claims.push_back(judged({"E3b " + reading, "4.3, Figure 14", "CPU Kd-restart is about 8x slower than CPURT.",
                                 fmt::format("time of CPU Kd-restart over CPURT on {}", name),
                                 time_ratio(r, name, cpu_restart, cpurt), about(8)}));
        claims.push_back(judged_on_gpu(r, {"E3c " + reading, "4.3", "GPURT is 2x slower than its CPU counterpart.",
                                           fmt::format("time of GPURT over CPU Kd-restart on {}", name),
                                           time_ratio(r, name, gpurt, cpu_restart), about(2)}));
    }
}

void overall(const PaperResults& r, std::vector<PaperClaim>& claims) {
    std::vector<std::string_view> all;
    for (const PaperSceneInfo& scene : paper_scenes())
        if (scene.papers_own && r.scene(scene.name)) all.push_back(scene.name);
    claims.push_back(judged_on_gpu(r, {"E4", "abstract", "GPURT is almost always slower than the CPU, typically 2x.",
                                       "time of GPURT over CPURT, geometric mean of all scenes",
                                       mean_ratio(r, all, gpurt, cpurt), about(2)}));
    // "Persistently" has no number. 1 % is a hole of 51x51 in a picture of 512x512: nobody could show that picture
    // and not mention it, while less might be taken for noise at edges.
    MedianInterval share;
    for (const PaperBudget& row : r.budgets)
        if (row.scene == "ball:2000" && row.budget == 255 && row.pixels > 0)
            share = exactly(double(row.unfinished) / double(row.pixels));
    claims.push_back(
        judged({"E5a",
                "5",
                "The traversal loop persistently reached its ceiling at 2K triangles.",
                "share of the pixels of ball:2000 that kd-restart gives up after 255 steps; that 1 % of them is "
                "enough to call it reached is chosen here",
                share,
                {0.01, 1}}));
    claims.push_back(never("E5b", "5", "Branches cost more than small shaders and their load balancing would.",
                           "there is no tracer of many small shaders here to hold against the four passes"));
    claims.push_back(
        never("E5c", "5", "A day of development on the CPU takes a week on the GPU.", "a program cannot measure that"));
}

void background(const PaperResults& r, std::vector<PaperClaim>& claims) {
    MedianInterval traversal;
    for (const PaperTriangleTests& tests : r.triangle_tests)
        if (tests.scene == "ball:9000") traversal = median_interval(tests.traversal_shares());
    // "Often 60 %" is printed with one digit; its neighbours, 50 and 70 %, are the least and the most that "often"
    // allows.
    PaperClaim share =
        judged({"B1a",
                "2.3.1",
                "Traversal often takes 60 % of the time.",
                "share of the stack traversal's time on ball:9000 that is no triangle test: what testing "
                "every triangle twice adds is left (primary rays, without shading)",
                traversal,
                {0.5, 0.7}});
    if (traversal.samples > 0) share.reason += "; the share is at most this";
    claims.push_back(std::move(share));
    for (const PaperNodeSizes& s : r.node_sizes) {
        PaperClaim claim{fmt::format("B1b {} {}", s.gpu ? "GPU" : "CPU", s.scene),
                         "2.3.1",
                         "Nodes of 8 bytes instead of 16 gain 20 %.",
                         fmt::format("time of a frame of {} by the stack on the {} with nodes of 16 bytes over 8 bytes",
                                     s.scene, s.gpu ? "GPU" : "CPU"),
                         ratio_interval(s.wide.ms(), s.packed.ms()),
                         about_more(0.2)};
        claims.push_back(s.gpu ? judged_on_gpu(r, std::move(claim)) : judged(std::move(claim)));
    }
    claims.push_back({"B1c",
                      "2.2",
                      "A 1024x1024 picture with 3 rays a pixel and 1 million triangles takes 3.1 "
                      "trillion tests.",
                      "1024 x 1024 x 3 rays times 1 million, in 10^12 (its own four passes cast 4 rays a pixel)",
                      exactly(1024.0 * 1024.0 * 3.0 * 1e6 / 1e12),
                      {3.05, 3.15},
                      PaperVerdict::arithmetic,
                      "a product of the paper's own numbers: nothing is measured"});
}

}  // namespace

std::vector<PaperClaim> judge_claims(const PaperResults& results) {
    std::vector<PaperClaim> claims;
    background(results, claims);
    scene_size(results, claims);
    occluded(results, claims);
    diverging(results, claims);
    overall(results, claims);
    return claims;
}

bool wants_rounds(const PaperResults& results) {
    if (results.rounds == 0) return false;
    const auto is_open = [&](const PaperClaim& c) {
        const bool decided_by_times =
            c.id.starts_with("E1a") || c.id.starts_with("E1b") || c.id.starts_with("E2a") || c.id.starts_with("E3b");
        const bool of_gpu = c.id == "E1a GPURT" || c.id == "E2a";
        return decided_by_times && c.verdict == PaperVerdict::undecided && (!of_gpu || results.has_gpu_times());
    };
    return std::ranges::any_of(judge_claims(results), is_open);
}

}  // namespace kd

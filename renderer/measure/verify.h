// Every traversal on every machine against brute force: the naive traversal on the CPU, over the same rays.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/kdtree/build.h"
#include "renderer/measure/ray_machine.h"

namespace kd {

/// Tracer "cpu" walks in any case, as the others' counters are held against its; `cpu` says which have rows. Of several
/// tracers of one machine the first meets every walk in every builder's tree; the others are no other walks, so they
/// are not multiplied with the rest: as a diagonal, each meets every walk and every builder.
struct VerifyConfig : MachineChoice {
    int width = 512, height = 512;
    /// Up to this many triangles every pixel's ray is compared, above it `stratified_rays` of them.
    std::int64_t every_pixel_limit = 12000;
    int stratified_rays = 65536;
    int adversarial_rays = 10000;
    unsigned seed = 1;
    std::vector<std::string> builders;    // empty = all
    std::vector<std::string> traversals;  // empty = all
    Rules rules = Rules::robust;          // published ones: of the traversals that have such a form
    TraceConfig walk;                     // its short stack and its kind of ropes
    /// Of nodes; none: 16 bytes for every traversal in every builder's tree, and 8 so that each of both has seen them.
    std::optional<NodeEncoding> nodes;
    /// Ray-triangle products that the naive traversal is given on one GL context; fewer rays are checked above it.
    std::int64_t gl_naive_tests = 400'000'000;
};

struct VerifyRow {
    std::string builder, traversal, tracer, context;  // builder "-" where no tree is used
    int packet = 0;                                   // rays that walked together; 0 for tracers without packets
    std::string leaf_lists;                           // "references" or "duplicated"
    int node_bytes = 0;                               // 16 or 8; 0 where no tree is used
    std::int64_t pixel_rays = 0, adversarial_rays = 0;
    std::int64_t mismatches = 0;  // hit or miss differs, or t differs in any bit, or u, v differ for the same triangle
    std::int64_t ties = 0;        // same t, another triangle
    /// Rays whose counters differ, where compared: from those of tracer "cpu", there from those over nodes of 16 bytes.
    std::optional<std::int64_t> counter_mismatches;
    std::string first_failure;  // ray in exact hexadecimal floats, expected and found
    double seconds = 0;
    [[nodiscard]] bool good() const { return mismatches == 0 && counter_mismatches.value_or(0) == 0; }
};

struct VerifyReport {
    std::string scene;
    std::int64_t triangles = 0;
    std::vector<VerifyRow> rows;
    std::vector<std::string> notes;        // what was checked with fewer rays, and the like
    std::vector<std::string> not_checked;  // machines that are not there and modes refused, each with the reason
    /// What validate() found wrong with a tree, one line each.
    std::vector<std::string> violations;
    bool complete = true;  // false where stopped before the end
    /// True where at least one row was checked and nothing is wrong. Ties are no fault.
    [[nodiscard]] bool passed() const;
};

/// Rays that hurt: at vertices and edges, axis-parallel with +0 and -0, in split planes, from on planes, grazing cells
/// and triangles, from afar and from beside a triangle, from hits.
[[nodiscard]] std::vector<Ray> adversarial_rays(const FlatScene& scene, const KdTree& tree, int count, unsigned seed);

/// `progress` gets the fraction done and what is being checked.
[[nodiscard]] VerifyReport verify(const FlatScene& scene, const BuildConfig& build, const VerifyConfig& config,
                                  const std::function<void(float, const std::string&)>& progress = {},
                                  std::stop_token stop = {});

}  // namespace kd

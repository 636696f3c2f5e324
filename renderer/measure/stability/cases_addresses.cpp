// Numbers on their way through float texels and graphics memory, and addresses at the ends of tables.

#include <bit>
#include <fmt/format.h>

#include "renderer/geometry/refusal.h"
#include "renderer/gl/gl_limits.h"
#include "renderer/kdtree/encode.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/measure/stability/placed_tree.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

/// Texels per node of the longest table that a walk reads: nodes, then boxes, and ropes behind them.
int texels_per_node(const TraversalInfo& walk) { return walk.has(walk_ropes) ? 4 : walk.has(walk_boxes) ? 2 : 1; }

/// Traces by the walks with so many texels per node, over both kinds of nodes, or those of 8 bytes alone where the
/// tree is too large for floats; each answer has to be the loop's.
void trace_placed(CaseRun& run, const Subject& subject, const std::vector<Ray>& rays, int texels,
                  LeafLists lists = LeafLists::references) {
    const std::vector<Hit> expected = run.loop_hits(subject.scene, rays);
    const bool fits_floats = std::int64_t(subject.tree.nodes.size()) <= float_index_limit;
    const auto trace_over = [&](RayMachine& machine, TraceConfig config, StabilityRow& row) {
        if (config.nodes == NodeEncoding::float4 && !fits_floats) return;
        config.leaf_lists = lists;
        std::vector<Hit> hits(rays.size());
        (void)machine.trace(config, rays, false, hits, {}, run.stop());
        run.check_stop();
        row.n += std::int64_t(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (!bit_equal(hits[i], expected[i]))
                CaseRun::fail(row,
                              fmt::format("{} nodes of {} bytes, {} texels each: ray {}: expected {}, found {}",
                                          subject.tree.nodes.size(), bytes_of(config.nodes), texels,
                                          exact_text(subject.scene, rays[i]), exact_text(subject.scene, expected[i]),
                                          exact_text(subject.scene, hits[i])));
    };
    const auto trace = [&](RayMachine& machine, const TraceConfig& config, StabilityRow& row) {
        if (texels_per_node(info(config.traversal)) != texels) return;
        for (const TraceConfig& with : CaseRun::with_both_nodes(config)) trace_over(machine, with, row);
    };
    run.each(subject, trace, CaseRun::Refusal::may_refuse);
}

/// A tree of `nodes` nodes whose inner nodes and leaves are the last of them.
TreePlaces last_places(std::int32_t nodes, std::int32_t leaves) {
    TreePlaces places{.nodes = nodes, .leaves = {}};
    for (std::int32_t i = leaves; i > 0; --i) places.leaves.push_back(nodes - i);
    places.block = nodes - leaves - TreePlaces::block_size(places.leaves.size());
    return places;
}

constexpr std::int32_t most_places = 1 << 24;
static_assert(most_places == float_index_limit);

/// A tree on both sides of texel 2^24 of the longest table; of nodes of 16 bytes and list entries there are no more
/// than that, of nodes of 8 bytes there are.
void run_last_places(CaseRun& run) {
    constexpr std::int32_t leaves = 64;
    const auto trace = [&](std::int32_t nodes, int texels, LeafLists lists, std::int32_t unseen) {
        const TreePlaces places = last_places(nodes, leaves);
        const std::vector<Ray> rays = rays_across_leaves(run.random(), places, run.rays(100'000));
        trace_placed(run, placed_subject(places, unseen), rays, texels, lists);
    };
    const auto trace_tables = [&](int texels) {
        trace(most_places / texels + 2 * leaves, texels, LeafLists::references, 0);
    };
    trace(most_places, 1, LeafLists::references, 0);
    trace_tables(1);
    trace_tables(4);
    if (!run.long_run()) return;
    trace_tables(2);
    // Corners have three texels per entry where leaves have copies, and per triangle.
    trace(most_places / 3 + 2 * leaves, 1, LeafLists::duplicated, 0);
    trace(1 << 12, 1, LeafLists::references, most_places / 3 - leaves / 2);
}

/// A leaf with such a list comes back from the encoding, or is refused where it is beyond `limit`.
template <class RoundTrip>
void run_number(CaseRun& run, std::int32_t number, std::int64_t limit, const RoundTrip& round_trip) {
    KdTree tree;
    tree.nodes[0].count = tree.nodes[0].link = number;
    KdTree back;
    const std::string refused = refusal([&] { back = round_trip(tree); });
    const bool right = number > limit ? !refused.empty() : refused.empty() && back == tree;
    run.record("nodes", 1, right ? 0 : 1, right ? refused : fmt::format("{} does not come back", number));
}

void run_largest_numbers(CaseRun& run) {
    for (const std::int32_t number : {(1 << 24) - 1, 1 << 24, (1 << 24) + 1})
        run_number(run, number, float_index_limit,
                   [](const KdTree& tree) { return decode_float4(encode_float4(tree), {}, {}); });
    for (const std::int32_t number : {(1 << 30) - 2, (1 << 30) - 1, 1 << 30})
        run_number(run, number, packed_link_limit,
                   [](const KdTree& tree) { return decode_packed(encode_packed(tree), {}, {}); });
    const GlLimits large{std::int64_t(1) << 40, 16384};
    for (const auto& [encoding, limit] :
         {std::pair(NodeEncoding::float4, float_index_limit), {NodeEncoding::packed, packed_link_limit}}) {
        const auto check = [&, trace = TraceConfig{.nodes = encoding}](const UploadSizes& sizes) {
            return refusal([&] { check_config(sizes, trace, large); });
        };
        const bool nodes = check({.nodes = limit}).empty() && !check({.nodes = limit + 1}).empty();
        const bool lists = check({.references = limit}).empty() && !check({.references = limit + 1}).empty();
        run.record("upload", 2, int(!nodes) + int(!lists));
    }
    // Addresses of triangles are integers: three texels each, up to what the context holds.
    const GlLimits usual{134'217'728, 16384};
    const std::int64_t most = usual.buffer_texels / 3;
    const bool fits = refusal([&] { check_upload({.triangles = most}, usual); }).empty() &&
                      !refusal([&] { check_upload({.triangles = most + 1}, usual); }).empty();
    run.record("triangles", 1, fits ? 0 : 1, fmt::format("{} triangles fit 134,217,728 texels", most));
}

/// Of 2^24 ends of rays one that no other has: normal numbers of every exponent up to 2^124, with all bits of a
/// mantissa. What a shader may change has no part: denormals, which may become 0, and what lies beyond KD_T_LIMIT,
/// which is cut.
float end_of_its_own(std::size_t i) {
    constexpr std::uint32_t least = 0x00800000, apart = 125, scattering = 0x9e3779;
    return std::bit_cast<float>(least + apart * (std::uint32_t(i) * scattering % (1u << 24)));
}

/// Rays that miss give back their t_max through upload, shader and read-back.
void run_echo(CaseRun& run, std::size_t count) {
    const Subject subject = run.subject(stress_sphere(8, 4));
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i)
        rays.push_back({Vec3(5, 0, 0), Vec3(1, 0, 0), 0, end_of_its_own(i), int(i)});
    run.each_answer(subject, rays, [&](std::size_t i, const Hit& hit, StabilityRow& row) {
        if (hit.triangle != -1 || hit.t != rays[i].t_max)
            CaseRun::fail(row,
                          fmt::format("ray {} of {} got the answer of another: {}", i, rays.size(), exact_text(hit)));
    });
}

/// A tree whose longest table has 2^24 texels, with leaves on both sides of every 4096th: each has its own triangle.
void run_row_ends(CaseRun& run, int texels) {
    constexpr std::int32_t row = 4096;
    const std::int32_t step = row / texels;
    TreePlaces places{.nodes = most_places / texels, .block = most_places / texels / 2 + 2, .leaves = {}};
    // The inner nodes are read one and all, so that no row end is left out where they lie.
    const std::int32_t behind = places.block + TreePlaces::block_size(3 * std::size_t(most_places / row));
    for (std::int32_t end = step; end <= places.nodes; end += step)
        for (const std::int32_t at : {end - 1, end, end + 1})
            if (at < places.nodes && (at < places.block || at >= behind)) places.leaves.push_back(at);
    const Subject subject = placed_subject(places);
    const std::vector<Ray> rays = rays_to_leaves(places);
    const std::vector<Hit> known = run.loop_hits(subject.scene, rays);
    std::int64_t wrong = 0;
    for (std::size_t i = 0; i < known.size(); ++i) wrong += known[i].triangle != int(i) + 1;
    run.record("brute force", std::int64_t(known.size()), wrong);
    trace_placed(run, subject, rays, texels);
}

/// Triangle numbers and materials as bits: every triangle is hit by its own ray and must be named.
void run_numbers(CaseRun& run) {
    const int cells = run.long_run() ? 708 : 224;
    const Subject plane = run.subject(grid({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, cells, cells));
    std::vector<Ray> rays;
    std::vector<Hit> known;
    for (const Triangle& t : plane.scene.triangles) {
        const Vec3 middle = (t.corner[0] + t.corner[1] + t.corner[2]) / 3.0f;
        rays.push_back(ray_along(middle + Vec3(0, 0, 1), Vec3(0, 0, -1)));
    }
    const std::vector<Hit> found = run.loop_hits(plane.scene, rays);
    std::int64_t wrong = 0;
    for (std::size_t i = 0; i < found.size(); ++i) wrong += found[i].triangle != int(i);
    run.record("brute force", std::int64_t(found.size()), wrong);
    run.check(plane, rays);
}

}  // namespace

StabilityCase case_T45() {
    return {
        "T45",
        "Numbers at the end of float",
        "Links and counts 2^24 - 1, 2^24, 2^24 + 1 in the tree's float texels, 2^30 - 2, 2^30 - 1, 2^30 in nodes of 8 "
        "bytes; as "
        "many nodes, list entries and triangles to upload; rays through a tree that is the last of 2^24 nodes and "
        "list entries, over nodes of 8 bytes on both sides of 2^24, and with ropes on both sides of texel 2^24 (in a "
        "long run with boxes, copied corners and triangles, too: 2 GB)",
        "exact; brute force",
        "up to 2^24, or 2^30 - 1 in nodes of 8 bytes, it comes back exactly, beyond it is refused; 0 mismatches",
        [](CaseRun& run) {
            run_largest_numbers(run);
            run_last_places(run);
        }};
}

StabilityCase case_T46() {
    return {"T46",
            "Integers through the graphics memory",
            "100,352 triangles of one plane (1,002,528 in a long run), a ray to the middle of each",
            "exact: the triangle's own number; brute force",
            "every number comes back",
            run_numbers};
}

StabilityCase case_T47() {
    return {"T47",
            "Places at the ends of rows",
            "Lists of 4095, 4096, 4097, 8193 and 1,677,722 rays (2^24 in a long run) that each answer with a number of "
            "their own; trees of 2^24 nodes and list entries, or texels of ropes (in a long run of boxes, too: 2 GB), "
            "with leaves on both sides of every 4096th, up to the last",
            "exact; brute force",
            "every ray gets its own answer",
            [](CaseRun& run) {
                for (const std::size_t count : {4095u, 4096u, 4097u, 8193u}) run_echo(run, count);
                run_echo(run, run.rays(std::size_t(1) << 24));
                for (const int texels : {1, 4}) run_row_ends(run, texels);
                if (run.long_run()) run_row_ends(run, 2);
            }};
}

}  // namespace kd

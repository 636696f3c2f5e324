// One text, one answer: the tracer built with other flags and by another compiler (tests/flags), against the program's
// own build for this processor's instruction set.

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/kdtree/build.h"
#include "renderer/trace/counters.h"
#include "tests/support/scenes.h"

#define KD_FLAGGED(name, flags) extern "C" void kd_trace_##name(const kd::RayJob& job);
#include "flagged_builds.inc"
#undef KD_FLAGGED

namespace kd {
namespace {

struct FlaggedBuild {
    std::string_view name;
    const char* flags;
    void (*trace)(const RayJob& job);
};

constexpr FlaggedBuild builds[] = {
#define KD_FLAGGED(name, flags) {#name, flags, kd_trace_##name},
#include "flagged_builds.inc"
#undef KD_FLAGGED
};

/// A closed sphere and 20,000 rays to its edges and vertices, into it, along axes and from its corners.
struct Answers {
    FlatScene scene = test::scene_of(test::stress_sphere(80, 40));
    KdTree tree = build_tree(scene.triangles, {});
    std::vector<Ray> rays = test::unkind_rays(scene.triangles, 20'000, 63);

    /// Rays of which a build answers or counts otherwise than the program.
    std::size_t different(const FlaggedBuild& build, Traversal traversal) const {
        const TraceConfig config{.traversal = traversal};
        std::vector<Hit> hits(rays.size()), known(rays.size());
        std::vector<RayCounters> counters(rays.size()), known_counters(rays.size());
        CpuTracer(scene, tree).trace_rays(config, rays, false, known, known_counters);
        SceneView view(scene, tree);
        view.prepare(config);
        build.trace({view, config, rays, false, hits, counters});
        std::size_t count = 0;
        for (std::size_t i = 0; i < rays.size(); ++i)
            count += !bit_equal(hits[i], known[i]) || !(counters[i] == known_counters[i]);
        return count;
    }
};

TEST(BuildFlags, EveryBuildAnswersBitForBitAlike) {
    const Answers answers;
    std::size_t compared = 0;
    for (const FlaggedBuild& build : builds)
        for (const TraversalInfo& traversal : traversals()) {
            if (traversal.id == Traversal::naive || build.name == "fused") continue;
            EXPECT_EQ(answers.different(build, traversal.id), 0u)
                << build.name << " (" << build.flags << "), " << traversal.name;
            ++compared;
        }
    EXPECT_GE(compared, 2 * (traversals().size() - 1)) << "-O0 and -O2 at least";
}

TEST(BuildFlags, ABuildThatFusesShows) {
#if defined(__x86_64__)
    const auto fused = std::ranges::find(builds, "fused", &FlaggedBuild::name);
    if (fused == std::end(builds) || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor cannot fuse";
    EXPECT_GT(Answers().different(*fused, Traversal::stack), 0u);
#else
    GTEST_SKIP() << "whether this processor can fuse is not known";
#endif
}

}  // namespace
}  // namespace kd

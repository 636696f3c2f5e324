// How long a walk may be on OpenGL: what the limits promise, what a driver does that ends loops on its own, and that it
// is told.
#include <algorithm>
#include <optional>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/gl_limits.h"
#include "renderer/measure/stability/stress_scene.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/traversal.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::MachineTest;

std::int64_t steps(const RayCounters& c) {
    return std::int64_t(c.interior_first) + c.interior_again + c.leaves + c.triangle_tests;
}

bool told(const RayCounters& c) { return c.exit_reason == uint(KD_EXIT_STEP_CAP); }

struct Walks {
    std::vector<Hit> hits;
    std::vector<RayCounters> counters;

    explicit Walks(std::size_t count) : hits(count), counters(count) {}
};

/// A speck in a room: the larger the room, the more cells around the speck are closer to a ray than single precision
/// can tell, and the longer are the walks that visit them all.
class Speck {
  public:
    explicit Speck(const char* name)
        : scene_(make_stress_scene(name, 1).value()), tree_(build_tree(scene_.triangles, {})) {
        test::Random random(7);
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = random.point(-4e-3f, 4e-3f);
            rays.push_back({from, random.point(-1e-3f, 1e-3f) - from, 0, KD_T_LIMIT, -1});
        }
    }

    [[nodiscard]] Walks by_cpu(const TraceConfig& config) const {
        Walks walks(rays.size());
        CpuTracer(scene_, tree_).trace_rays(config, rays, false, walks.hits, walks.counters);
        return walks;
    }

    [[nodiscard]] Walks by_gl(Context& context, GlMode mode, const TraceConfig& config,
                              const std::vector<Ray>& asked) const {
        GlTracer tracer(context, mode);
        tracer.upload(scene_, tree_);
        Walks walks(asked.size());
        tracer.trace_rays(config, asked, false, walks.hits, walks.counters);
        return walks;
    }

    std::vector<Ray> rays;

  private:
    FlatScene scene_;
    KdTree tree_;
};

/// The number of the ray that walks longest of those that take at most so many steps.
std::optional<std::size_t> longest_within(const Walks& walks, std::int64_t most) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < walks.counters.size(); ++i) {
        const std::int64_t n = steps(walks.counters[i]);
        if (n <= most && (!found || n > steps(walks.counters[*found]))) found = i;
    }
    return found;
}

class StepBudgetGl : public MachineTest {
  protected:
    /// Calls back for each traversal in each scene, with the answers of the CPU.
    template <class Use>
    static void each_walk(const Use& use) {
        for (const char* name : {"stress:T24=3e5", "stress:T24=1e6", "stress:T24"}) {
            const Speck speck(name);
            for (const TraversalInfo& traversal : traversals())
                if (traversal.id != Traversal::naive)
                    use(speck, TraceConfig{.traversal = traversal.id}, speck.by_cpu({.traversal = traversal.id}));
        }
    }
};
KD_FOR_ALL_MACHINES(StepBudgetGl);

TEST_P(StepBudgetGl, AWalkAmongItsLikeHasTheStepsThatAreSure) {
    std::int64_t longest = 0;
    each_walk([&](const Speck& speck, const TraceConfig& config, const Walks& expected) {
        const auto ray = longest_within(expected, gl_sure_steps);
        if (!ray) return;
        longest = std::max(longest, steps(expected.counters[*ray]));
        // Its neighbours walk as it does: every ray of the draw is the same.
        const Walks found = speck.by_gl(*context, mode(), config, std::vector<Ray>(64, speck.rays[*ray]));
        for (std::size_t i = 0; i < found.hits.size(); ++i) {
            EXPECT_TRUE(bit_equal(expected.hits[*ray], found.hits[i]));
            EXPECT_EQ(expected.counters[*ray], found.counters[i]) << info(config.traversal).name;
        }
    });
    EXPECT_GT(longest, gl_sure_steps * 9 / 10) << "no walk comes close to what is promised";
}

TEST_P(StepBudgetGl, AWalkThatIsEndedIsTold) {
    std::int64_t ended = 0;
    each_walk([&](const Speck& speck, const TraceConfig& config, const Walks& expected) {
        const Walks found = speck.by_gl(*context, mode(), config, speck.rays);
        for (std::size_t i = 0; i < speck.rays.size(); ++i) {
            EXPECT_TRUE(told(found.counters[i]) || bit_equal(expected.hits[i], found.hits[i]))
                << info(config.traversal).name << " " << test::hex(speck.rays[i]);
            EXPECT_LE(steps(found.counters[i]), gl_step_budget);
            EXPECT_TRUE(told(found.counters[i]) || steps(expected.counters[i]) <= gl_step_budget);
            ended += told(found.counters[i]);
        }
    });
    EXPECT_GT(ended, 0) << "no walk is beyond the budget";
}

}  // namespace
}  // namespace kd

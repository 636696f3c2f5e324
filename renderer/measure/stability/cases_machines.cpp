// One answer on every machine, whatever the processor's instruction set and the compiler's wishes.

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <tuple>

#include "renderer/measure/path_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

std::vector<Ray> mixed_rays(Random& random, const std::vector<Triangle>& triangles, std::size_t count) {
    const auto origin = [&] { return random_point(random, -0.3f, 0.3f); };
    std::vector<Ray> rays = rays_to_edges(random, triangles, count / 3, origin);
    for (const Ray& ray : rays_to_vertices(random, triangles, count / 3, origin)) rays.push_back(ray);
    while (rays.size() < count) rays.push_back(ray_along(origin(), random_direction(random)));
    return rays;
}

struct Answers {
    std::vector<Hit> hits;
    std::vector<RayCounters> counters;
};

/// A traversal with each choice that is about it alone.
std::vector<TraceConfig> with_choices(const TraceConfig& trace) {
    std::vector<TraceConfig> all;
    if (trace.traversal == Traversal::short_stack) {
        for (const int entries : {1, 2, 4, 8}) all.emplace_back(trace).short_stack = entries;
    } else if (trace.traversal == Traversal::ropes) {
        for (const bool optimised : {false, true}) all.emplace_back(trace).optimised_ropes = optimised;
    } else {
        all.push_back(trace);
    }
    return all;
}

/// Holds all answers of a walk in one tree against its first ones.
class SameAnswers {
  public:
    SameAnswers(CaseRun& run, const FlatScene& scene, const std::vector<Ray>& rays)
        : run_(run), scene_(scene), rays_(rays) {}

    void walk(RayMachine& machine, const TraceConfig& trace, std::string_view builder, StabilityRow& row) {
        Answers found{std::vector<Hit>(rays_.size()), std::vector<RayCounters>(rays_.size())};
        (void)machine.trace(trace, rays_, false, found.hits, found.counters, run_.stop());
        run_.check_stop();
        row.n += std::int64_t(rays_.size());
        CaseRun::tell_error_of_t(scene_, rays_, found.hits, row);
        const auto [known, is_first] =
            first_.try_emplace({trace.traversal, trace.short_stack, trace.optimised_ropes}, found);
        if (is_first) return;
        const Answers& first = known->second;
        for (std::size_t i = 0; i < rays_.size(); ++i)
            if (!bit_equal(found.hits[i], first.hits[i]) || !(found.counters[i] == first.counters[i]))
                CaseRun::fail(row, fmt::format("{}, nodes of {} bytes: not as at first on the CPU: ray {}: {} and {}",
                                               builder, bytes_of(trace.nodes), exact_text(rays_[i]),
                                               exact_text(first.hits[i]), exact_text(found.hits[i])));
    }

  private:
    CaseRun& run_;
    const FlatScene& scene_;
    const std::vector<Ray>& rays_;
    std::map<std::tuple<Traversal, int, bool>, Answers> first_;
};

void run_machines(CaseRun& run) {
    for (const Builder& builder : builders()) {
        const Subject ball = run.subject(stress_sphere(80, 40), BuildConfig{.builder = std::string(builder.name)});
        const std::vector<Ray> rays =
            mixed_rays(run.random(), ball.scene.triangles, run.rays(1'000'000, builders().size()));
        SameAnswers same(run, ball.scene, rays);
        const auto walk = [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
            for (const TraceConfig& choice : with_choices(trace))
                for (const TraceConfig& with : CaseRun::with_both_nodes(choice))
                    same.walk(machine, with, builder.name, row);
        };
        run.each(ball, walk, CaseRun::Refusal::is_an_error, CaseRun::Walks::all);
    }
}

/// a*b + c rounded twice gives 0 here; once, fused, -2^-46. Compiled for processors that can fuse, as the tracer's hot
/// code is: for others no compiler would.
#if defined(__x86_64__)
__attribute__((target("fma")))
#endif
bool fuses_products() {
    const volatile float a = 1 + 0x1p-23f, b = 1 - 0x1p-23f, c = -1;
    const float sum = a * b + c;
    return sum != 0.0f;
}

bool can_fuse() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("fma");
#else
    return true;
#endif
}

/// The tracer's hot code is compiled for each instruction set, fused multiply-add among them; what it answers must be
/// what the plain processor answers. Bits of u and v show every contraction.
void run_build(CaseRun& run) {
    const bool fused = can_fuse() && fuses_products();
    run.record("a*b+c", 1, fused ? 1 : 0,
               fused        ? "the compiler fused a product and a sum"
               : can_fuse() ? ""
                            : "this processor cannot fuse: nothing proved");
    const Subject ball = run.subject(stress_sphere(30, 15));
    run.check(ball, mixed_rays(run.random(), ball.scene.triangles, run.rays(1'000'000)));
}

}  // namespace

StabilityCase case_T62() {
    return {
        "T62",
        "The same on every machine",
        "The sphere of T14, a third of the rays each to edges, to vertices and anywhere; every builder, traversal and "
        "kind of node",
        "the first machine, the CPU where it takes part, over nodes of 16 bytes",
        "hits and counters equal in every bit on CPU and OpenGL, over both kinds of nodes",
        run_machines};
}

StabilityCase case_T63() {
    return {"T63",
            "No fused arithmetic",
            "A sum of products that shows fusing; rays to a sphere on the tracer's instruction set and in OpenGL",
            "the same text compiled for the plain processor",
            "equal in every bit; a build with -ffast-math does not compile",
            run_build};
}

}  // namespace kd

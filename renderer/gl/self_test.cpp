#include "renderer/gl/self_test.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A driver may round t, u and v in its own way; this is a hundred times what that comes to.
constexpr float tolerance = 1e-5f;

/// A closed ball above a floor.
FlatScene tiny_scene() {
    std::vector<Triangle> triangles = stress_sphere(6, 4);
    for (const Triangle& t : grid({-3, -1.5f, -3}, {6, 0, 0}, {0, 0, 6}, 3, 3)) triangles.push_back(t);
    return bare_scene(std::move(triangles));
}

/// No ray comes near an edge, so that there is one right answer to each.
std::vector<Ray> known_rays(const FlatScene& scene) {
    std::vector<Ray> rays;
    const auto add = [&](Vec3 origin, Vec3 direction, float t_min = 0, float t_max = 1e30f) {
        rays.push_back({origin, direction, t_min, t_max, -1});
    };
    for (std::size_t i = 0; i < 12; ++i) {
        const auto& corner = scene.triangles[(i * 5) % scene.triangles.size()].corner;
        const Vec3 inside = 0.5f * corner[0] + 0.3f * corner[1] + 0.2f * corner[2];
        add(inside * 3.0f + Vec3(0.1f, 4, 0.2f), inside - (inside * 3.0f + Vec3(0.1f, 4, 0.2f)));
    }
    add({0, 5, 0}, {1, 0.3f, 0.2f});  // misses
    add({0.3f, 5, 0.2f}, {0, 1, 0});
    add({0.31f, 4, 0.17f}, {0, -1, 0});  // along axes
    add({0.31f, 4, 0.17f}, {-0.0f, -1, -0.0f});
    add({0.31f, 0.17f, -4}, {-0.0f, 0, 1});
    add({0.05f, 0.1f, 0.02f}, {0.4f, 0.2f, 0.7f});           // from inside
    add({0.31f, 4, 0.17f}, {0.02f, -1, 0.03f}, 0, 1);        // ends before the ball
    add({0.31f, 4, 0.17f}, {0.02f, -1, 0.03f}, 3.5f, 1e3f);  // begins inside of it
    add({nan, 0, 0}, {0, 1, 0});                             // no rays
    add({0, 4, 0}, {0.1f, nan, 0});
    add({0, 4, 0}, {0.1f, -infinity, 0});
    add({infinity, 4, 0}, {0.1f, -1, 0});
    add({0, 4, 0}, {0, -0.0f, 0});
    add({0.31f, 4, 0.17f}, {0, -1, 0}, nan, 1e3f);
    add({0.31f, 4, 0.17f}, {0, -1, 0}, 2, 1);
    return rays;
}

/// One ray's answer.
struct Answer {
    Hit hit;
    RayCounters counters;
};

bool near(float a, float b) { return std::abs(a - b) <= tolerance * std::max(1.0f, std::abs(b)); }

bool agree(const Answer& gl, const Answer& cpu) {
    if (gl.hit.triangle != cpu.hit.triangle || gl.counters.exit_reason != cpu.counters.exit_reason) return false;
    return cpu.hit.triangle < 0 ||
           (near(gl.hit.t, cpu.hit.t) && near(gl.hit.u, cpu.hit.u) && near(gl.hit.v, cpu.hit.v));
}

std::string words(const Answer& answer) {
    if (answer.hit.triangle < 0) return std::string(exit_reason_name(answer.counters.exit_reason));
    return fmt::format("triangle {} at t {}", answer.hit.triangle, answer.hit.t);
}

std::string words(Vec3 v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

}  // namespace

void self_test(GlTracer& tracer, std::string_view renderer) {
    const FlatScene scene = tiny_scene();
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = known_rays(scene);
    const auto traced = [&](const auto& trace) {
        std::vector<Hit> hits(rays.size());
        std::vector<RayCounters> counters(rays.size());
        trace(hits, counters);
        std::vector<Answer> answers;
        for (std::size_t i = 0; i < rays.size(); ++i) answers.push_back({hits[i], counters[i]});
        return answers;
    };
    const std::vector<Answer> cpu = traced(
        [&](auto& hits, auto& counters) { CpuTracer(scene, tree).trace_rays({}, rays, false, hits, counters, 1); });
    tracer.upload(scene, tree);
    const std::vector<Answer> gl =
        traced([&](auto& hits, auto& counters) { tracer.trace_rays({}, rays, false, hits, counters); });

    for (std::size_t i = 0; i < rays.size(); ++i)
        if (!agree(gl[i], cpu[i]))
            throw SelfTestError(fmt::format(
                "OpenGL: '{}' fails the self-test: ray {} of {} from {} towards {} gives {} on the CPU, {} on it; "
                "update the driver, or use --tracer cpu",
                renderer, i + 1, rays.size(), words(rays[i].origin), words(rays[i].direction), words(cpu[i]),
                words(gl[i])));
}

}  // namespace kd

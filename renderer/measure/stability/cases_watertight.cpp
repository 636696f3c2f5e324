// Closed meshes from inside: no ray may slip out, least of all between two triangles.

#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;

/// 6240 triangles of radius 1 (columns x 2 x (rows - 1)).
std::vector<Triangle> sphere() { return stress_sphere(80, 40); }

Expectation must_hit() {
    Expectation e;
    e.every_ray_hits = true;
    return e;
}

}  // namespace

StabilityCase case_T14() {
    return {"T14",
            "Closed sphere from inside",
            "A sphere of 6240 triangles, origins in [-0.3, 0.3]^3, random directions",
            "brute force, double precision; every ray hits",
            "0 misses, t within 64 ulp",
            [](CaseRun& run) {
                const Subject ball = run.subject(sphere());
                std::vector<Ray> rays;
                for (std::size_t i = 0; i < run.rays(full); ++i)
                    rays.push_back(ray_along(random_point(run.random(), -0.3f, 0.3f), random_direction(run.random())));
                run.check(ball, rays, must_hit());
                rays.resize(rays.size() / 20);
                Expectation e;
                e.against_double = HitJudge{};
                run.check(ball, rays, e);
            }};
}

StabilityCase case_T15() {
    return {"T15",
            "Edges of a closed sphere",
            "The sphere of T14, rays to random points of edges",
            "brute force; every ray hits",
            "0 misses",
            [](CaseRun& run) {
                const Subject ball = run.subject(sphere());
                const auto origin = [&] { return random_point(run.random(), -0.3f, 0.3f); };
                run.check(ball, rays_to_edges(run.random(), ball.scene.triangles, run.rays(full), origin), must_hit());
            }};
}

StabilityCase case_T16() {
    return {"T16",
            "Vertices of a closed sphere",
            "The sphere of T14, rays to vertices exactly",
            "brute force; every ray hits",
            "0 misses",
            [](CaseRun& run) {
                const Subject ball = run.subject(sphere());
                const auto origin = [&] { return random_point(run.random(), -0.3f, 0.3f); };
                run.check(ball, rays_to_vertices(run.random(), ball.scene.triangles, run.rays(full), origin),
                          must_hit());
            }};
}

}  // namespace kd

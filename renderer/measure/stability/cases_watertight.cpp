// Closed meshes from inside: no ray may slip out, least of all between two triangles.

#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;

constexpr float inside = 0.3f;  // origins keep to it, along each axis

/// 6240 triangles of radius 1 for 40 rows: 4 x rows x (rows - 1).
std::vector<Triangle> sphere(int rows = 40) { return stress_sphere(2 * rows, rows); }

Expectation must_hit() {
    Expectation e;
    e.every_ray_hits = true;
    return e;
}

/// The rays with their aims moved by up to `offset` along each axis.
std::vector<Ray> off_target(Random& random, std::vector<Ray> rays, double offset) {
    for (Ray& ray : rays) ray.direction += random_direction(random) * float(offset);
    return rays;
}

SweepScene seen_from_inside(std::vector<Triangle> triangles) {
    return {std::move(triangles), {}, camera_at(Vec3(0.2f, 0.1f, 0.3f), Vec3(-1, 0.3f, -0.4f), 75), true};
}

/// Rays that pass edges, or vertices, of the sphere by the parameter.
template <bool at_vertices>
Sweep aim_beside(std::string_view id, std::string_view parameter) {
    return {id,
            parameter,
            "radii",
            true,
            {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            [](double offset, std::size_t n, Random& r) {
                SweepScene made = seen_from_inside(sphere());
                const auto origin = [&] { return random_point(r, -inside, inside); };
                made.rays = at_vertices ? rays_to_vertices(r, made.triangles, n, origin)
                                        : rays_to_edges(r, made.triangles, n, origin);
                made.rays = off_target(r, std::move(made.rays), offset);
                return made;
            }};
}

}  // namespace

StabilityCase case_T14() {
    return {"T14",
            "Closed sphere from inside",
            "A sphere of 6240 triangles, origins in [-0.3, 0.3]^3, random directions",
            "brute force, double precision; every ray hits",
            "0 misses, t within 8 ulp",
            [](CaseRun& run) {
                const Subject ball = run.subject(sphere());
                Expectation e = must_hit();
                e.against_double = plain_view_judge;
                run.check(ball, rays_from_within(run.random(), Vec3(0.0f), inside, run.rays(full)), e);
            }};
}

Sweep sweep_T14() {
    return {
        "T14", "rows of the sphere", "", true, {3, 5, 8, 12, 20, 32, 50}, [](double rows, std::size_t n, Random& r) {
            SweepScene made = seen_from_inside(sphere(int(rows)));
            made.rays = rays_from_within(r, Vec3(0.0f), inside, n);
            return made;
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
                const auto origin = [&] { return random_point(run.random(), -inside, inside); };
                run.check(ball, rays_to_edges(run.random(), ball.scene.triangles, run.rays(full), origin), must_hit());
            }};
}

Sweep sweep_T15() { return aim_beside<false>("T15", "distance from the edge"); }

StabilityCase case_T16() {
    return {"T16",
            "Vertices of a closed sphere",
            "The sphere of T14, rays to vertices exactly",
            "brute force; every ray hits",
            "0 misses",
            [](CaseRun& run) {
                const Subject ball = run.subject(sphere());
                const auto origin = [&] { return random_point(run.random(), -inside, inside); };
                run.check(ball, rays_to_vertices(run.random(), ball.scene.triangles, run.rays(full), origin),
                          must_hit());
            }};
}

Sweep sweep_T16() { return aim_beside<true>("T16", "distance from the vertex"); }

}  // namespace kd

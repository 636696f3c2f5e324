// Scenes far from the origin, very large and very small: no length is built into the tracer.

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;
const Vec3 far_away(148376, 1234, -223423);

/// Rays in scene units, each of which must hit something.
void check_all_hit(CaseRun& run, const Subject& subject, std::vector<Ray> rays) {
    for (Ray& ray : rays) ray = to_internal(subject.scene, ray);
    Expectation e;
    e.every_ray_hits = true;
    run.check(subject, rays, e);
}

/// The sphere of T14 and rays from inside it, both in scene units.
struct Ball {
    std::vector<Triangle> triangles = stress_sphere(80, 40);
    std::vector<Ray> rays;

    Ball(Random& random, std::size_t count) : rays(rays_from_within(random, Vec3(0.0f), 0.3f, count)) {}
};

/// The rays from inside a ball `factor` as large.
std::vector<Ray> scaled_rays(std::vector<Ray> rays, float factor) {
    for (Ray& ray : rays) ray.origin *= factor;
    return rays;
}

/// The same as its subject wants them.
std::vector<Ray> scaled_rays(const std::vector<Ray>& rays, float factor, const FlatScene& scene) {
    std::vector<Ray> scaled = scaled_rays(rays, factor);
    for (Ray& ray : scaled) ray = to_internal(scene, ray);
    return scaled;
}

void run_powers_of_two(CaseRun& run) {
    const Ball ball(run.random(), run.rays(full, 6));
    const Subject base = run.subject(ball.triangles);
    const std::vector<Hit> hits = run.loop_hits(base.scene, ball.rays);
    for (const int k : {-40, -20, -10, 10, 20, 40}) {
        const auto factor = float(std::ldexp(1.0, k));
        const Subject large = run.subject(scaled(ball.triangles, factor));
        std::vector<Hit> known = hits;
        for (Hit& hit : known) hit.t = hit.triangle < 0 ? hit.t : std::ldexp(hit.t, k - large.scene.exponent);
        Expectation e;
        e.known = &known;
        e.every_ray_hits = true;
        e.what = fmt::format("scale 2^{}: ", k);
        run.check(large, scaled_rays(ball.rays, factor, large.scene), e);
    }
}

void run_powers_of_ten(CaseRun& run) {
    const Ball ball(run.random(), run.rays(full, 4));
    for (const float factor : {1e-3f, 1e3f, 1e6f, 1e9f}) {
        const Subject large = run.subject(scaled(ball.triangles, factor));
        Expectation e;
        e.every_ray_hits = true;
        e.against_double = plain_view_judge;
        e.what = fmt::format("scale {}: ", factor);
        run.check(large, scaled_rays(ball.rays, factor, large.scene), e);
    }
}

/// A scene of separate triangles, as a file would bring it.
Scene scene_of(const std::vector<Triangle>& triangles) {
    Scene scene;
    Mesh mesh;
    for (const Triangle& t : triangles)
        for (const Vec3& p : t.corner) {
            mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
            mesh.positions.push_back(p);
        }
    scene.meshes.push_back(mesh);
    scene.instances.push_back({});
    return scene;
}

bool holds_number(const FlatScene& scene, const std::string& number) {
    for (const std::string& note : scene.notes)
        if (note.find("dropped " + number + " ") != std::string::npos) return true;
    return false;
}

bool all_finite(const KdTree& tree) {
    const auto finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    for (const TreeNode& node : tree.nodes)
        if (!node.is_leaf() && !std::isfinite(node.split)) return false;
    return finite(tree.bounds.lower) && finite(tree.bounds.upper);
}

/// Rays from about the middle of the scene to points of its triangles, in internal units.
std::vector<Ray> rays_at_walls(Random& random, const FlatScene& scene, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 from = scene.bounds.centre() + random_point(random, -0.1f, 0.1f) * scene.bounds.extent();
        const Triangle& t = random_triangle(random, scene.triangles);
        const Vec3 middle = (t.corner[0] + t.corner[1] + t.corner[2]) / 3.0f;
        rays.push_back(ray_to(from, glm::mix(point_in(random, t), middle, 0.01f)));  // clear of the edges
    }
    return rays;
}

void run_huge(CaseRun& run) {
    std::vector<Triangle> walls;
    for (const float size : {1e18f, 1.8e18f, 1.9e18f, 3e38f})
        for (const float side : {-1.0f, 1.0f})
            walls.push_back(
                {{Vec3(side * size, -size, -size), Vec3(side * size, size, -size), Vec3(side * size, 0, size)}});
    const Subject subject = run.subject(flatten(scene_of(walls)));
    const bool told = subject.scene.triangles.size() == 4 && holds_number(subject.scene, "4");
    run.record("flatten", 8, told ? 0 : 1, told ? "4 of 8 triangles dropped and told" : "not 4 of 8 triangles dropped");
    run.record("tree", 1, all_finite(subject.tree) ? 0 : 1);
    Expectation e;
    e.every_ray_hits = true;
    // Walls are met at tangents up to 2, so that what shear and differences err by counts thrice: 15u, up to 15 ulp.
    // The worst of a million rays is 6.2 ulp.
    e.against_double = HitJudge{.most_ulps = 16, .tie_ulps = 16};
    run.check(subject, rays_at_walls(run.random(), subject.scene, run.rays(full)), e);
}

void run_tiny(CaseRun& run) {
    const Ball ball(run.random(), run.rays(full, 3));
    for (const double size : {1e-20, 1e-38, 1e-42}) {
        std::vector<Triangle> small = ball.triangles;
        for (Triangle& t : small)
            for (Vec3& p : t.corner) p = Vec3(glm::dvec3(p) * size);
        const Subject subject = run.subject(flatten(scene_of(small)));
        const std::size_t kept = subject.scene.triangles.size(), dropped = small.size() - kept;
        const bool told = dropped == 0 || holds_number(subject.scene, fmt::format("{}", dropped));
        run.record("flatten", std::int64_t(small.size()), told && kept > 0 ? 0 : 1,
                   told ? "" : fmt::format("size {}: {} triangles dropped without a word", size, dropped));
        std::vector<Ray> rays = ball.rays;
        for (Ray& ray : rays) {
            ray.origin = Vec3(glm::dvec3(ray.origin) * size);
            ray = to_internal(subject.scene, ray);
        }
        Expectation e;
        e.every_ray_hits = dropped == 0;
        e.against_double = plain_view_judge;
        e.what = fmt::format("size {}: ", size);
        run.check(subject, rays, e);
    }
}

}  // namespace

StabilityCase case_T18() {
    return {"T18",
            "Sphere far from the origin",
            "A sphere of radius 2 of 159,200 triangles around (148376, 1234, -223423), where floats are 1/64 apart; "
            "origins within 1 of its centre, random directions (Embree's watertightness test)",
            "every ray hits; brute force",
            "0 misses (Embree accepts 2 of 100,000)",
            [](CaseRun& run) {
                const Subject ball = run.subject(stress_sphere(400, 200, 2.0f, far_away));
                check_all_hit(run, ball, rays_from_within(run.random(), far_away, 1, run.rays(full)));
            }};
}

Sweep sweep_T18() {
    return {"T18",
            "distance from the origin",
            "radii",
            true,
            {1, 10, 100, 1e3, 1e4, 1e5, 3e5, 1e6},
            [](double distance, std::size_t n, Random& random) {
                constexpr float radius = 2;
                const Vec3 centre = glm::normalize(far_away) * float(distance * radius);
                return SweepScene{stress_sphere(80, 40, radius, centre), rays_from_within(random, centre, 1, n),
                                  camera_at(centre + Vec3(0.5f, 0.5f, 1), centre - Vec3(2, 1, 1), 75), true};
            }};
}

StabilityCase case_T19() {
    return {"T19",
            "Plane far from the origin",
            "A 12 x 12 plane at x = 148376 of 80,000 triangles; rays from 3 before it to points on it",
            "every ray hits; brute force",
            "0 misses (Embree accepts 2 of 100,000)",
            [](CaseRun& run) {
                const Vec3 corner = far_away - Vec3(0, 6, 6);
                const Subject plane = run.subject(grid(corner, Vec3(0, 12, 0), Vec3(0, 0, 12), 200, 200));
                std::vector<Ray> rays;
                for (std::size_t i = 0; i < run.rays(full); ++i) {
                    Vec3 from = far_away + random_point(run.random(), -5, 5),
                         to = far_away + random_point(run.random(), -5, 5);
                    from.x = far_away.x - 3;
                    to.x = far_away.x;
                    rays.push_back(ray_to(from, to));
                }
                check_all_hit(run, plane, std::move(rays));
            }};
}

StabilityCase case_T20() {
    return {"T20",
            "Scaled by powers of two",
            "The sphere and rays of T14, scaled by 2^-40, 2^-20, 2^-10, 2^10, 2^20, 2^40",
            "the hits at scale 1, t times the power",
            "0 differences in any bit",
            run_powers_of_two};
}

StabilityCase case_T21() {
    return {"T21",
            "Scaled by powers of ten",
            "The sphere and rays of T14, scaled by 1e-3, 1e3, 1e6, 1e9",
            "brute force, double precision; every ray hits",
            "0 misses, t within 8 ulp",
            run_powers_of_ten};
}

Sweep sweep_T21() {
    return {"T21",
            "size of everything",
            "of T14's",
            true,
            {1e-30, 1e-24, 1e-18, 1e-12, 1e-6, 1, 1e6, 1e12, 1e18},
            [](double size, std::size_t n, Random& random) {
                const Ball ball(random, n);
                const auto factor = float(size);
                return SweepScene{scaled(ball.triangles, factor), scaled_rays(ball.rays, factor),
                                  camera_at(Vec3(0.2f, 0.1f, 0.3f) * factor, Vec3(-1, 0.3f, -0.4f) * factor, 75), true};
            }};
}

StabilityCase case_T22() {
    return {"T22",
            "Largest coordinates",
            "Pairs of walls at 1e18, 1.8e18, 1.9e18 and 3e38, loaded as from a file",
            "exact: those beyond 1.844e18 are dropped; brute force, double precision on the others",
            "4 of 8 triangles dropped and told, no infinity in the tree, 0 mismatches",
            run_huge};
}

StabilityCase case_T23() {
    return {"T23",
            "Smallest coordinates",
            "The sphere and rays of T14 at the sizes 1e-20, 1e-38 and 1e-42 (denormal), loaded as from a file",
            "brute force, double precision; every ray hits where no triangle was dropped",
            "0 mismatches, every dropped triangle told",
            run_tiny};
}

}  // namespace kd

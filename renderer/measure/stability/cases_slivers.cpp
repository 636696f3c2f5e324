// Triangles that single precision can hardly tell from lines, and surfaces that it can hardly tell apart.

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

/// Triangles of length 1 and the width given, anywhere in the unit cube.
std::vector<Triangle> slivers(Random& random, int count, float width) {
    std::vector<Triangle> made;
    for (int i = 0; i < count; ++i) {
        const Vec3 at = random_point(random, 0, 1), along = glm::normalize(random_direction(random));
        const Vec3 across = glm::normalize(glm::cross(along, random_direction(random)));
        made.push_back({{at, at + along, at + across * width}});
    }
    return made;
}

double distance_to_edge(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 along = b - a;
    const double length = glm::dot(along, along);
    const double s = length > 0 ? glm::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(p - (a + s * along));
}

double distance_to_edges(glm::dvec3 p, const Triangle& t) {
    double nearest = 1e300;
    for (std::size_t k = 0; k < 3; ++k)
        nearest = std::min(nearest, distance_to_edge(p, glm::dvec3(t.corner[k]), glm::dvec3(t.corner[(k + 1) % 3])));
    return nearest;
}

glm::dvec3 point_at(const Ray& ray, double t) { return glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction); }

/// How far p is outside a triangle's bounding box, along one axis.
double outside_box(glm::dvec3 p, const Triangle& triangle) {
    const Aabb box = bounds_of(triangle);
    const glm::dvec3 out = glm::max(glm::dvec3(box.lower) - p, p - glm::dvec3(box.upper));
    return std::max({0.0, out.x, out.y, out.z});
}

/// Sine of the angle between a ray and a sliver's length: along it, a hair's breadth across is a long way.
double sine_to_length(const Ray& ray, const Triangle& t) {
    const glm::dvec3 along = glm::normalize(glm::dvec3(t.corner[1]) - glm::dvec3(t.corner[0]));
    return glm::length(glm::cross(glm::normalize(glm::dvec3(ray.direction)), along));
}

/// What a sliver's hit is held against: never far outside its triangle, never missed but by its edge.
void judge_sliver(const FlatScene& scene, const Ray& ray, const Hit& hit, const f64::Hit& exact, StabilityRow& row) {
    const auto triangle = [&](int i) -> const Triangle& { return scene.triangles[std::size_t(i)]; };
    const double diagonal = glm::length(glm::dvec3(scene.bounds.extent()));
    if (hit.triangle >= 0) {
        const double outside = outside_box(point_at(ray, double(hit.t)), triangle(hit.triangle)) *
                               sine_to_length(ray, triangle(hit.triangle));
        if (outside > 1e-5 * diagonal)
            CaseRun::fail(row, fmt::format("false hit {:.3g} outside: ray {}: found {}", outside, exact_text(ray),
                                           exact_text(hit)));
    }
    if (exact.triangle < 0) return;
    const bool missed = hit.triangle < 0 || (hit.triangle != exact.triangle && double(hit.t) > exact.t * (1 + 1e-5));
    const double reach = 2 * diagonal;
    const double inside = distance_to_edges(point_at(ray, exact.t), triangle(exact.triangle));
    if (missed && inside > double(KD_SLACK) * reach)
        CaseRun::fail(row, fmt::format("missed {:.3g} inside the edge: ray {}: found {}", inside, exact_text(ray),
                                       exact_text(hit)));
}

void run_slivers(CaseRun& run) {
    const int count = run.long_run() ? 10'000 : 1000;
    for (const float width : {1e-3f, 1e-5f, 1e-7f, 1e-9f}) {
        const Subject subject = run.subject(slivers(run.random(), count, width));
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < run.rays(20'000); ++i) {
            const Triangle& t = random_triangle(run.random(), subject.scene.triangles);
            const auto u = float(run.random().unit()), v = float(run.random().unit()) * (1 - u);
            rays.push_back(ray_to(random_point(run.random(), -1, 2),
                                  t.corner[0] * (1 - u - v) + t.corner[1] * u + t.corner[2] * v));
        }
        Expectation e;
        e.what = fmt::format("width {}: ", width);
        run.check(subject, rays, e);
        const std::vector<f64::Hit> exact = double_brute_force(subject.scene, rays, run.threads(), run.stop());
        run.each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
            std::vector<Hit> hits(rays.size());
            (void)machine.trace(trace, rays, false, hits, {}, run.stop());
            run.check_stop();
            for (std::size_t i = 0; i < rays.size(); ++i) judge_sliver(subject.scene, rays[i], hits[i], exact[i], row);
        });
    }
}

/// The error of t allowed to a ray that meets a plane at `sine`: the shift of a point by KD_SLACK of its distance, which is
/// about gamma(17).
double grazing_bound(double sine) { return 4 * double(KD_SLACK) / sine; }

void run_grazing(CaseRun& run) {
    const Subject plane = run.subject(grid(Vec3(-2, -2, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), 8, 8));
    std::string told = "worst error over bound by angle:";
    for (int power = 1; power <= 8; ++power) {
        const auto angle = float(std::pow(10.0, -power));
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < run.rays(20'000); ++i) {
            const double turn = run.random().between(0, 2 * M_PI);
            const Vec3 from(float(run.random().between(-0.5, 0.5)), float(run.random().between(-0.5, 0.5)), angle);
            rays.push_back(ray_along(from, Vec3(float(std::cos(turn)), float(std::sin(turn)), -angle)));
        }
        Expectation e;
        e.what = fmt::format("angle 1e-{}: ", power);
        run.check(plane, rays, e);
        const std::vector<f64::Hit> exact = double_brute_force(plane.scene, rays, run.threads(), run.stop());
        double worst = 0;
        run.each(plane, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
            std::vector<Hit> hits(rays.size());
            (void)machine.trace(trace, rays, false, hits, {}, run.stop());
            run.check_stop();
            for (std::size_t i = 0; i < rays.size(); ++i) {
                if (hits[i].triangle < 0 || exact[i].triangle < 0) continue;
                const double error = std::abs(double(hits[i].t) - exact[i].t) / grazing_bound(double(angle));
                worst = std::max(worst, error);
                if (!(error <= 1))
                    CaseRun::fail(row, fmt::format("{}t errs by {:.3g} of the bound: ray {}: found {}", e.what, error,
                                                   exact_text(rays[i]), exact_text(hits[i])));
            }
        });
        told += fmt::format(" 1e-{}: {:.2g};", power, worst);
    }
    run.record("bound", 8, 0, told);
}

struct PlanePair {
    float z, above;  // the nearer and the farther plane
};

std::vector<PlanePair> plane_pairs() {
    std::vector<PlanePair> pairs;
    for (const float z : {1.0f, 1000.0f}) {
        const float one = std::nextafter(z, 2 * z), two = std::nextafter(one, 2 * z);
        pairs.push_back({z, one});
        pairs.push_back({z, two});
        pairs.push_back({z, z + 8 * (one - z)});
        pairs.push_back({z, std::max(z * (1 + 1e-6f), z + 1e-6f)});
    }
    return pairs;
}

void run_plane_pair(CaseRun& run, const PlanePair& pair) {
    const float half = pair.z;
    std::vector<Triangle> both = grid({-half, -half, pair.above}, {2 * half, 0, 0}, {0, 2 * half, 0}, 4, 4);
    const int upper = int(both.size());
    for (const Triangle& t : grid({-half, -half, pair.z}, {2 * half, 0, 0}, {0, 2 * half, 0}, 4, 4)) both.push_back(t);
    const Subject subject = run.subject(both);
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) {
        Vec3 from = random_point(run.random(), -0.5f * half, 0.5f * half),
             to = random_point(run.random(), -0.9f, 0.9f) * half;
        from.z = 0;
        to.z = pair.z;
        rays.push_back(ray_to(from, to));
    }
    Expectation e;
    e.every_ray_hits = true;
    e.what = fmt::format("planes at {} and {}: ", pair.z, pair.above);
    run.check(subject, rays, e);
    // t is 1 at the nearer plane, so that an ulp of t is 2^-23.
    const bool apart = double(pair.above - pair.z) / double(pair.z) >= 4 * 0x1p-23;
    run.each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        std::vector<Hit> first(rays.size()), again(rays.size());
        (void)machine.trace(trace, rays, false, first, {}, run.stop());
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (apart && first[i].triangle < upper)
                CaseRun::fail(row, fmt::format("{}the farther plane was hit: ray {}: found {}", e.what,
                                               exact_text(rays[i]), exact_text(first[i])));
        for (int frame = 1; frame < (run.long_run() ? 100 : 10); ++frame) {
            (void)machine.trace(trace, rays, false, again, {}, run.stop());
            run.check_stop();
            for (std::size_t i = 0; i < rays.size(); ++i)
                if (!bit_equal(first[i], again[i])) CaseRun::fail(row, e.what + "changed from one frame to the next");
        }
    });
}

}  // namespace

StabilityCase case_T25() {
    return {
        "T25",
        "Slivers",
        "1000 triangles (10,000 with --long) of length 1 and width 1e-3, 1e-5, 1e-7, 1e-9; rays to points on them",
        "brute force; double precision",
        "no hit more than 1e-5 of the diagonal, over the sine of the ray's angle to the sliver's length, outside its "
        "triangle's box; a miss only where the ray is within the slack "
        "(1e-6 of its reach) of an edge",
        run_slivers};
}

StabilityCase case_T27() {
    return {"T27",
            "Grazing a plane",
            "A plane of 128 triangles, unit rays that meet it at angles of 1e-1 to 1e-8 radians",
            "brute force; double precision",
            "t within 4e-6 / sin(angle), a rounding of the point by gamma(17) of the plane's size",
            run_grazing};
}

StabilityCase case_T30() {
    return {"T30",
            "Planes an ulp apart",
            "Two parallel planes at z = 1 and z = 1000, apart by 1, 2 and 8 ulp and by 1e-6 of z; the farther one has "
            "the lower "
            "numbers; 10 frames (100 with --long)",
            "brute force; the nearer plane where 4 ulp of t or more apart",
            "the nearer plane wins, every frame is the same",
            [](CaseRun& run) {
                for (const PlanePair& pair : plane_pairs()) run_plane_pair(run, pair);
            }};
}

}  // namespace kd

// Triangles that single precision can hardly tell from lines, and surfaces that it can hardly tell apart.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/measure/stability/distances.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;

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

std::vector<Ray> rays_at_slivers(Random& random, const std::vector<Triangle>& triangles, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 target = point_in(random, random_triangle(random, triangles));
        rays.push_back(ray_to(random_point(random, -1, 2), target));
    }
    return rays;
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

/// What a sliver's hit is held against: never far outside its triangle, never missed but by its edge. True where it was
/// missed.
bool judge_sliver(const FlatScene& scene, const Ray& ray, const Hit& hit, const f64::Hit& exact, StabilityRow& row) {
    const auto triangle = [&](int i) -> const Triangle& { return scene.triangles[std::size_t(i)]; };
    const double diagonal = glm::length(glm::dvec3(scene.bounds.extent()));
    if (hit.triangle >= 0) {
        const double outside = outside_box(point_at(ray, double(hit.t)), triangle(hit.triangle)) *
                               sine_to_length(ray, triangle(hit.triangle));
        if (outside > 1e-5 * diagonal)
            CaseRun::fail(row, fmt::format("false hit {:.3g} outside: ray {}: found {}", outside, exact_text(ray),
                                           exact_text(hit)));
    }
    if (exact.triangle < 0) return false;
    const bool missed = hit.triangle < 0 || (hit.triangle != exact.triangle && double(hit.t) > exact.t * (1 + 1e-5));
    const double reach = 2 * diagonal;
    const double inside = distance_to_edges(ray, triangle(exact.triangle));
    if (missed && inside > double(KD_SLACK) * reach)
        CaseRun::fail(row, fmt::format("missed {:.3g} from the edge: ray {}: found {}", inside, exact_text(ray),
                                       exact_text(hit)));
    return missed;
}

void run_slivers(CaseRun& run) {
    const int count = run.long_run() ? 10'000 : 1000;
    std::string told = "missed of those that double precision hits, by width:";
    std::int64_t rays_in_all = 0;
    for (const float width : {1e-3f, 1e-5f, 1e-7f, 1e-9f}) {
        const Subject subject = run.subject(slivers(run.random(), count, width));
        const auto rays = rays_at_slivers(run.random(), subject.scene.triangles, run.rays(full, 4));
        Expectation e;
        e.what = fmt::format("width {}: ", width);
        run.check(subject, rays, e);
        const std::vector<f64::Hit> exact = run.exact_hits(subject.scene, rays);
        std::vector<char> missed(rays.size());  // by any walk
        const auto judge = [&](std::size_t i, const Hit& hit, StabilityRow& row) {
            missed[i] |= judge_sliver(subject.scene, rays[i], hit, exact[i], row);
        };
        run.each_answer(subject, rays, judge, CaseRun::Counted::by_check);
        const auto meant =
            std::count_if(exact.begin(), exact.end(), [](const f64::Hit& hit) { return hit.triangle >= 0; });
        told += fmt::format(" {:g}: {} of {};", width, std::count(missed.begin(), missed.end(), 1), meant);
        rays_in_all += std::int64_t(rays.size());
    }
    run.record("missed", rays_in_all, 0, told);
}

/// The error of t allowed to a unit ray that meets a plane at `sine`, a unit from where it begins: the shift of a point
/// by KD_SLACK, which is about gamma(17), of that distance.
double grazing_bound(double sine) { return double(KD_SLACK) / sine; }

/// Two directions within the plane that is grazed, and its normal.
struct PlaneAxes {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

/// No component of it is 0, so that every coordinate rounds.
const PlaneAxes tilted{Vec3(2, 3, 6) / 7.0f, Vec3(3, -6, 2) / 7.0f, Vec3(6, 2, -3) / 7.0f};

std::vector<Triangle> grazed_plane(const PlaneAxes& axes) {
    return grid(-2.0f * axes.x - 2.0f * axes.y, 4.0f * axes.x, 4.0f * axes.y, 8, 8);
}

/// Unit rays that meet the plane at `angle`, a unit from where they begin.
std::vector<Ray> grazing_rays(Random& random, std::size_t count, float angle, const PlaneAxes& axes) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = random.between(0, 2 * M_PI);
        const auto x = float(random.between(-0.5, 0.5)), y = float(random.between(-0.5, 0.5));
        const Vec3 up = axes.z * angle;
        const Vec3 along = axes.x * float(std::cos(turn)) + axes.y * float(std::sin(turn));
        rays.push_back(ray_along(axes.x * x + axes.y * y + up, along - up));
    }
    return rays;
}

void run_grazing(CaseRun& run) {
    const Subject plane = run.subject(grazed_plane(tilted));
    std::string told = "worst error over bound by angle:";
    for (int power = 1; power <= 8; ++power) {
        const auto angle = float(std::pow(10.0, -power));
        const std::vector<Ray> rays = grazing_rays(run.random(), run.rays(full, 8), angle, tilted);
        Expectation e;
        e.what = fmt::format("angle 1e-{}: ", power);
        run.check(plane, rays, e);
        const std::vector<f64::Hit> exact = run.exact_hits(plane.scene, rays);
        double worst = 0;
        const auto judge = [&](std::size_t i, const Hit& hit, StabilityRow& row) {
            const bool found = hit.triangle >= 0, meant = exact[i].triangle >= 0;
            // From where a rounding moves the hit by as much as the plane is wide, either may miss it.
            if (found != meant && grazing_bound(double(angle)) < 1)
                CaseRun::fail(row,
                              fmt::format("{}{}: ray {}", e.what, found ? "false hit" : "missed", exact_text(rays[i])));
            if (!found || !meant) return;
            const double error = std::abs(double(hit.t) - exact[i].t) / grazing_bound(double(angle));
            worst = std::max(worst, error);
            if (!(error <= 1))
                CaseRun::fail(row, fmt::format("{}t errs by {:.3g} of the bound: ray {}: found {}", e.what, error,
                                               exact_text(rays[i]), exact_text(hit)));
        };
        run.each_answer(plane, rays, judge, CaseRun::Counted::by_check);
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

/// The farther plane first, half of the triangles each.
std::vector<Triangle> planes_of(const PlanePair& pair) {
    const float half = pair.z;
    std::vector<Triangle> both = grid({-half, -half, pair.above}, {2 * half, 0, 0}, {0, 2 * half, 0}, 4, 4);
    for (const Triangle& t : grid({-half, -half, pair.z}, {2 * half, 0, 0}, {0, 2 * half, 0}, 4, 4)) both.push_back(t);
    return both;
}

/// From z = 0 to points on the nearer plane.
std::vector<Ray> rays_at_planes(Random& random, const PlanePair& pair, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 from = random_point(random, -0.5f * pair.z, 0.5f * pair.z),
             to = random_point(random, -0.9f, 0.9f) * pair.z;
        from.z = 0;
        to.z = pair.z;
        rays.push_back(ray_to(from, to));
    }
    return rays;
}

void run_plane_pair(CaseRun& run, const PlanePair& pair) {
    const Subject subject = run.subject(planes_of(pair));
    const int upper = int(subject.scene.triangles.size()) / 2;
    const std::vector<Ray> rays = rays_at_planes(run.random(), pair, run.rays(full, 8));
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
        "1000 triangles (10,000 in a long run) of length 1 and width 1e-3, 1e-5, 1e-7, 1e-9; rays to points on them",
        "brute force; double precision",
        "no hit more than 1e-5 of the diagonal, over the sine of the ray's angle to the sliver's length, outside its "
        "triangle's box; a miss only where the ray is within the slack (1e-6 of its reach) of an edge: anywhere on a "
        "sliver of width 1e-5 or less, whose misses are told and not judged",
        run_slivers};
}

Sweep sweep_T25() {
    return {"T25",
            "width of the triangles",
            "lengths",
            true,
            {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            [](double width, std::size_t n, Random& random) {
                SweepScene made{slivers(random, 1000, float(width)), {}, camera_at({0.5f, 0.5f, 2.6f}, Vec3(0.5f), 50)};
                made.rays = rays_at_slivers(random, made.triangles, n);
                return made;
            }};
}

StabilityCase case_T27() {
    return {"T27",
            "Grazing a plane",
            "A tilted plane of 128 triangles, unit rays that meet it at angles of 1e-1 to 1e-8 radians",
            "brute force; double precision",
            "t within 1e-6 / sin(angle), a rounding of the point by gamma(17) of its distance; none missed above 1e-6 "
            "radians",
            run_grazing};
}

Sweep sweep_T27() {
    return {"T27",
            "angle between ray and plane",
            "radians",
            true,
            {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            [](double angle, std::size_t n, Random& random) {
                const auto height = float(angle);
                // A plane at z = 0 is met without any rounding; one that is tilted is not.
                SweepScene made{grazed_plane(tilted), grazing_rays(random, n, height, tilted), {}};
                made.camera = camera_at(tilted.z * height - tilted.x, Vec3(0.0f), 40);
                made.camera.up = tilted.z;
                return made;
            }};
}

StabilityCase case_T30() {
    return {"T30",
            "Planes an ulp apart",
            "Two parallel planes at z = 1 and z = 1000, apart by 1, 2 and 8 ulp and by 1e-6 of z; the farther one has "
            "the lower numbers; 10 frames (100 in a long run)",
            "brute force; the nearer plane where 4 ulp of t or more apart",
            "the nearer plane wins, every frame is the same",
            [](CaseRun& run) {
                for (const PlanePair& pair : plane_pairs()) run_plane_pair(run, pair);
            }};
}

Sweep sweep_T30() {
    return {"T30",
            "gap between the planes",
            "ulp",
            true,
            {1, 2, 4, 8, 32, 128, 1024, 8192, 65536},
            [](double gap, std::size_t n, Random& random) {
                const PlanePair pair{1, float(1 + gap * 0x1p-23)};
                return SweepScene{planes_of(pair), rays_at_planes(random, pair, n),
                                  camera_at(Vec3(0.0f), {0, 0, 1}, 60), true};
            }};
}

}  // namespace kd

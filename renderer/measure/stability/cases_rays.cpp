// Rays that are no ordinary rays: of any length, without direction, not finite, or over an empty interval.

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "renderer/measure/path_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;
constexpr float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

std::vector<Ray> inside_rays(Random& random, std::size_t count) {
    return rays_from_within(random, Vec3(0.0f), 0.3f, count);
}

std::vector<Ray> times_as_long(std::vector<Ray> rays, float length) {
    for (Ray& ray : rays) ray.direction *= length;
    return rays;
}

void run_lengths(CaseRun& run) {
    const Subject ball = run.subject(stress_sphere(80, 40));
    const std::vector<Ray> unit = inside_rays(run.random(), run.rays(full, 4));
    for (const float length : {1e-20f, 1e-3f, 1e3f, 1e20f}) {
        const std::vector<Ray> rays = times_as_long(unit, length);
        Expectation e;
        e.every_ray_hits = true;
        e.against_double = plain_view_judge;
        e.what = fmt::format("length {}: ", length);
        run.check(ball, rays, e);
    }
}

/// One invalid ray of each kind, from a valid one.
std::vector<Ray> spoiled(const Ray& ray, int axis) {
    std::vector<Ray> rays(9, ray);
    rays[0].direction = Vec3(0.0f);
    rays[1].origin[axis] = nan;
    rays[2].direction[axis] = nan;
    rays[3].origin[axis] = infinite;
    rays[4].origin[axis] = -infinite;
    rays[5].direction[axis] = infinite;
    rays[6].direction[axis] = -infinite;
    rays[7].t_min = nan;
    rays[8].t_max = nan;
    return rays;
}

void run_invalid(CaseRun& run) {
    const Subject ball = run.subject(stress_sphere(80, 40));
    std::vector<Ray> rays;
    int axis = 0;
    for (const Ray& ray : inside_rays(run.random(), 1000))
        for (const Ray& bad : spoiled(ray, axis++ % 3)) rays.push_back(bad);
    run.each(ball, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        std::vector<Hit> hits(rays.size());
        std::vector<RayCounters> counters(rays.size());
        for (const bool any_hit : {false, true}) {
            (void)machine.trace(trace, rays, any_hit, hits, counters, run.stop());
            run.check_stop();
            row.n += std::int64_t(rays.size());
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const RayCounters& c = counters[i];
                const bool walked = c.interior_first + c.interior_again + c.leaves + c.triangle_tests > 0;
                if (hits[i].triangle >= 0 || walked || c.exit_reason != uint(KD_EXIT_INVALID_RAY))
                    CaseRun::fail(row, fmt::format("{}: {}, {}: ray {}", exit_reason_name(c.exit_reason),
                                                   exact_text(hits[i]), walked ? "walked" : "not walked",
                                                   exact_text(rays[i])));
            }
        }
    });
}

/// Rays that hit at `t`, over intervals that hold it or do not; brute force says what is right, and what must miss is
/// listed.
void run_intervals(CaseRun& run) {
    const Subject ball = run.subject(stress_sphere(80, 40));
    const std::vector<Ray> open = inside_rays(run.random(), run.rays(full, 5));
    const std::vector<Hit> hits = run.loop_hits(ball.scene, open);
    std::vector<Ray> rays;
    std::vector<Hit> known;
    const auto add = [&](const Ray& ray, float t_min, float t_max, const Hit& hit) {
        rays.push_back({ray.origin, ray.direction, t_min, t_max, -1});
        known.push_back(hit.triangle < 0 ? Hit{-1, t_max, 0, 0} : hit);
    };
    const Hit none{-1, 0, 0, 0};
    for (std::size_t i = 0; i < open.size(); ++i) {
        const float t = hits[i].t;
        add(open[i], 2 * t, 0.5f * t, none);
        add(open[i], 0, 0, none);
        add(open[i], 0, t, none);
        add(open[i], 0, std::nextafter(t, 2 * t), hits[i]);
        add(open[i], std::nextafter(t, 0.0f), 2 * t, hits[i]);
    }
    Expectation e;
    e.known = &known;
    run.check(ball, rays, e);
}

/// A floor under a lamp whose light sits on the lamp's own triangles: shadow rays end there and must not be stopped by
/// them.
void run_lamp(CaseRun& run) {
    std::vector<Triangle> room = grid({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}, 4, 4);
    for (const Triangle& t : grid({-0.31f, -0.27f, 2.1f}, {0.6f, 0.02f, 0.05f}, {0, 0.6f, 0.03f}, 1, 1))
        room.push_back(t);
    const Subject subject = run.subject(room);
    std::vector<Ray> shadows;
    std::vector<Hit> clear;
    while (shadows.size() < run.rays(full, 5)) {
        const Triangle& lamp = room[room.size() - 1 - std::size_t(random_below(run.random(), 2))];
        Light light = subject.scene.lights[0];
        light.position = point_in(run.random(), lamp);
        Vec3 eye = random_point(run.random(), -2, 2), at = random_point(run.random(), -3, 3);
        eye.z = 1;
        at.z = 0;
        const Ray ray = ray_to(eye, at);
        const Hit hit = plain_brute_force(subject.scene, ray);
        if (hit.triangle < 0) continue;
        shadows.push_back(shadow_ray(subject.scene, ray, hit, light).ray);
        clear.push_back({-1, shadows.back().t_max, 0, 0});
    }
    Expectation e;
    e.known = &clear;
    e.what = "lamp: ";
    run.check(subject, shadows, e);
}

}  // namespace

StabilityCase case_T35() {
    return {"T35",
            "Directions of any length",
            "The sphere and rays of T14, directions 1e-20, 1e-3, 1e3 and 1e20 times as long",
            "brute force, double precision; every ray hits",
            "0 misses, t within 8 ulp",
            run_lengths};
}

Sweep sweep_T35() {
    return {"T35",
            "length of the directions",
            "units",
            true,
            {1e-28, 1e-20, 1e-15, 1e-10, 1e-5, 1, 1e5, 1e10, 1e15, 1e20},
            [](double length, std::size_t n, Random& random) {
                return SweepScene{stress_sphere(80, 40), times_as_long(inside_rays(random, n), float(length)),
                                  camera_at(Vec3(0.2f, 0.1f, 0.3f), Vec3(-1, 0.3f, -0.4f), 75), true};
            }};
}

StabilityCase case_T36() {
    return {"T36",
            "Rays that are none",
            "1000 each: no direction; NaN or an infinity in origin or direction; NaN as tmin or tmax",
            "exact: nothing is hit",
            "no hit, no step, and the exit reason is 'invalid ray'",
            run_invalid};
}

StabilityCase case_T37() {
    return {"T37",
            "Intervals",
            "The rays of T14 with tmin > tmax, tmax = 0, tmax = t, and intervals that just hold t; shadow rays of a "
            "floor to a light that lies on a lamp's triangles",
            "exact",
            "no hit outside (tmin, tmax); no lamp shadows itself",
            [](CaseRun& run) {
                run_intervals(run);
                run_lamp(run);
            }};
}

}  // namespace kd

// Rays that leave triangles of every size, wherever they lie: none may hit what it leaves.

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "renderer/measure/path_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

/// One spawning configuration: triangles of a size around a point, seen from a distance.
struct SpawnRow {
    float size, away, distance;
};

constexpr SpawnRow spawn_rows[] = {{1e-6f, 0, 10}, {1e-3f, 0, 10}, {1, 0, 10},    {1e3f, 0, 10},
                                   {1e6f, 0, 10},  {1, 1, 10},     {1, 1e4f, 10}, {1, 1e6f, 10},
                                   {1, 0, 1e3f},   {1, 0, 1e4f},   {1, 0, 1e6f}};

float ulp(float x) { return std::nextafter(std::abs(x), KD_T_LIMIT) - std::abs(x); }

std::vector<Triangle> spawning_soup(Random& random, const SpawnRow& r) {
    std::vector<Triangle> triangles = random_soup(1000, 0.5f, random);
    for (Triangle& t : triangles)
        for (Vec3& p : t.corner) p = p * r.size + Vec3(r.away);
    return triangles;
}

/// To a point of the triangle, from as far away as the row says.
Ray ray_from_afar(Random& random, const Triangle& t, const SpawnRow& r) {
    const Vec3 target = point_in(random, t);
    return ray_to(target + glm::normalize(random_direction(random)) * r.distance * r.size, target);
}

void run_spawn_row(CaseRun& run, const SpawnRow& r, std::int64_t& self_hits, std::int64_t& spawned) {
    Random& random = run.random();
    const std::vector<Triangle> triangles = spawning_soup(random, r);
    const Subject subject = run.subject(triangles);
    std::vector<Ray> rays, unguarded;
    std::int64_t far_off = 0;
    const std::size_t wanted = run.rays(200'000);
    for (std::size_t tries = 0; rays.size() < wanted && tries < 20 * wanted; ++tries) {
        const Triangle& t = random_triangle(random, triangles);
        FlatScene one;
        one.triangles = {subject.scene.triangles[std::size_t(&t - triangles.data())]};
        one.attributes = {subject.scene.attributes[0]};
        one.materials = subject.scene.materials;
        for (const Vec3& p : one.triangles[0].corner) one.bounds.include(p);
        const Ray seen = to_internal(subject.scene, ray_from_afar(random, t, r));
        Hit hit = plain_brute_force(one, seen);
        if (hit.triangle < 0) continue;
        hit.triangle = int(&t - triangles.data());
        const LeavingRay leaving = leave_hit(subject.scene, seen, hit, glm::normalize(random_direction(random)));
        const Vec3 p = glm::abs(leaving.position);
        float largest = 0;
        for (const Vec3& corner : one.triangles[0].corner)
            for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(corner[axis]));
        if (glm::length(leaving.ray.origin - leaving.position) > 64 * ulp(std::max({largest, p.x, p.y, p.z})))
            ++far_off;
        rays.push_back(leaving.ray);
        unguarded.push_back(leaving.ray);
        unguarded.back().source = -1;
    }
    const std::string name = fmt::format("size {} at {} from {}", r.size, r.away, r.distance);
    if (rays.size() < wanted)
        run.record(
            "rays", std::int64_t(wanted), std::int64_t(wanted - rays.size()),
            fmt::format("{}: only {} of {} rays met the triangle that they were aimed at", name, rays.size(), wanted));
    run.record("offset", std::int64_t(rays.size()), far_off,
               far_off > 0 ? name + ": an origin more than 64 ulp from its point" : "");
    Expectation e;
    e.what = name + ": ";
    run.check(subject, rays, e);
    run.each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        std::vector<Hit> guarded(rays.size()), open(rays.size());
        (void)machine.trace(trace, rays, false, guarded, {}, run.stop());
        (void)machine.trace(trace, unguarded, false, open, {}, run.stop());
        run.check_stop();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (guarded[i].triangle == rays[i].source)
                CaseRun::fail(row, e.what + "self-hit: ray " + exact_text(subject.scene, rays[i]));
            self_hits += open[i].triangle == rays[i].source;
        }
        spawned += std::int64_t(rays.size());
    });
}

void run_spawn(CaseRun& run) {
    std::int64_t self_hits = 0, spawned = 0;
    for (const SpawnRow& r : spawn_rows) run_spawn_row(run, r, self_hits, spawned);
    // The offset alone nearly does it: gamma(7) leaves up to 6 in 100,000.
    run.record("unguarded", spawned, self_hits > spawned / 10'000 ? self_hits : 0,
               fmt::format("{} of {} would hit their own triangle if it were not excluded", self_hits, spawned));
}

}  // namespace

StabilityCase case_T38() {
    return {"T38",
            "Rays that leave triangles",
            "11 rows: triangles of size 1e-6 to 1e6, moved by 0 to 1e6, seen from 10 to 1e6 sizes away; 200,000 "
            "rays each that leave them in random directions by the tracer's own rule",
            "brute force; no ray hits the triangle it leaves",
            "0 self-hits; origins within 64 ulp of the largest coordinate; without the exclusion at most 1 in 10,000",
            run_spawn};
}

Sweep sweep_T38() {
    return {"T38",
            "distance of the eye",
            "sizes",
            true,
            {1, 10, 100, 1e3, 1e4, 1e5, 1e6},
            [](double distance, std::size_t n, Random& random) {
                const SpawnRow row{1, 0, float(distance)};
                SweepScene made{spawning_soup(random, row), {}, {}};
                for (std::size_t i = 0; i < n; ++i)
                    made.rays.push_back(ray_from_afar(random, random_triangle(random, made.triangles), row));
                const Vec3 middle(0.5f), back(0.6f, 0.4f, 0.7f);
                const double angle = 2 * std::atan(1.2 / distance) * 180 / M_PI;  // the picture stays filled
                made.camera = camera_at(middle + back * float(distance + 1), middle, float(angle));
                return made;
            }};
}

}  // namespace kd

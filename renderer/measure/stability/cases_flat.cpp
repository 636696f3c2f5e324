// Scenes without thickness, almost without, and one upon another.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/measure/stability/case_pictures.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/overlap_shapes.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;

std::vector<Triangle> sheet_at(float z, int n) { return grid({0, 0, z}, {1, 0, 0}, {0, 1, 0}, n, n); }

/// Straight down or up at the unit square, begun 0.25 to 1 from z = `height`.
std::vector<Ray> straight_rays(Random& random, const std::vector<Triangle>& sheet, std::size_t count, float height) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const float side = random_sign(random);
        Vec3 o = random_point(random, 0, 1);
        if (i % 4 == 0) o = sheet[i % sheet.size()].corner[0];
        o.z = height + side * 0.25f * float(1 + random_below(random, 4));
        rays.push_back(ray_along(o, {0, 0, -side}));
    }
    return rays;
}

/// The same, held to brute force and, in t, to what they meet at z = `height` exactly.
void check_straight(CaseRun& run, const Subject& subject, std::size_t count, float height, float tolerance) {
    const std::vector<Ray> rays = straight_rays(run.random(), subject.scene.triangles, count, height);
    Expectation e;
    e.what = "straight: ";
    run.check(subject, rays, e);
    const auto judge = [&](std::size_t i, const Hit& hit, StabilityRow& row) {
        const float lost = std::abs(hit.t - std::abs(rays[i].origin.z - height));
        if (hit.triangle < 0 || !(lost <= tolerance))
            CaseRun::fail(row,
                          fmt::format("t off by {}: ray {}: found {}", lost, exact_text(rays[i]), exact_text(hit)));
    };
    run.each_answer(subject, rays, judge, CaseRun::Counted::by_check);
}

void run_flat(CaseRun& run) {
    const Subject flat = run.subject(sheet_at(0.5f, 200));
    // By costs: a builder that halves cells whatever is in them ends at the depth limit.
    const std::vector<int> depths = node_depths(run.subject(flat.scene, BuildConfig{}).tree);
    const int deepest = *std::ranges::max_element(depths);
    const double most = 8 + 1.3 * std::log2(double(flat.scene.triangles.size()));
    run.record("tree", 1, deepest <= most ? 0 : 1, fmt::format("depth {} of {:.0f}", deepest, most));
    // t is at most 1. All corners lie at one depth, so that sums above and below the quotient, and it, round by
    // gamma(6) at most, 3.6e-7; the worst of a million rays is off by 1.2e-7, half of this.
    check_straight(run, flat, run.rays(full), 0.5f, 0x1p-22f);
    const auto origin = [&] { return random_point(run.random(), -1, 2); };
    run.check(flat, rays_to_edges(run.random(), flat.scene.triangles, run.rays(full, 10), origin));
    run.check(flat, rays_to_vertices(run.random(), flat.scene.triangles, run.rays(full, 10), origin));
}

/// Rays within the plane that all triangles lie in.
void run_in_plane(CaseRun& run) {
    const Subject flat = run.subject(sheet_at(0, 200));
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < run.rays(full, 2); ++i) {
        Vec3 o = random_point(run.random(), -1, 2), d = random_direction(run.random());
        o.z = 0;
        d.z = i % 2 ? 0.0f : -0.0f;
        if (i % 4 < 2) d[int(i % 2)] = 0;  // along a row or column of the grid
        if (i % 3 == 0) o = flat.scene.triangles[i % flat.scene.triangles.size()].corner[0];
        rays.push_back(ray_along(o, d));
    }
    Expectation costly;  // they pass hundreds of cells each
    costly.costly = true;
    run.check(flat, rays, costly);

    const Subject tilted = run.subject(grid(Vec3(0.0f), {1, 0, 0.3f}, {0, 1, 0.7f}, 200, 200));
    const auto in_plane = [&] {
        const auto x = float(run.random().between(-1, 2)), y = float(run.random().between(-1, 2));
        return Vec3(x, y, 0.3f * x + 0.7f * y);
    };
    for (Ray& ray : rays) {
        const Vec3 o = in_plane();
        ray = ray_to(o, in_plane());
    }
    run.check(tilted, rays, costly);

    Camera camera;
    camera.eye = {0.5f, -1, 0};
    camera.target = {0.5f, 0.5f, 0};
    camera.up = {0, 0, 1};
    const int size = run.side(512) | 1;  // odd: the middle row lies in the plane
    check_picture(run, flat, camera, size, size);
}

/// Slanting and grazing ones in turn, at a terrain of this height.
std::vector<Ray> slanting_rays(Random& random, std::size_t count, double height) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 from = random_point(random, -0.5f, 1.5f), to = random_point(random, 0, 1);
        if (i % 2) from.z = float(random.between(-height, 2 * height));  // grazing
        to.z = float(random.between(0, height));
        rays.push_back(ray_to(from, to));
    }
    return rays;
}

void run_terrain(CaseRun& run) {
    const int cells = run.long_run() ? 708 : 400;
    const Subject land = run.subject(terrain(cells, 1e-7f, run.random()));
    // Of the heights, 1e-7, and gamma(6), 3.6e-7, the worst of a million rays uses 3.6e-7.
    check_straight(run, land, run.rays(full), 0, 4e-7f);
    run.check(land, slanting_rays(run.random(), run.rays(10'000), 1e-7));
}

/// Twice the same sheet: everywhere the one that comes first in the scene must be seen.
void run_coincident(CaseRun& run) {
    constexpr int cells = 20;
    std::vector<Triangle> twice = sheet_at(0.5f, cells);
    const std::size_t first = twice.size();
    for (const Triangle& t : sheet_at(0.5f, cells)) twice.push_back(t);
    FlatScene scene = bare_scene(twice);
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].diffuse = Vec3(1, 0, 0);
    for (std::size_t i = first; i < twice.size(); ++i) scene.attributes[i].material = 1;
    const Subject sheets = run.subject(scene);

    const auto origin = [&] { return random_point(run.random(), -1, 2); };
    const std::size_t count = run.rays(full, 3);
    std::vector<Ray> rays = rays_to_edges(run.random(), twice, count, origin);
    for (const Ray& ray : rays_to_vertices(run.random(), twice, count, origin)) rays.push_back(ray);
    while (rays.size() < 3 * count) {
        Vec3 to = random_point(run.random(), 0, 1);
        to.z = 0.5f;
        rays.push_back(ray_to(origin(), to));
    }
    const std::vector<Hit> expected = run.loop_hits(sheets.scene, rays);
    run.each_answer(sheets, rays, [&](std::size_t i, const Hit& hit, StabilityRow& row) {
        if (!bit_equal(hit, expected[i]) || hit.triangle >= int(first))
            CaseRun::fail(row, fmt::format("ray {}: expected {}; found {}", exact_text(rays[i]),
                                           exact_text(expected[i]), exact_text(hit)));
    });
}

}  // namespace

StabilityCase case_T07() {
    return {
        "T07",
        "All in one plane",
        "A sheet of 80,000 triangles at z = 0.5; rays straight at it, and a fifth as many to its edges and vertices",
        "brute force; exact for t of the straight ones",
        "every straight ray hits, t within 2^-22; 0 mismatches; depth at most 8 + 1.3 log2 N",
        run_flat};
}

StabilityCase case_T08() {
    return {"T08",
            "Inside the plane that all lies in",
            "The sheet of T07 at z = 0 with rays within z = 0 and a picture by a camera in it; the same sheet tilted, "
            "with as many rays as close to its plane as floats are",
            "brute force",
            "0 mismatches, no colour that is not finite",
            run_in_plane};
}

StabilityCase case_T29() {
    return {
        "T29",
        "Almost flat",
        "A terrain of 320,000 triangles (1,002,528 in a long run) of height 1e-7 over the unit square; rays straight "
        "at it, and 1000 slanting and grazing ones (10,000 in a long run)",
        "brute force; exact to the height for t of the straight ones",
        "every straight ray hits, t within 4e-7; 0 mismatches",
        run_terrain};
}

Sweep sweep_T29() {
    return {
        "T29",
        "height of the terrain",
        "sides",
        true,
        {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
        [](double height, std::size_t n, Random& random) {
            SweepScene made{terrain(60, float(height), random), {}, camera_at({0.5f, -0.9f, 0.6f}, {0.5f, 0.5f, 0})};
            made.camera.up = Vec3(0, 0, 1);
            made.rays = straight_rays(random, made.triangles, n / 2, 0);
            for (const Ray& ray : slanting_rays(random, n / 2, height)) made.rays.push_back(ray);
            return made;
        }};
}

StabilityCase case_T31() {
    return {"T31",
            "Two sheets in one place",
            "The same sheet of 800 triangles twice, in two materials; rays to insides, edges and vertices",
            "brute force; the sheet with the lower triangle numbers",
            "the same triangle in every variant, never one of the second sheet",
            run_coincident};
}

}  // namespace kd

// Triangles upon triangles: what makes trees explode and leaves overflow.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "renderer/gl/gl_limits.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/measure/stability/grouped_text.h"
#include "renderer/scene/overlap_shapes.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

std::vector<Ray> rays_across(Random& random, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i)
        rays.push_back(ray_to(random_point(random, -1, 2), random_point(random, 0, 1)));
    return rays;
}

constexpr std::size_t full = 1'000'000;

Expectation costly() {
    Expectation e;
    e.costly = true;
    return e;
}

/// Every answer is that of brute force; where the step budget of a shader cannot hold a leaf, rays may be given up.
Expectation within_budget(const Subject& subject) {
    Expectation e;
    e.what = fmt::format("{} triangles: ", subject.scene.triangles.size());
    e.may_give_up = subject.scene.triangles.size() >= std::size_t(gl_step_budget);
    return e;
}

/// Why T04 and T28 are exempt.
const std::string& leaf_exempt() {
    static const std::string text = fmt::format("on OpenGL a walk ends at its step budget ({}) in a leaf that holds "
                                                "more triangles than that; the answer may be wrong and is flagged",
                                                grouped_text(gl_step_budget));
    return text;
}

std::vector<Triangle> copies_of_one(std::size_t n) {
    return std::vector<Triangle>(n, Triangle{{Vec3(0, 0, 0), Vec3(1, 0.25f, 0.5f), Vec3(0.5f, 1, 1)}});
}

/// Rays that brute force answers in a second or so, whatever the scene.
std::size_t affordable(std::size_t rays, std::size_t triangles) {
    return std::min(rays, std::max<std::size_t>(20'000'000 / triangles, 20));
}

/// Most rays tests every copy, so that all of these take as long but the first, which has the full count.
void run_copies(CaseRun& run) {
    for (const std::size_t n : {1000u, 10'000u, 100'000u, 1'000'000u}) {
        const std::size_t rays = n == 1000 ? run.rays(full) : std::max<std::size_t>(run.rays(50 * full) / n, 20);
        const Subject copies = run.subject(copies_of_one(n));
        run.record("tree", 1, copies.tree.references.size() <= n ? 0 : 1,
                   fmt::format("{} references, {:.2g} s", copies.tree.references.size(), copies.built.seconds));
        run.check(copies, rays_across(run.random(), rays), within_budget(copies));
    }
}

std::string tree_text(const Subject& subject) {
    return fmt::format("{:.3g} references per triangle, {} nodes, {:.2g} s{}",
                       double(subject.tree.references.size()) / double(subject.scene.triangles.size()),
                       subject.tree.nodes.size(), subject.built.seconds,
                       subject.built.reference_cap_hit ? ", stopped by the reference cap" : "");
}

/// Under half the cap, a tree with fewer references was stopped by it and says so; one with as many was not.
bool tells_its_cap(CaseRun& run, const Subject& whole, BuildConfig config) {
    config.reference_cap /= 2;
    const Subject half = run.subject(whole.scene.triangles, config);
    const bool stopped = half.tree.references.size() < whole.tree.references.size();
    return half.built.reference_cap_hit == stopped && (half.built.reference_cap_hit || !whole.built.reference_cap_hit);
}

/// At most `cap` references per triangle, from the usual constants, from ones that try harder, and from a builder that
/// cuts blindly.
void check_growth(CaseRun& run, const std::vector<Triangle>& triangles, float cap, std::size_t all_rays) {
    BuildConfig patient, blind;
    patient.bad_refines = 3;
    blind.builder = "spatial-median";
    const std::array configs{BuildConfig{}, patient, blind};
    const std::vector<Ray> rays = rays_across(run.random(), run.rays(all_rays, configs.size()));
    Expectation e = costly();
    std::vector<Hit> expected;
    for (BuildConfig config : configs) {
        config.reference_cap = cap;
        const Subject subject = run.subject(triangles, config);
        const bool within = double(subject.tree.references.size()) <= double(cap) * double(triangles.size());
        const std::vector<int> depths = node_depths(subject.tree);
        const bool shallow = *std::ranges::max_element(depths) <= depth_limit(config, triangles.size());
        run.record("tree", 1, within && shallow ? 0 : 1, tree_text(subject));
        if (!tells_its_cap(run, subject, config)) run.record("tree", 1, 1, "the cap is not told as it was reached");
        if (expected.empty()) expected = run.loop_hits(subject.scene, rays);
        e.known = &expected;
        run.check(subject, rays, e);
    }
}

/// The first ones to the common vertex, where each tests every triangle; then to the rim, edges and insides.
std::vector<Ray> rays_at_fan(Random& random, const std::vector<Triangle>& fan, std::size_t count, std::size_t to_apex) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 origin = random_point(random, -2, 2);
        const auto& [apex, a, b] = random_triangle(random, fan).corner;
        const Vec3 targets[] = {a, glm::mix(apex, a, float(random.unit())), (apex + a + b) / 3.0f};
        rays.push_back(ray_to(origin, i < to_apex ? apex : targets[i % 3]));
    }
    return rays;
}

void run_fan(CaseRun& run) {
    for (const int n : {10'000, 100'000}) {
        const Subject fan = run.subject(vertex_fan(n));
        const std::vector<int> depths = node_depths(fan.tree);
        const bool shallow = *std::ranges::max_element(depths) <= depth_limit({}, std::size_t(n));
        run.record("tree", 1, shallow ? 0 : 1, tree_text(fan));
        // No plane parts a fan well: whatever passes it tests thousands, tens of thousands in the larger one.
        const bool small = n < gl_step_budget;
        const std::size_t count = small ? run.rays(full) : run.rays(full, 50);
        const std::vector<Ray> rays = rays_at_fan(run.random(), fan.scene.triangles, count, count / 50);
        Expectation e = within_budget(fan);
        e.costly = small;
        run.check(fan, rays, e);
    }
}

}  // namespace

StabilityCase case_T04() {
    static const std::string acceptance =
        fmt::format("0 mismatches, one reference per triangle; a shader whose step budget ({}) is below the leaf says "
                    "so for each ray",
                    grouped_text(gl_step_budget));
    return {
        "T04",
        "The same triangle again and again",
        "1e3, 1e4, 1e5 and 1e6 copies of one triangle (Embree's overlapping_primitives test); on 1e3 all the rays, on "
        "more 50,000,000 / n (a tenth unless in a long run), at least 20",
        "brute force",
        acceptance,
        run_copies,
        leaf_exempt()};
}

Sweep sweep_T04() {
    return {"T04",
            "copies of the triangle",
            "",
            true,
            {1, 10, 100, 1e3, 1e4, 3e4, 1e5},
            [](double count, std::size_t n, Random& random) {
                const auto copies = std::size_t(count);
                return SweepScene{copies_of_one(copies), rays_across(random, affordable(n, copies)),
                                  camera_at(Vec3(-0.5f, 0.5f, 2.2f), Vec3(0.5f, 0.5f, 0.5f), 40)};
            }};
}

StabilityCase case_T05() {
    return {"T05",
            "Triangles across the whole scene",
            "16,000 triangles from corner to corner of the unit cube, moved by up to 1 %; built with the usual "
            "constants and with 3 bad refines, and by spatial median; reference cap 8; 10,000 rays (100,000 in "
            "a long run), as each tests nearly all triangles",
            "brute force",
            "at most 8 references per triangle, reaching the cap is told; 0 mismatches",
            [](CaseRun& run) { check_growth(run, cube_spanning(16'000, 0.01f, run.random()), 8, full / 10); }};
}

StabilityCase case_T06() {
    return {"T06",
            "Boxes across boxes",
            "4000 boxes between random points of the unit cube (48,000 triangles); built as T05, "
            "reference cap 64",
            "brute force",
            "at most 64 references per triangle, reaching the cap is told; 0 mismatches",
            [](CaseRun& run) { check_growth(run, random_boxes(4000, run.random()), 64, full); }};
}

StabilityCase case_T28() {
    return {
        "T28",
        "All triangles at one vertex",
        "Fans of 10,000 and, for 2 % as many rays, 100,000 triangles around (0, 0, 1); one ray in 50 to the vertex, "
        "the others to the rim, edges and insides",
        "brute force",
        "0 mismatches, depth within its limit; a shader that cannot test all triangles at the vertex says so for "
        "each ray",
        run_fan,
        leaf_exempt()};
}

Sweep sweep_T28() {
    return {"T28",
            "triangles at the vertex",
            "",
            true,
            {3, 10, 32, 100, 316, 1e3, 3162, 1e4},
            [](double count, std::size_t n, Random& random) {
                SweepScene made{vertex_fan(int(count)), {}, camera_at(Vec3(1, 1.4f, 2), Vec3(0, 0, 0.4f), 45)};
                made.camera.up = Vec3(0, 0, 1);
                const std::size_t rays = affordable(n, std::size_t(count));
                made.rays = rays_at_fan(random, made.triangles, rays, rays / 4);
                return made;
            }};
}

}  // namespace kd

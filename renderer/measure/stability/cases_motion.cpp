// Scenes that move, and surfaces with holes: what a walk finds is that of this moment's triangles, and behind the
// holes.

#include <fmt/format.h>

#include "renderer/kdtree/refit.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/moving_scene.h"
#include "renderer/scene/procedural.h"

namespace kd {

namespace {

/// Each of the scenes at some times, of 4 s.
constexpr std::array moving{"sheet:2000", "ball:1000", "scatter:1000"};
constexpr std::array times{0.0, 0.7, 2.0, 3.3};

/// A third each to edges, to vertices and anywhere, from around the scene.
std::vector<Ray> rays_around(Random& random, const FlatScene& scene, std::size_t count) {
    const Vec3 centre = 0.5f * (scene.bounds.lower + scene.bounds.upper);
    const float reach = 0.5f * glm::length(scene.bounds.extent());
    const auto origin = [&] { return centre + reach * random_point(random, -1, 1); };
    std::vector<Ray> rays = rays_to_edges(random, scene.triangles, count / 3, origin);
    for (const Ray& ray : rays_to_vertices(random, scene.triangles, count / 3, origin)) rays.push_back(ray);
    while (rays.size() < count) rays.push_back(ray_along(origin(), random_direction(random)));
    return rays;
}

void run_poses(CaseRun& run) {
    std::int64_t refitted = 0, rebuilt = 0;
    for (const char* name : moving) {
        const MovingScene scene(*make_procedural(name));
        const Subject rest = run.subject(scene.at_rest());
        const BuildConfig build;
        for (const double time : times) {
            Subject pose = run.subject(scene.at(time));
            Expectation e;
            e.what = fmt::format("{} at {} s: ", name, time);
            const std::vector<Ray> rays =
                rays_around(run.random(), pose.scene, run.rays(1'000'000, 2 * moving.size() * times.size()));
            run.check(pose, rays, e);
            const auto tree = refit_tree(rest.tree, rest.scene.triangles.size(), pose.scene.triangles, build, {},
                                         nullptr, run.stop(), run.threads());
            run.check_stop();
            if (time > 0) ++(tree ? refitted : rebuilt);
            if (!tree) continue;
            pose.tree = *tree;
            e.what += "refitted: ";
            run.check(pose, rays, e);
        }
    }
    run.record("trees", refitted + rebuilt, refitted == 0,
               fmt::format("{} refitted, {} would have grown too much", refitted, rebuilt));
}

void run_holes(CaseRun& run) {
    const FlatScene scene = flatten(*make_procedural("topiary:1000"));
    const Subject leaves = run.subject(scene);
    const std::vector<Ray> rays = rays_around(run.random(), scene, run.rays(1'000'000));
    run.check(leaves, rays, {});
    FlatScene solid = scene;
    for (Material& material : solid.materials) material.alpha_cutoff = 0.0f;
    const std::vector<Hit> cut = run.loop_hits(scene, rays), whole = run.loop_hits(solid, rays);
    std::int64_t farther = 0, nearer = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        farther += cut[i].t > whole[i].t;
        nearer += cut[i].t < whole[i].t;
    }
    // Between a third and two thirds of a leaf's square are no leaf.
    const bool plausible = nearer == 0 && farther > std::int64_t(rays.size() / 20);
    run.record("holes", std::int64_t(rays.size()), plausible ? 0 : 1,
               fmt::format("{} rays go on behind a hole, {} end before it", farther, nearer));
}

}  // namespace

StabilityCase case_T64() {
    return {
        "T64",
        "Scenes that move",
        "The waves of a sheet, a ball that turns and triangles that fly apart, at four times each; rays to edges, to "
        "vertices and anywhere; trees built for the pose, and refitted from the scene at rest where that is allowed",
        "the loop over all triangles of that moment",
        "as brute force in every bit at every time; some tree of a later time is refitted",
        run_poses};
}

StabilityCase case_T65() {
    return {
        "T65",
        "Holes in triangles",
        "A thousand leaves that an image's alpha cuts out of squares; rays to edges, to vertices and anywhere",
        "the loop over all triangles, with the holes and without",
        "as brute force in every bit; no hit is nearer for the holes, and one ray in twenty or more goes through one",
        run_holes};
}

}  // namespace kd

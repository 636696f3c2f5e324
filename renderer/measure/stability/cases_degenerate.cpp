// Next to nothing to trace: no triangle, one, two that cannot be told apart, and triangles without an area.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;

/// Every answer is "no hit" and every pixel the background.
void run_empty(CaseRun& run) {
    const Subject nothing = run.subject(std::vector<Triangle>{});
    const bool one_leaf = nothing.tree.nodes.size() == 1 && nothing.tree.nodes[0].is_leaf();
    run.record("tree", 1, one_leaf && nothing.tree.references.empty() ? 0 : 1,
               fmt::format("{} nodes, {} references", nothing.tree.nodes.size(), nothing.tree.references.size()));

    std::vector<Ray> rays;
    for (std::size_t i = 0; i < run.rays(full); ++i)
        rays.push_back(ray_along(random_point(run.random(), -1, 1), random_direction(run.random())));
    std::vector<Hit> misses(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) misses[i] = {-1, KD_T_LIMIT, 0, 0};
    Expectation e;
    e.known = &misses;
    run.check(nothing, rays, e);

    run.each(nothing, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        const int size = run.side(512);
        const PinholeCamera camera = pinhole(nothing.scene.camera, size, size);
        const Frame frame = machine.frame(trace, camera, size, size, run.stop());
        row.n += std::int64_t(size) * size;
        for (const Vec4& pixel : frame.colour.pixels)
            if (pixel != Vec4(nothing.scene.background, 1.0f)) CaseRun::fail(row, "a pixel is not the background");
    });
}

/// What Embree's triangle_hit test asks of one triangle: u, v, t and the point within 16 ulp of 1.
void run_one_triangle(CaseRun& run) {
    constexpr float bound = 16 * 0x1p-23f;
    const Subject one = run.subject({{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}});
    std::vector<Ray> rays;
    while (rays.size() < run.rays(256)) {
        const Vec3 p(run.random().unit(), run.random().unit(), 0);
        if (p.x > 0 && p.y > 0 && p.x + p.y < 1) rays.push_back(ray_to({0, 0, -1}, p));
    }
    run.check(one, rays);
    double most = 0;
    const auto judge = [&](std::size_t i, const Hit& hit, StabilityRow& row) {
        const Vec3 target = rays[i].origin + rays[i].direction;
        const Vec3 along = rays[i].origin + hit.t * rays[i].direction;
        const Vec3 lost = glm::abs(along - Vec3(hit.u, hit.v, 0));
        const float worst = std::max(
            {std::abs(hit.u - target.x), std::abs(hit.v - target.y), std::abs(hit.t - 1), lost.x, lost.y, lost.z});
        most = std::max(most, double(worst) * 0x1p23);
        if (hit.triangle != 0 || !(worst <= bound))
            CaseRun::fail(row, fmt::format("off by {:.3g} ulp of 1: ray {}", worst * 0x1p23f, exact_text(rays[i])));
    };
    run.each_answer(one, rays, judge, CaseRun::Counted::by_check);
    run.record("u, v, t, point", std::int64_t(rays.size()), 0, fmt::format("at most {:.3g} ulp of 1 off", most));
}

void run_two_the_same(CaseRun& run) {
    const Triangle t{{Vec3(0, 0, 0), Vec3(1, 0.25f, 0.5f), Vec3(0.5f, 1, 1)}};
    std::vector<Ray> rays;
    constexpr std::array leaf_sizes{0, 1, 2};
    for (std::size_t i = 0; i < run.rays(full, builders().size() * leaf_sizes.size()); ++i)
        rays.push_back(ray_to(random_point(run.random(), -2, 2), random_point(run.random(), 0, 1)));
    for (const Builder& builder : builders())
        for (const int leaf_size : leaf_sizes) {
            BuildConfig config;
            config.builder = builder.name;
            config.leaf_size = leaf_size;
            const Subject twins = run.subject({t, t}, config);
            // What cuts blindly may cut here too, but not without end.
            const bool by_cost = builder.name == BuildConfig{}.builder;
            const std::size_t most = by_cost ? 1 : std::size_t(2) << depth_limit(config, 2);
            run.record("tree", 1, twins.tree.nodes.size() <= most ? 0 : 1,
                       fmt::format("{} with leaves of {}: {} nodes", builder.name, leaf_size, twins.tree.nodes.size()));
            run.check(twins, rays);
        }
}

/// A good triangle among three that have no area, as a file would bring them.
void run_without_area(CaseRun& run) {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 1, 1}, {3, 1, 1}, {3, 1, 1}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2, 3, 4, 5, 1, 1, 6, 0, 6, 7};  // collinear; one point; an index twice; good
    scene.meshes.push_back(mesh);
    scene.instances.push_back({});
    const Subject subject = run.subject(flatten(scene));
    const bool told = std::ranges::any_of(subject.scene.notes, [](const std::string& note) {
        return note.find("dropped 3 degenerate triangles") != std::string::npos;
    });
    run.record("flatten", 4, told && subject.scene.triangles.size() == 1 ? 0 : 1,
               fmt::format("{} of 4 triangles kept, {}", subject.scene.triangles.size(), told ? "told" : "not told"));

    std::vector<Ray> rays;
    for (std::size_t i = 0; i < run.rays(full); ++i) {
        const Vec3 target = i % 2 ? Vec3(float(run.random().between(0, 2))) : Vec3(3, 1, 1);
        const Vec3 aside = Vec3(2, -1, 3) + random_point(run.random(), -1, 1);  // the good triangle is not in the way
        Ray ray = ray_to(target + aside, target - aside * 0.01f);
        ray.t_max = 1;
        // Near the common corner of all, the good triangle is the one to hit.
        if (std::abs(ray.origin.z + ray.direction.z) >= 0.1f) rays.push_back(ray);
    }
    const std::vector<Hit> misses(rays.size(), Hit{-1, 1, 0, 0});
    Expectation e;
    e.known = &misses;
    e.what = "at what was dropped: ";
    run.check(subject, rays, e);
    for (Ray& ray : rays) ray = ray_to(random_point(run.random(), -2, 2), Vec3(0.25f, 0.25f, 0));
    run.check(subject, rays);
}

}  // namespace

StabilityCase case_T01() {
    return {"T01",
            "No triangle",
            "An empty scene; random rays and a picture",
            "exact: no hit, background everywhere",
            "0 hits, 0 other pixels, a tree of one leaf without references",
            run_empty};
}

StabilityCase case_T02() {
    return {"T02",
            "One triangle",
            "(0,0,0) (1,0,0) (0,1,0); 256 rays from (0,0,-1) to random points inside (Embree's triangle_hit test)",
            "exact; brute force",
            "every ray hits; u, v, t and the point within 16 ulp of 1 (1.9e-6)",
            run_one_triangle};
}

StabilityCase case_T03() {
    return {"T03",
            "Two triangles that nothing separates",
            "The same triangle twice, every builder, leaves of 0, 1 and 2 triangles",
            "brute force",
            "0 mismatches; the tree by costs is one leaf, others stay within their depth limit",
            run_two_the_same};
}

StabilityCase case_T26() {
    return {"T26",
            "Triangles without an area",
            "Corners on one line, three equal corners, an index twice, and one good triangle, loaded as from a file; "
            "rays at where the bad ones were and at the good one",
            "exact; brute force",
            "3 of 4 triangles dropped and told; no hit where they were",
            run_without_area};
}

}  // namespace kd

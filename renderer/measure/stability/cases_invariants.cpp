// What must not change: the answers when triangles, corners or axes are renamed, and what every tree promises.

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "renderer/kdtree/validate.h"
#include "renderer/measure/path_rays.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/overlap_shapes.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

using Order = std::vector<int>;

Order shuffled(Random& random, std::size_t n) {
    Order order(n);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.next() % i]);
    return order;
}

bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

struct Original {
    const FlatScene& scene;
    const std::vector<Ray>& rays;
    const std::vector<Hit>& hits;

    /// Whether ray `i` meets this triangle at the t of its own hit too, within `most_ulps`.
    [[nodiscard]] bool meets_at_its_t(std::size_t i, int triangle, double most_ulps) const {
        const Hit other = hit_of_triangle(scene, triangle, rays[i]);
        return other.triangle >= 0 && ulps_between(other.t, double(hits[i].t)) <= most_ulps;
    }
};

/// The hits on a renamed scene against those on the original: the same t in every bit (within `most_ulps`), and the
/// same triangle unless the ray meets both at that t. The worst difference of t, in ulp.
double compare_renamed(CaseRun& run, const Original& original, const Subject& renamed, const std::vector<Ray>& rays,
                       const Order& old_number, double most_ulps, const std::string& what) {
    double worst = 0;
    run.each_answer(renamed, rays, [&](std::size_t i, const Hit& hit, StabilityRow& row) {
        const Hit& before = original.hits[i];
        const int now = hit.triangle < 0 ? -1 : old_number[std::size_t(hit.triangle)];
        const bool hits_alike = (now >= 0) == (before.triangle >= 0);
        const double ulps = hits_alike ? ulps_between(hit.t, double(before.t)) : 0;
        worst = std::max(worst, ulps);
        const bool same_t = most_ulps == 0 ? same_bits(hit.t, before.t) : ulps <= most_ulps;
        const bool same_triangle = !hits_alike || now == before.triangle || original.meets_at_its_t(i, now, most_ulps);
        if (!hits_alike || !same_t || !same_triangle)
            CaseRun::fail(row, fmt::format("{}: ray {}: before {}; now triangle {}, {}", what, exact_text(rays[i]),
                                           exact_text(before), now, exact_text(hit)));
    });
    return worst;
}

Vec3 turned(Vec3 v) { return {v.y, v.z, v.x}; }

void run_renamed(CaseRun& run) {
    std::vector<Triangle> triangles = stress_sphere(40, 20);
    for (const Triangle& t : random_soup(400, 0.3f, run.random())) triangles.push_back(t);
    Camera camera;
    camera.eye = {1.7f, 0.9f, 2.3f};
    const int size = run.side(512);
    const std::vector<Ray> rays = pixel_rays(pinhole(camera, size, size), size, size);
    const Subject subject = run.subject(triangles);
    const std::vector<Hit> hits = run.loop_hits(subject.scene, rays);
    const Original original{subject.scene, rays, hits};

    Order order;
    std::vector<Triangle> renamed = triangles;
    for (int shuffle = 0; shuffle < 10; ++shuffle) {
        order = shuffled(run.random(), triangles.size());
        for (std::size_t i = 0; i < order.size(); ++i) renamed[i] = triangles[std::size_t(order[i])];
        (void)compare_renamed(run, original, run.subject(renamed), rays, order, 0, fmt::format("shuffle {}", shuffle));
    }
    std::iota(order.begin(), order.end(), 0);
    const auto flipped = [&](std::size_t a, std::size_t b) {
        renamed = triangles;
        for (Triangle& t : renamed) std::swap(t.corner[a], t.corner[b]);
        return run.subject(renamed);
    };
    (void)compare_renamed(run, original, flipped(0, 1), rays, order, 0, "first two corners exchanged");
    // Sums of three, above and below the quotient, round in another order: by gamma(2) each and both times, with the
    // quotients 10u, up to 10 ulp. This is twice the worst of three million rays, 4 ulp.
    const double moved = compare_renamed(run, original, flipped(1, 2), rays, order, 8, "last two corners exchanged");
    run.record("corners exchanged", std::int64_t(rays.size()), 0, fmt::format("t moves by up to {:.3g} ulp", moved));

    renamed = triangles;
    for (Triangle& t : renamed)
        for (Vec3& p : t.corner) p = turned(p);
    std::vector<Ray> turned_rays = rays;
    for (Ray& ray : turned_rays) ray = ray_along(turned(ray.origin), turned(ray.direction));
    (void)compare_renamed(run, original, run.subject(renamed), turned_rays, order, 0, "axes renamed");
}

struct NamedTriangles {
    std::string_view name;
    std::vector<Triangle> triangles;
};

std::vector<NamedTriangles> all_shapes(Random& random) {
    const Triangle one{{Vec3(0, 0, 0), Vec3(1, 0.25f, 0.5f), Vec3(0.5f, 1, 1)}};
    const Vec3 far_away(148376, 1234, -223423);
    return {
        {"nothing", {}},
        {"one", {one}},
        {"copies", std::vector<Triangle>(1000, one)},
        {"across the cube", cube_spanning(1000, 0.01f, random)},
        {"boxes", random_boxes(100, random)},
        {"sheet", grid({0, 0, 0.5f}, {1, 0, 0}, {0, 1, 0}, 50, 50)},
        {"terrain", terrain(50, 1e-7f, random)},
        {"voxel city", voxel_city(7)},
        {"sphere", stress_sphere(40, 20)},
        {"far sphere", stress_sphere(40, 20, 2.0f, far_away)},
        {"tiny sphere", scaled(stress_sphere(40, 20), 0x1p-40f)},
        {"huge sphere", scaled(stress_sphere(40, 20), 0x1p40f)},
        {"soup", random_soup(2000, 0.2f, random)},
        {"slivers", scaled(random_soup(1000, 1e-7f, random), 3.0f)},
        {"fan", vertex_fan(1000)},
    };
}

std::vector<BuildConfig> all_configs() {
    std::vector<BuildConfig> configs;
    for (const Builder& builder : builders())
        for (const bool trim : {true, false})
            for (const int leaf_size : {1, 8})
                for (const int bad_refines : {0, 3}) {
                    BuildConfig config;
                    config.builder = builder.name;
                    config.trim_leaves = trim;
                    config.leaf_size = leaf_size;
                    config.bad_refines = bad_refines;
                    config.reference_cap = 16;
                    configs.push_back(config);
                }
    return configs;
}

/// Every triangle stands in some leaf, and references, depth and all that validate() looks at are as promised.
void check_tree(CaseRun& run, std::string_view shape, const std::vector<Triangle>& triangles,
                const BuildConfig& config) {
    run.check_stop();
    const KdTree tree = build_tree(triangles, config, nullptr, {}, run.stop());
    run.check_stop();
    std::vector<std::string> wrong;
    for (const Violation& violation : validate(tree, triangles, 1)) wrong.push_back(violation.message);
    std::vector<std::int32_t> named = tree.references;
    std::ranges::sort(named);
    named.erase(std::unique(named.begin(), named.end()), named.end());
    if (named.size() != triangles.size()) wrong.push_back(fmt::format("{} triangles in leaves", named.size()));
    if (double(tree.references.size()) > double(config.reference_cap) * double(triangles.size()))
        wrong.emplace_back("reference cap exceeded");
    const std::vector<int> depths = node_depths(tree);
    if (*std::ranges::max_element(depths) > depth_limit(config, triangles.size())) wrong.emplace_back("too deep");
    run.record(config.builder, 1, wrong.empty() ? 0 : 1,
               wrong.empty() ? "" : fmt::format("{}: {}", shape, wrong.front()));
}

void run_all_trees(CaseRun& run) {
    const std::vector<NamedTriangles> shapes = all_shapes(run.random());
    for (const BuildConfig& config : all_configs())
        for (const NamedTriangles& shape : shapes) check_tree(run, shape.name, shape.triangles, config);
}

/// Small triangles between points of a 256^3 lattice: edges and centres of boxes lie where any regular bins would end.
std::vector<Triangle> triangles_on_integers(int n, Random& random) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < n; ++i) {
        const Vec3 at = glm::floor(random_point(random, 0, 249));
        Triangle t;
        for (Vec3& p : t.corner) p = at + 2.0f * glm::floor(random_point(random, 0, 4));
        triangles.push_back(t);
    }
    // The bounds are those of the lattice.
    triangles[0].corner = {Vec3(0.0f), Vec3(256.0f), Vec3(256, 0, 0)};
    return triangles;
}

void run_on_bin_edges(CaseRun& run) {
    const std::vector<NamedTriangles> shapes{
        {"sheet", grid(Vec3(0.0f), {256, 0, 0}, {0, 256, 0}, 256, 256)},
        {"lattice", triangles_on_integers(10'000, run.random())},
    };
    for (const BuildConfig& config : all_configs())
        for (const NamedTriangles& shape : shapes)
            if (config.trim_leaves && config.leaf_size == 1) check_tree(run, shape.name, shape.triangles, config);
    for (const Builder& builder : builders()) {
        BuildConfig config;
        config.builder = builder.name;
        config.bins = 256;  // planes on all the integers; check_tree() had them on every eighth
        const Subject lattice = run.subject(shapes[1].triangles, config);
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < run.rays(1'000'000, builders().size()); ++i) {
            const Vec3 from = glm::floor(random_point(run.random(), -8, 264));
            rays.push_back(ray_to(from, glm::floor(random_point(run.random(), 0, 256)) + 0.25f));
        }
        run.check(lattice, rays);
    }
}

}  // namespace

StabilityCase case_T52() {
    return {"T52",
            "Other names for the same scene",
            "A sphere amid 400 random triangles, seen by a camera: triangles in 10 other orders, corners wound the "
            "other way, axes x y z called y z x",
            "the answers before",
            "t equal in every bit; within 8 ulp where the last two corners change places, as sums of three then round"
            " otherwise",
            run_renamed};
}

StabilityCase case_T54() {
    return {"T54",
            "What every tree promises",
            "15 shapes of the other cases, every builder, 8 sets of constants; no rays",
            "validate(): cells tile, splits finite and inside, every triangle in every leaf that its surface passes "
            "through",
            "0 violations; references and depth within their limits",
            run_all_trees};
}

StabilityCase case_T55() {
    return {"T55",
            "Boxes that end on bin edges",
            "131,072 and 10,000 triangles with integer corners in [0, 256]^3, by every builder, with as many bins as "
            "integers and with fewer",
            "validate(); brute force",
            "0 violations, 0 mismatches",
            run_on_bin_edges};
}

}  // namespace kd

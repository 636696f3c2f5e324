// Axis-aligned geometry on integers: rays along split planes, inside them, and through where three of them meet.

#include <array>
#include <cmath>
#include <fmt/format.h>

#include "renderer/kdtree/validate.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

constexpr std::size_t full = 100'000;
constexpr int cells = 10;  // per axis

enum class Coordinates { off_lattice, integer };

/// Rays along an axis, from before, behind or inside the city. The other two components are `zero`.
std::vector<Ray> rays_along_axes(Random& random, std::size_t count, Coordinates coordinates, float zero) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const int axis = random_below(random, 3);
        Vec3 o = random_point(random, 0.01f, float(cells) - 0.01f);
        for (int a = 0; a < 3; ++a)
            o[a] = coordinates == Coordinates::integer ? std::round(o[a])
                                                       : std::floor(o[a]) + 0.1f + 0.8f * (o[a] - std::floor(o[a]));
        Vec3 d(zero);
        d[axis] = random_sign(random);
        if (i % 2 == 0) o[axis] = d[axis] > 0 ? -1.0f : float(cells) + 1.0f;
        rays.push_back(ray_along(o, d));
    }
    return rays;
}

/// Along space diagonals through integer points, from outside or inside.
std::vector<Ray> rays_along_diagonals(Random& random, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const float sx = random_sign(random), sy = random_sign(random);
        const Vec3 d(sx, sy, random_sign(random));
        const Vec3 corner = glm::floor(random_point(random, 0, float(cells) + 1));
        rays.push_back(ray_along(corner - d * (i % 2 ? float(cells) + 1.0f : 0.5f), d));
    }
    return rays;
}

/// Looks into the city along x or nearly so, its middle row and column of rays `offset` from planes of the lattice.
Camera along_x(Vec3 direction, float offset) {
    const Vec3 eye(-2, 5 + offset, 5 + offset);
    return camera_at(eye, eye + direction * 8.0f, 70);
}

bool is_cube(const std::array<int, 3>& c) {
    for (const int i : c)
        if (i < 0 || i >= cells) return false;
    return (7 * c[0] + 13 * c[1] + 5 * c[2]) % 3 == 0;
}

/// Distance of the first face that a ray along an axis meets between the planes of the lattice: where a cube begins or
/// ends. Negative for none.
double first_face(const Ray& ray) {
    const int axis = ray.direction.x != 0 ? 0 : ray.direction.y != 0 ? 1 : 2;
    const int step = ray.direction[axis] > 0 ? 1 : -1;
    std::array<int, 3> cell{int(std::floor(ray.origin.x)), int(std::floor(ray.origin.y)),
                            int(std::floor(ray.origin.z))};
    auto& along = cell[std::size_t(axis)];
    for (int i = 0; i < cells + 3; ++i) {
        const bool inside = is_cube(cell);
        const int face = step > 0 ? along + 1 : along;
        along += step;
        const double t = (double(face) - double(ray.origin[axis])) * step;
        if (t > 0 && (inside || is_cube(cell))) return t;
    }
    return -1;
}

void check_first_faces(CaseRun& run, const Subject& city, const std::vector<Ray>& rays) {
    const auto judge = [&](std::size_t i, const Hit& hit, StabilityRow& row) {
        const double exact = first_face(rays[i]);
        const bool found = hit.triangle >= 0;
        const double ulps = found && exact >= 0 ? ulps_between(hit.t, exact) : 0;
        if (found != (exact >= 0) || ulps > 4)
            CaseRun::fail(row,
                          fmt::format("exactly {}, found {}: ray {}", exact, exact_text(hit), exact_text(rays[i])));
    };
    run.each_answer(city, rays, judge, CaseRun::Counted::by_check);
}

enum class PlanarSide { below, above, both };

/// The tree of the city that is cut at every integer plane. Triangles in a plane go to the side asked for.
class LatticeTree {
  public:
    LatticeTree(const std::vector<Triangle>& triangles, PlanarSide side) : triangles_(triangles), side_(side) {}

    [[nodiscard]] KdTree grow() {
        KdTree tree;
        tree.nodes.clear();
        std::vector<Pending> pending(1);
        for (const Triangle& t : triangles_)
            for (const Vec3& p : t.corner) tree.bounds.include(p);
        pending[0].cell = tree.bounds;
        for (std::size_t i = 0; i < triangles_.size(); ++i) pending[0].list.push_back(int(i));
        while (!pending.empty()) {
            const Pending at = std::move(pending.back());
            pending.pop_back();
            const int number = int(tree.nodes.size());
            TreeNode& node = tree.nodes.emplace_back();
            node.parent = at.parent;
            if (at.is_above) tree.nodes[std::size_t(at.parent)].link = number;
            const Vec3 extent = at.cell.extent();
            const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
            if (extent[axis] <= 1 || at.list.empty()) {
                node.link = int(tree.references.size());
                node.count = int(at.list.size());
                tree.references.insert(tree.references.end(), at.list.begin(), at.list.end());
                continue;
            }
            node.flag = axis;
            node.split = std::floor(at.cell.centre()[axis]);
            pending.push_back(child(at, number, axis, node.split, true));
            pending.push_back(child(at, number, axis, node.split, false));
        }
        return tree;
    }

  private:
    struct Pending {
        Aabb cell;
        std::vector<int> list;
        int parent = -1;
        bool is_above = false;
    };

    [[nodiscard]] bool belongs(int triangle, int axis, float split, bool above) const {
        const Aabb box = bounds_of(triangles_[std::size_t(triangle)]);
        if (box.lower[axis] < split || box.upper[axis] > split)
            return above ? box.upper[axis] > split : box.lower[axis] < split;
        return side_ == PlanarSide::both || (side_ == PlanarSide::above) == above;
    }

    [[nodiscard]] Pending child(const Pending& of, int number, int axis, float split, bool above) const {
        Pending made{of.cell, {}, number, above};
        (above ? made.cell.lower : made.cell.upper)[axis] = split;
        for (const int t : of.list)
            if (belongs(t, axis, split, above)) made.list.push_back(t);
        return made;
    }

    const std::vector<Triangle>& triangles_;
    PlanarSide side_;
};

void run_planar_sides(CaseRun& run) {
    std::vector<Ray> rays = rays_along_axes(run.random(), run.rays(full) / 2, Coordinates::off_lattice, 0.0f);
    for (const Ray& ray : rays_along_axes(run.random(), run.rays(full) / 2, Coordinates::integer, 0.0f))
        rays.push_back(ray);
    for (const Ray& ray : rays_along_diagonals(run.random(), run.rays(full))) rays.push_back(ray);
    Subject city = run.subject(voxel_city(cells));
    const std::vector<Hit> hits = run.loop_hits(city.scene, rays);
    constexpr std::array sides{PlanarSide::below, PlanarSide::above, PlanarSide::both};
    constexpr std::array names{"below: ", "above: ", "both: "};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        city.tree = LatticeTree(city.scene.triangles, sides[i]).grow();
        const auto violations = validate(city.tree, city.scene.triangles, 1);
        run.record("tree", 1, std::int64_t(violations.size()),
                   violations.empty() ? fmt::format("{}{} references", names[i], city.tree.references.size())
                                      : violations[0].message);
        Expectation e;
        e.known = &hits;
        e.what = names[i];
        run.check(city, rays, e);
    }
}

void run_negative_zero(CaseRun& run) {
    const Subject city = run.subject(voxel_city(cells));
    for (const Coordinates coordinates : {Coordinates::off_lattice, Coordinates::integer}) {
        std::vector<Ray> rays = rays_along_axes(run.random(), run.rays(full) / 2, coordinates, 0.0f);
        run.check(city, rays);
        const std::vector<Hit> hits = run.loop_hits(city.scene, rays);
        for (Ray& ray : rays)
            for (int axis = 0; axis < 3; ++axis)
                if (ray.direction[axis] == 0) ray.direction[axis] = -0.0f;
        Expectation e;
        e.known = &hits;
        e.what = "-0: ";
        run.check(city, rays, e);
    }
}

}  // namespace

StabilityCase case_T09() {
    return {"T09",
            "Along axes through a voxel city",
            "A city of unit cubes on integers (4008 triangles), rays along axes between the planes of the lattice",
            "exact, by stepping from cube to cube; brute force",
            "0 mismatches, t within 4 ulp of exact",
            [](CaseRun& run) {
                const Subject city = run.subject(voxel_city(cells));
                const auto rays = rays_along_axes(run.random(), run.rays(full), Coordinates::off_lattice, 0.0f);
                run.check(city, rays);
                check_first_faces(run, city, rays);
            }};
}

StabilityCase case_T10() {
    return {"T10",
            "Inside the planes of a voxel city",
            "The city of T09, rays along axes with integer coordinates: along the edges of cubes, inside split planes",
            "brute force",
            "0 mismatches",
            [](CaseRun& run) {
                const Subject city = run.subject(voxel_city(cells));
                run.check(city, rays_along_axes(run.random(), run.rays(full), Coordinates::integer, 0.0f));
            }};
}

Sweep sweep_T10() {
    return {"T10",
            "distance from the planes",
            "cubes",
            true,
            {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            [](double offset, std::size_t n, Random& random) {
                SweepScene made{voxel_city(cells), rays_along_axes(random, n, Coordinates::integer, 0.0f), {}};
                for (Ray& ray : made.rays) ray.origin += (1.0f - glm::abs(ray.direction)) * float(offset);
                made.camera = along_x(Vec3(1, 0, 0), float(offset));
                return made;
            }};
}

StabilityCase case_T11() {
    return {"T11",
            "Negative zero",
            "The rays of T09 and T10 with +0, then with -0 in their two zero components",
            "brute force; the answers to +0",
            "0 mismatches, the same bits for both zeros",
            run_negative_zero};
}

Sweep sweep_T11() {
    return {"T11",
            "other components, negative",
            "of the largest",
            true,
            {1e-45, 1e-40, 1e-35, 1e-30, 1e-25, 1e-20, 1e-15, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2},
            [](double tilt, std::size_t n, Random& random) {
                const auto small = float(-tilt);
                return SweepScene{voxel_city(cells), rays_along_axes(random, n, Coordinates::integer, small),
                                  along_x(Vec3(1, small, small), 0)};
            }};
}

StabilityCase case_T12() {
    return {"T12",
            "Diagonals of a voxel city",
            "The city of T09, rays along (+-1, +-1, +-1) through corners of the lattice: three planes at one t",
            "brute force",
            "0 mismatches",
            [](CaseRun& run) {
                const Subject city = run.subject(voxel_city(cells));
                run.check(city, rays_along_diagonals(run.random(), run.rays(full)));
            }};
}

Sweep sweep_T12() {
    return {"T12",
            "distance from the corners",
            "cubes",
            true,
            {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            [](double offset, std::size_t n, Random& random) {
                SweepScene made{voxel_city(cells), rays_along_diagonals(random, n), {}};
                for (Ray& ray : made.rays) ray.origin += random_direction(random) * float(offset);
                const Vec3 eye = Vec3(-4.0f) + Vec3(float(offset), 0, -float(offset));
                made.camera = camera_at(eye, eye + 8.0f, 50);
                return made;
            }};
}

StabilityCase case_T13() {
    return {
        "T13",
        "Triangles in split planes",
        "The city cut at every plane of its lattice, triangles in a plane given to the cell below, above, or both; the "
        "rays of T09, T10 and T12",
        "brute force",
        "0 mismatches for each of the three trees",
        run_planar_sides};
}

}  // namespace kd

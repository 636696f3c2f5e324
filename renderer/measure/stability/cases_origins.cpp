// Rays that begin where nothing may be decided by a hair: on split planes, on the scene's box, in triangles.

#include <array>
#include <fmt/format.h>

#include "renderer/measure/stability/case_pictures.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/overlap_shapes.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;

float signed_zero(Random& random) { return 0.0f * random_sign(random); }

/// One component +-1, the others zeros of either sign.
Vec3 axis_direction(Random& random, int axis) {
    const float x = signed_zero(random), y = signed_zero(random);
    Vec3 d(x, y, signed_zero(random));
    d[axis] = random_sign(random);
    return d;
}

/// The faces of a box with small triangles inside.
std::vector<Triangle> filled_box(const Aabb& box, Random& random) {
    std::vector<Triangle> triangles = box_faces(box);
    for (Triangle t : random_soup(200, 0.1f, random)) {
        for (Vec3& p : t.corner) p = glm::clamp(box.lower + p * box.extent(), box.lower, box.upper);
        triangles.push_back(t);
    }
    return triangles;
}

constexpr const char* middle_cutter = "spatial-median";  // cuts the unit cube at x = 0.5 first

std::vector<Triangle> filled_cube(Random& random) { return filled_box({Vec3(0.0f), Vec3(1.0f)}, random); }

/// From x = 0.5: along x, along another axis, within the plane, and anywhere.
std::vector<Ray> rays_from_split_plane(Random& random, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 o = random_point(random, 0, 1), d = random_direction(random);
        o.x = 0.5f;
        if (i % 4 == 0) d = axis_direction(random, 0);
        if (i % 4 == 1) d = axis_direction(random, 1 + random_below(random, 2));
        if (i % 4 == 2) d.x = signed_zero(random);
        rays.push_back(ray_along(o, d));
    }
    return rays;
}

void run_on_split_plane(CaseRun& run) {
    BuildConfig config;
    config.builder = middle_cutter;
    const Subject cube = run.subject(filled_cube(run.random()), config);
    const TreeNode& root = cube.tree.nodes[0];
    run.record("tree", 1, root.flag == 0 && root.split == 0.5f ? 0 : 1,
               fmt::format("root cut at {} on axis {}", root.split, root.flag));
    run.check(cube, rays_from_split_plane(run.random(), run.rays(full)));
}

/// Boxes whose corners no short binary number says, so that slabs meet at values that round.
std::vector<Aabb> odd_boxes(Random& random) {
    std::vector<Aabb> boxes{{Vec3(0.0f), Vec3(1.0f)}, {Vec3(0.1f, -0.7f, 1.0f / 3), Vec3(0.3f, 0.9f, 2.0f / 3)}};
    while (boxes.size() < 8) {
        Aabb box;
        box.include(random_point(random, -10, 10));
        box.include(box.lower + random_point(random, 0.1f, 5));
        boxes.push_back(box);
    }
    return boxes;
}

Vec3 random_corner(Random& random, const Aabb& box) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random_sign(random) > 0 ? box.upper[axis] : box.lower[axis];
    return p;
}

Vec3 point_inside(Random& random, const Aabb& box) {
    return glm::clamp(box.lower + random_point(random, 0, 1) * box.extent(), box.lower, box.upper);
}

/// From a corner, on a face, on a face's plane outside the box, or grazing a face.
Ray ray_at_box(Random& random, const Aabb& box, std::size_t family) {
    const int axis = random_below(random, 3), other = (axis + 1) % 3;
    const Vec3 corner = random_corner(random, box), inside = point_inside(random, box);
    Vec3 on_face = inside;
    on_face[axis] = corner[axis];
    Vec3 beside = on_face;
    beside[other] = corner[other] + (corner[other] == box.lower[other] ? -1.0f : 1.0f) * box.extent()[other];
    switch (family % 6) {
        case 0: return ray_along(corner, random_direction(random));
        case 1: return ray_to(corner, inside);
        case 2: return ray_along(on_face, random_direction(random));
        case 3: return ray_along(on_face, axis_direction(random, random_below(random, 3)));
        case 4: return ray_to(beside, on_face);                      // within the plane of the face
        default: return ray_to(beside + (corner - inside), corner);  // t0 == t1 up to rounding
    }
}

/// From outside along an edge: two slabs are met at their planes exactly, for the whole ray.
Ray ray_along_edge(Random& random, const Aabb& box) {
    const int axis = random_below(random, 3);
    const Vec3 d = axis_direction(random, axis) * float(random.between(0.1, 10));
    Vec3 o = random_corner(random, box);
    o[axis] = (d[axis] > 0 ? box.lower : box.upper)[axis] - d[axis] * float(random.between(0.1, 3));
    return ray_along(o, d);
}

template <class Make>
void check_boxes(CaseRun& run, const Make& make) {
    const std::vector<Aabb> boxes = odd_boxes(run.random());
    for (const Aabb& box : boxes) {
        const Subject subject = run.subject(filled_box(box, run.random()));
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < run.rays(full, boxes.size()); ++i) rays.push_back(make(subject.tree.bounds, i));
        run.check(subject, rays);
    }
}

/// Anywhere in the plane of a triangle, as well as it can be said in floats.
Vec3 point_in_plane(Random& random, const Triangle& t) {
    const auto u = float(random.between(-1, 2)), v = float(random.between(-1, 2));
    return t.corner[0] + (t.corner[1] - t.corner[0]) * u + (t.corner[2] - t.corner[0]) * v;
}

void run_eyes_on_surfaces(CaseRun& run) {
    const Subject ball = run.subject(stress_sphere(80, 40));
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < run.rays(full); ++i) {
        const Triangle& t = random_triangle(run.random(), ball.scene.triangles);
        const Vec3 vertex = t.corner[i % 3], in_plane = point_in_plane(run.random(), t);
        rays.push_back(i % 2 ? ray_along(vertex, random_direction(run.random()))
                             : ray_to(in_plane, point_in_plane(run.random(), t)));
    }
    run.check(ball, rays);
    const Triangle& t = ball.scene.triangles[3000];
    const int size = run.side(512);
    check_picture(run, ball, camera_at(t.corner[0], Vec3(0.1f, 0.2f, 0), 90), size, size);
    check_picture(run, ball, camera_at((t.corner[0] + t.corner[1]) * 0.5f, t.corner[2], 90), size, size);

    const int n = run.long_run() ? 1'000'000 : 100'000;
    const Subject soup = run.subject(random_soup(n, 0.01f, run.random()));
    const Vec3 centre = soup.tree.bounds.centre();
    check_picture(run, soup, camera_at(centre, centre + Vec3(0, 0, 1), 90), size, size);
}

}  // namespace

StabilityCase case_T32() {
    return {"T32",
            "Origins on a split plane",
            "A unit cube of 212 triangles, cut at x = 0.5 first; origins at x = 0.5, directions along axes with zeros"
            " of both signs, within the plane, and random",
            "brute force",
            "0 mismatches",
            run_on_split_plane};
}

Sweep sweep_T32() {
    return {"T32",
            "distance from the plane",
            "cubes",
            true,
            {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            [](double offset, std::size_t n, Random& random) {
                const auto x = float(0.5 + offset);
                SweepScene made{filled_cube(random), rays_from_split_plane(random, n),
                                camera_at(Vec3(x, 0.5f, 0.98f), Vec3(x, 0.5f, 0), 80), true};
                for (Ray& ray : made.rays) ray.origin.x = x;
                made.build.builder = middle_cutter;
                return made;
            }};
}

StabilityCase case_T33() {
    return {"T33",
            "Origins on the scene's box",
            "8 boxes of 212 triangles; rays from corners, from faces, within the planes of faces, and from outside "
            "past corners",
            "brute force",
            "0 mismatches",
            [](CaseRun& run) {
                check_boxes(run, [&](const Aabb& box, std::size_t i) { return ray_at_box(run.random(), box, i); });
            }};
}

StabilityCase case_T34() {
    return {"T34",
            "Along an edge of the scene's box",
            "The boxes of T33, rays from outside exactly along edges",
            "brute force",
            "0 mismatches",
            [](CaseRun& run) {
                check_boxes(run, [&](const Aabb& box, std::size_t) { return ray_along_edge(run.random(), box); });
            }};
}

StabilityCase case_T57() {
    return {"T57",
            "Eyes on surfaces and amid everything",
            "A sphere of 6240 triangles: rays and pictures from vertices and from inside the planes of triangles; a "
            "picture from the centre of 100,000 random triangles (1,000,000 in a long run)",
            "brute force",
            "0 mismatches, no colour that is not finite",
            run_eyes_on_surfaces};
}

Sweep sweep_T57() {
    return {"T57",
            "height above the triangle",
            "radii",
            true,
            {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            [](double height, std::size_t n, Random& random) {
                SweepScene made{stress_sphere(80, 40), {}, {}};
                const auto towards_centre = [&](Vec3 p) { return p * float(1 - height); };
                for (std::size_t i = 0; i < n; ++i) {
                    const Vec3 p = point_in(random, random_triangle(random, made.triangles));
                    made.rays.push_back(ray_along(towards_centre(p), random_direction(random)));
                }
                const Triangle& t = made.triangles[3000];
                made.camera = camera_at(towards_centre((t.corner[0] + t.corner[1]) * 0.5f), t.corner[2], 90);
                return made;
            }};
}

}  // namespace kd

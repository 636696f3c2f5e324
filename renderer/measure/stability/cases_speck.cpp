// Something very small in the middle of something very large.

#include <algorithm>
#include <fmt/format.h>

#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

constexpr float speck_radius = 1e-3f;
constexpr int room_triangles = 12;

/// A closed room of these triangles, which come last, around a sphere of 2 x columns x rows of them.
std::vector<Triangle> speck_in_room(int columns, int rows, float half) {
    std::vector<Triangle> room = stress_sphere(columns, rows + 1, speck_radius);
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-half, half}) {
            Vec3 corner(-half), u(0.0f), v(0.0f);
            corner[axis] = side;
            u[(axis + 1) % 3] = 2 * half;
            v[(axis + 2) % 3] = 2 * half;
            for (const Triangle& t : grid(corner, u, v, 1, 1)) room.push_back(t);
        }
    return room;
}

Camera camera_of_speck() { return camera_at(Vec3(1, 0.7f, 1.4f) * 2.0f * speck_radius, Vec3(0.0f)); }

/// To within the speck, from within `reach` of it along each axis.
Ray ray_at_speck(Random& random, float reach) {
    const Vec3 eye = random_point(random, -reach, reach);
    return ray_to(eye, random_point(random, -speck_radius, speck_radius));
}

/// Of the sphere's pixels, those that single and double precision see differently.
struct PictureDifferences {
    std::int64_t of_sphere = 0, at_outline = 0, elsewhere = 0;
};

/// A pixel is at the sphere's outline where the outline lies between it and one of its eight neighbours.
class Outline {
  public:
    Outline(const std::vector<f64::Hit>& exact, int size, int sphere_triangles)
        : exact_(exact), size_(size), sphere_triangles_(sphere_triangles) {}

    [[nodiscard]] bool on_sphere(int pixel) const {
        const int triangle = exact_[std::size_t(pixel)].triangle;
        return triangle >= 0 && triangle < sphere_triangles_;
    }
    [[nodiscard]] bool is_near(int pixel) const {
        const int x = pixel % size_, y = pixel / size_;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size_ - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size_ - 1); ++i)
                if (on_sphere(j * size_ + i) != on_sphere(pixel)) return true;
        return false;
    }

  private:
    const std::vector<f64::Hit>& exact_;
    int size_, sphere_triangles_;
};

PictureDifferences differences(const std::vector<Hit>& found, const std::vector<f64::Hit>& exact,
                               const Outline& outline) {
    PictureDifferences all;
    for (std::size_t i = 0; i < found.size(); ++i) {
        all.of_sphere += outline.on_sphere(int(i));
        const HitVerdict verdict = HitJudge{}.judge(found[i], exact[i]).verdict;
        if (verdict == HitVerdict::agrees) continue;
        (outline.is_near(int(i)) ? all.at_outline : all.elsewhere) += 1;
    }
    return all;
}

/// The sphere from near: brute force sees what double precision sees, but for pixels at the sphere's outline, and every
/// walk finds what brute force finds. A walk takes milliseconds here, so that every 101st pixel is walked to.
void check_picture_of_speck(CaseRun& run, const Subject& subject, const Camera& camera) {
    const int size = run.side(512);
    const std::vector<Ray> rays = pixel_rays(pinhole(camera, size, size), size, size);
    const ReferenceRays seen{rays, run.loop_hits(subject.scene, rays)};
    const std::vector<f64::Hit> exact = run.exact_hits(subject.scene, rays);
    const int sphere_triangles = int(subject.scene.triangles.size()) - room_triangles;
    const PictureDifferences d = differences(seen.expected, exact, Outline(exact, size, sphere_triangles));
    run.record("picture", std::int64_t(rays.size()), d.elsewhere,
               fmt::format("{} pixels of the sphere; unlike double precision {} at its outline, {} elsewhere",
                           d.of_sphere, d.at_outline, d.elsewhere));
    const ReferenceRays walked = seen.every(101);
    Expectation e;
    e.known = &walked.expected;
    e.every_ray_hits = true;
    e.what = "picture: ";
    run.check(subject, walked.rays, e);
}

void run_speck_in_room(CaseRun& run) {
    constexpr float half = 5e3f;
    const Subject subject = run.subject(speck_in_room(100, 50, half));
    std::vector<Ray> near, across;
    for (std::size_t i = 0; i < run.rays(10'000, 2); ++i) {
        near.push_back(ray_at_speck(run.random(), 4 * speck_radius));
        across.push_back(ray_at_speck(run.random(), half));
    }
    Expectation e;
    e.every_ray_hits = true;
    e.what = "across the room: ";
    run.check(subject, across, e);
    e.against_double = HitJudge{};  // some graze the sphere; the worst of 5000 rays is 8.6 ulp
    e.what = "near the sphere: ";
    run.check(subject, near, e);
    check_picture_of_speck(run, subject, camera_of_speck());
}

}  // namespace

StabilityCase case_T24() {
    return {
        "T24",
        "Teapot in a stadium",
        "A sphere of 10,000 triangles and radius 0.001 in the middle of a room of size 10,000; 1000 rays (10,000 in a "
        "long run) from near the sphere and from across the room; a picture of the sphere from near",
        "brute force; double precision for rays and picture from near",
        "0 mismatches, every ray hits, t within 64 ulp; in the picture no pixel sees another triangle than double "
        "precision does, but where the sphere's outline is a pixel or less away",
        run_speck_in_room,
        "a ray's slack is a fraction of the whole room and larger than the sphere, so that a walk visits every "
        "cell around it; on OpenGL some need more steps than a shader is sure of and are flagged, never silently "
        "wrong"};
}

Sweep sweep_T24() {
    return {"T24",
            "size of the room",
            "spheres",
            true,
            {10, 100, 1e3, 1e4, 1e5, 1e6, 1e7},
            [](double ratio, std::size_t n, Random& random) {
                const auto half = float(ratio) * speck_radius;
                SweepScene made{speck_in_room(50, 25, half), {}, {}, true};
                for (std::size_t i = 0; i < std::min<std::size_t>(n, 1000); ++i)
                    made.rays.push_back(ray_at_speck(random, i % 2 ? half : 4 * speck_radius));
                made.camera = camera_of_speck();
                return made;
            }};
}

}  // namespace kd

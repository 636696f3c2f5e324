// Cameras and long runs.

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "renderer/measure/path_rays.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/process_memory.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

/// The direction of a pixel's ray, in double from the camera itself.
glm::dvec3 exact_direction(const Camera& camera, double x, double y, int width, int height) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double half = std::tan(0.5 * glm::radians(double(camera.fov_y_degrees)));
    const double sx = (2 * (x + 0.5) / width - 1) * half * width / height, sy = (1 - 2 * (y + 0.5) / height) * half;
    return glm::normalize(forward + sx * right + sy * up);
}

struct View {
    float fov;
    int width, height;
};

/// A million pixels in all with --long, and at least a tenth otherwise: the long frames stay as they are.
std::vector<View> views(const CaseRun& run) {
    const int side = run.side(692);
    return {{1e-3f, side, side}, {179.9f, side, side}, {45, 1, 10'000},  {45, 10'000, 1},  {45, 1, 1},
            {45, 1, 77},         {45, 8193, 1},        {1e-3f, 8193, 1}, {179.9f, 1, 8193}};
}

void run_view(CaseRun& run, const Subject& ball, const View& view) {
    Camera camera = ball.scene.camera;
    camera.fov_y_degrees = view.fov;
    const PinholeCamera lens = pinhole(camera, view.width, view.height);
    double worst = 0;
    for (int i = 0; i < view.width * view.height; ++i) {
        const int x = i % view.width, y = i / view.width;
        const Ray ray = pixel_ray(lens, x, y, view.width, view.height);
        const glm::dvec3 error = glm::dvec3(ray.direction) - exact_direction(camera, x, y, view.width, view.height);
        worst = std::max(worst, std::max({std::abs(error.x), std::abs(error.y), std::abs(error.z)}) / 0x1p-24);
    }
    const std::string name = fmt::format("{} degrees, {}x{}", view.fov, view.width, view.height);
    run.record("direction", view.width * view.height, worst <= 4 ? 0 : 1,
               worst <= 4 ? "" : fmt::format("{}: {:.2g} ulp", name, worst));
    const std::vector<Ray> rays = pixel_rays(lens, view.width, view.height);
    const std::vector<Hit> expected = run.loop_hits(ball.scene, rays);
    run.each(ball, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        const Frame frame = machine.frame(trace, lens, view.width, view.height, run.stop());
        run.check_stop();
        const std::vector<Hit>& hits = frame.layer(Pass::rt_prim).hit.pixels;
        row.n += std::int64_t(rays.size());
        CaseRun::tell_error_of_t(ball.scene, rays, hits, row);
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (!bit_equal(hits[i], expected[i]))
                CaseRun::fail(row, fmt::format("{}: ray {}: expected {}, found {}", name, exact_text(rays[i]),
                                               exact_text(expected[i]), exact_text(hits[i])));
    });
}

void run_views(CaseRun& run) {
    const Subject ball = run.subject(stress_sphere(20, 10));
    for (const View& view : views(run)) run_view(run, ball, view);
    int accepted = 0;
    for (const float fov : {179.99f, 180.0f, 0.0f, -1.0f, std::nanf("")}) {
        Camera camera = ball.scene.camera;
        camera.fov_y_degrees = fov;
        accepted += is_valid(camera);
    }
    run.record("refused", 5, accepted, accepted > 0 ? "an angle that cannot be used was accepted" : "");
}

void run_parallel_up(CaseRun& run) {
    std::int64_t wrong = 0;
    const std::size_t count = run.rays(1'000'000);
    for (std::size_t i = 0; i < count; ++i) {
        Camera camera;
        camera.eye = random_point(run.random(), -10, 10);
        const Vec3 view = i % 7 < 3 ? Vec3(i % 7 == 0, i % 7 == 1, i % 7 == 2) * random_sign(run.random())
                                    : random_direction(run.random());
        camera.target = camera.eye + view;
        camera.up = i % 5 == 0 ? Vec3(0.0f) : (camera.target - camera.eye) * random_sign(run.random()) * 3.0f;
        const PinholeCamera lens = pinhole(camera, 100, 100);
        const double half = std::tan(0.5 * glm::radians(double(camera.fov_y_degrees)));
        const glm::dvec3 f(lens.forward), r = glm::dvec3(lens.right) / half, u = glm::dvec3(lens.up) / half;
        const double worst =
            std::max({std::abs(glm::dot(f, r)), std::abs(glm::dot(f, u)), std::abs(glm::dot(r, u)),
                      std::abs(glm::length(f) - 1), std::abs(glm::length(r) - 1), std::abs(glm::length(u) - 1)});
        wrong += !(worst <= 1e-6);
    }
    run.record("basis", std::int64_t(count), wrong, wrong > 0 ? "right, up and forward are not at right angles" : "");
}

void run_long(CaseRun& run) {
    constexpr int size = 8, frames_per_turn = 100;
    const Subject ball = run.subject(stress_sphere(20, 10));
    run.each(ball, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        const auto lens = [&](int frame) {
            const double turn = 2 * M_PI * (frame % frames_per_turn) / frames_per_turn;
            Camera camera = ball.scene.camera;
            camera.eye = Vec3(float(3 * std::cos(turn)), 1, float(3 * std::sin(turn)));
            return pinhole(camera, size, size);
        };
        const auto at = [&](int frame) {
            run.check_stop();
            return machine.frame(trace, lens(frame), size, size, run.stop());
        };
        const Frame first = at(0);
        for (int i = 0; i < frames_per_turn; ++i)  // until caches are full
            CaseRun::tell_error_of_t(ball.scene, pixel_rays(lens(i), size, size), at(i).layer(Pass::rt_prim).hit.pixels,
                                     row);
        const std::optional<std::int64_t> before = resident_bytes();
        const int objects = machine.live_objects();
        const int frames = int(run.rays(100'000)) / frames_per_turn * frames_per_turn;
        for (int i = 0; i < frames; ++i)
            if (const Frame frame = at(i); i % frames_per_turn == 0 && !same_frame(first, frame))
                CaseRun::fail(row, fmt::format("frame {} is not the first again", i));
        row.n += frames;
        const std::optional<std::int64_t> after = resident_bytes();
        if (!before || !after)
            row.reason = row.mismatches > 0 ? row.reason : "memory not measured";
        else if (const std::int64_t grown = *after - *before; grown >= 1 << 20)
            CaseRun::fail(row, fmt::format("memory grew by {} bytes over {} frames", grown, frames));
        if (const int left = machine.live_objects() - objects; left != 0)
            CaseRun::fail(row, fmt::format("{} OpenGL objects were left behind", left));
    });
}

}  // namespace

StabilityCase case_T58() {
    return {"T58",
            "Angles of view and shapes of frames",
            "0.001 and 179.9 degrees in frames of 219x219 (692x692 in a long run) and 8193 pixels; frames of 1x1, "
            "1x77, 8193x1, 10,000x1 and 1x10,000",
            "directions in double precision; brute force",
            "directions within 4 ulp of 1 per component, 0 mismatches, 179.99 and 180 degrees refused",
            run_views};
}

StabilityCase case_T59() {
    return {"T59",
            "Up along the view",
            "Cameras whose up is parallel to the view or zero",
            "exact",
            "right, up and forward at right angles within 1e-6",
            run_parallel_up};
}

StabilityCase case_T61() {
    return {
        "T61",
        "Long run",
        "A camera round a sphere, 100 frames of 8x8 a turn; 10,000 frames by each traversal (100,000 in a long run)",
        "the first frame",
        "each turn begins with the first frame bit for bit; memory grows by less than 1 MB; no OpenGL object is left "
        "behind",
        run_long};
}

}  // namespace kd

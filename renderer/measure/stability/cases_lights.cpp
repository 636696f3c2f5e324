// Lights in places and with constants that divide by nothing.

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/measure/path_rays.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

/// The light is where no light should be, and the picture shows that place.
struct LitPlace {
    std::string_view name;
    Vec3 light;
    Camera camera;
    bool on_surface = false;     // that the middle pixel sees
    bool at_distance_0 = false;  // from what it sees
};

/// Where the middle pixel sees the surface, as shading computes it.
Vec3 middle_point(const FlatScene& scene, const Camera& camera, int size) {
    const Ray ray = pixel_ray(pinhole(camera, size, size), size / 2, size / 2, size, size);
    return leave_hit(scene, ray, plain_brute_force(scene, ray), ray.direction).position;
}

std::vector<LitPlace> lit_places(const FlatScene& scene, int size) {
    const Vec3 vertex = scene.triangles[50].corner[0];
    const Camera at_vertex = camera_at(3.0f * vertex, vertex);
    return {{"on a vertex", vertex, at_vertex, true},
            {"where a pixel sees it", middle_point(scene, scene.camera, size), scene.camera, true, true},
            {"inside", Vec3(0.0f), scene.camera},
            {"outside", Vec3(0, 0, 1.5f), scene.camera}};
}

/// Pixels whose light would be divided by less than KD_LEAST_FALLOFF.
std::int64_t held_pixels(const FlatScene& scene, const std::vector<Ray>& rays, const std::vector<Hit>& hits) {
    const Light& light = scene.lights[0];
    std::int64_t held = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].triangle < 0) continue;
        const Vec3 towards = light.position - leave_hit(scene, rays[i], hits[i], rays[i].direction).position;
        held += light.attenuation.x + light.attenuation.y * glm::dot(towards, towards) < KD_LEAST_FALLOFF;
    }
    return held;
}

/// Every colour is a number, and no brighter than a surface that sends back all of a light held at KD_LEAST_FALLOFF: a
/// thousandth more is far above all roundings.
void check_lit(CaseRun& run, const Subject& subject, const LitPlace& place, const std::vector<Ray>& rays, int size) {
    const FlatScene& scene = subject.scene;
    const Material& m = scene.materials[0];
    const Vec3 unlit = m.diffuse * scene.ambient;
    const float brightest = 1.001f * (m.diffuse.x + m.specular.x) / KD_LEAST_FALLOFF;
    const auto is_sound = [&](float channel) { return channel >= 0 && channel <= brightest; };
    run.each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        const Frame frame = machine.frame(trace, pinhole(place.camera, size, size), size, size, run.stop());
        run.check_stop();
        row.n += std::int64_t(rays.size());
        CaseRun::tell_error_of_t(scene, rays, frame.layer(Pass::rt_prim).hit.pixels, row);
        for (const Vec4& c : frame.colour.pixels)
            if (!(is_sound(c.x) && is_sound(c.y) && is_sound(c.z)))
                CaseRun::fail(row, fmt::format("a colour of {},{},{} with exponent {}", c.x, c.y, c.z, m.shininess));
        if (const Vec3 middle(frame.colour.at(size / 2, size / 2)); place.at_distance_0 && middle != unlit)
            CaseRun::fail(row, fmt::format("lit from a distance of 0: {},{},{}", middle.x, middle.y, middle.z));
    });
}

/// One light in all its fall-offs on all materials. What is held is told; that something is, for a light that falls off
/// by 1/r^2 alone, is asked where it lies on the surface.
void run_place(CaseRun& run, const Subject& plain, const LitPlace& place, int size, std::string& told) {
    const std::vector<Ray> rays = pixel_rays(pinhole(place.camera, size, size), size, size);
    const std::vector<Hit> hits = run.loop_hits(plain.scene, rays);
    for (const Vec2 attenuation : {Vec2(1, 0), Vec2(0, 1), Vec2(0, 0)}) {
        FlatScene scene = plain.scene;
        scene.lights = {point_light(place.light, Vec3(1), attenuation)};
        const std::int64_t held = held_pixels(scene, rays, hits);
        const std::string name = fmt::format("{}, 1/({:g} + {:g} r^2)", place.name, attenuation.x, attenuation.y);
        if (held > 0) told += fmt::format(" {}: {} of {};", name, held, rays.size());
        const bool must_hold = place.on_surface && attenuation == Vec2(0, 1);
        run.record("held", std::int64_t(rays.size()), must_hold && held == 0 ? 1 : 0,
                   must_hold && held == 0 ? "none " + name : "");
        for (const float shininess : {0.0f, 1.0f, 1e6f}) {
            scene.materials = {glossy(Vec3(0.5f), 0.5f, shininess)};
            check_lit(run, {scene, plain.tree, plain.built}, place, rays, size);
        }
    }
}

void run_lights(CaseRun& run) {
    const Subject plain = run.subject(stress_sphere(20, 10));
    const int size = run.side(171) | 1;  // a million pixels in all; odd, so that one is in the middle
    std::string told = "pixels whose fall-off is held at KD_LEAST_FALLOFF:";
    for (const LitPlace& place : lit_places(plain.scene, size)) run_place(run, plain, place, size, told);
    run.record("held", 0, 0, told);
}

}  // namespace

StabilityCase case_T60() {
    return {"T60",
            "Lights where they should not be",
            "A light on a vertex, in the very point that a pixel sees, inside and outside a sphere, falling off by 1, "
            "1/r^2 and 1/0; exponents 0, 1 and 1e6",
            "exact",
            "every colour a number, not negative and no brighter than a light divided by the least fall-off, 1e-6; "
            "pixels where that holds are told; a light at a distance of 0 lights nothing",
            run_lights};
}

}  // namespace kd

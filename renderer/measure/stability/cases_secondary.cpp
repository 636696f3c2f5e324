// Frames of rays that start on surfaces: shadows and mirrors without acne, and vertex normals that are none.

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <limits>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/double_path.h"
#include "renderer/measure/path_rays.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Material mirror() {
    Material m = matte(Vec3(0.2f));
    m.reflectance = Vec3(0.8f);
    return m;
}

/// A bare scene all of whose triangles are mirrors.
FlatScene mirrors(std::vector<Triangle> triangles, const Camera& camera) {
    FlatScene scene = bare_scene(std::move(triangles));
    scene.materials = {mirror()};
    scene.camera = camera;
    scene.lights = {point_light({0.3f, 0.4f, 0.8f}, Vec3(0.7f))};
    return scene;
}

bool is_finite(const Frame& frame) {
    for (const Vec4& c : frame.colour.pixels)
        if (!(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z))) return false;
    return true;
}

using JudgeFrame = std::function<void(const Frame&, StabilityRow&)>;

/// A square frame by every traversal and machine, whose colours must be finite, to be judged.
void each_frame(CaseRun& run, const Subject& subject, int size, int bounces, const JudgeFrame& judge) {
    const PinholeCamera camera = pinhole(subject.scene.camera, size, size);
    const std::vector<Ray> rays = pixel_rays(camera, size, size);
    run.each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        TraceConfig config = trace;
        config.reflection_depth = bounces;
        config.least_contribution = 0;
        const Frame frame = machine.frame(config, camera, size, size, run.stop());
        run.check_stop();
        row.n += std::int64_t(size) * size;
        CaseRun::tell_error_of_t(subject.scene, rays, frame.layer(Pass::rt_prim).hit.pixels, row);
        if (!is_finite(frame)) CaseRun::fail(row, "a colour is not finite");
        judge(frame, row);
    });
}

/// Fails for every pixel whose rays of that kind hit a triangle numbered `first` or higher but below `end`.
void must_not_hit(const Frame& frame, Pass pass, int first, int end, StabilityRow& row) {
    const Image<Hit>& hits = frame.layer(pass).hit;
    for (int y = 0; y < hits.height; ++y)
        for (int x = 0; x < hits.width; ++x)
            if (const Hit& hit = hits.at(x, y); hit.triangle >= first && hit.triangle < end)
                CaseRun::fail(row, fmt::format("the {} ray of pixel {},{} hit {}",
                                               ray_names[static_cast<std::size_t>(pass)], x, y, exact_text(hit)));
}

void run_coplanar(CaseRun& run) {
    const Camera above{{0.1f, -0.2f, 2}, {0, 0, 0}, {0, 1, 0}, 60};
    const std::vector<Triangle> quad{{{Vec3(-3, -3, 0.1f), Vec3(3, -3, 0.2f), Vec3(3, 3, 0.4f)}},
                                     {{Vec3(-3, -3, 0.1f), Vec3(3, 3, 0.4f), Vec3(-3, 3, 0.3f)}}};
    FlatScene scene = mirrors(quad, above);
    scene.lights = {point_light({0.3f, 0.4f, 5}, Vec3(0.7f)), point_light({-30, 1, 2}, Vec3(0.7f))};
    const Subject subject = run.subject(std::move(scene));
    each_frame(run, subject, run.side(512), 1, [](const Frame& frame, StabilityRow& row) {
        for (const Pass pass : {Pass::shade_prim, Pass::rt_refl, Pass::shade_refl})
            must_not_hit(frame, pass, 0, 2, row);
    });
    // Origins exactly on the diagonal, which neither triangle owns.
    std::vector<Ray> rays;
    std::vector<Hit> known;
    for (int i = 1; i < 1000; ++i) {
        const float s = float(i) / 1000;
        const Ray seen = ray_to({0.1f, -0.2f, 2}, glm::mix(quad[0].corner[0], quad[0].corner[2], s));
        const Hit hit = plain_brute_force(subject.scene, seen);
        if (hit.triangle < 0) continue;
        for (const Light& light : subject.scene.lights) rays.push_back(shadow_ray(subject.scene, seen, hit, light).ray);
        rays.push_back(reflect_hit(subject.scene, seen, hit).ray);
    }
    for (const Ray& ray : rays) known.push_back({-1, ray.t_max, 0, 0});
    Expectation e;
    e.known = &known;
    e.what = "diagonal: ";
    run.check(subject, rays, e);
}

/// Root mean square of the difference of colours.
double rmse(const Frame& frame, const Image<glm::dvec3>& exact) {
    double sum = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(Vec3(frame.colour.pixels[i])) - exact.pixels[i];
        sum += glm::dot(d, d) / 3;
    }
    return std::sqrt(sum / double(exact.pixels.size()));
}

/// Of a picture after mirrors, against double precision: what is asked after one bounce. Rounding grows with every
/// bounce until a path passes an edge on the other side, which moves one pixel of 512 x 512 by up to 2e-3.
constexpr double most_rmse = 1e-4;

void judge_bounces(CaseRun& run, const Subject& subject, int size, int bounces, std::string& told) {
    const PinholeCamera camera = pinhole(subject.scene.camera, size, size);
    const Image<glm::dvec3> exact =
        double_frame(subject.scene, camera, size, size, {.bounces = bounces}, run.threads(), run.stop());
    double worst = 0;
    each_frame(run, subject, size, bounces, [&](const Frame& frame, StabilityRow& row) {
        const double error = rmse(frame, exact);
        worst = std::max(worst, error);
        if (!(error <= most_rmse))
            CaseRun::fail(row, fmt::format("depth {}: RMSE {:.3g} above {}", bounces, error, most_rmse));
    });
    told += fmt::format(" depth {}: {:.2g};", bounces, worst);
}

void run_mirror_box(CaseRun& run) {
    std::vector<Triangle> box;
    for (int axis = 0; axis < 3; ++axis)
        for (const float wall : {-1.0f, 1.0f}) {
            Vec3 corner(-1), u(0.0f), v(0.0f);
            corner[axis] = wall;
            u[(axis + 1) % 3] = 2;
            v[(axis + 2) % 3] = 2;
            for (const Triangle& t : grid(corner, u, v, 1, 1)) box.push_back(t);
        }
    const Camera inside{{0.31f, -0.17f, 0.53f}, {-0.7f, 0.2f, -0.9f}, {0, 1, 0}, 70};
    const Subject subject = run.subject(mirrors(box, inside));
    std::string told = "RMSE against double precision:";
    for (const int bounces : {1, 2, 8}) judge_bounces(run, subject, run.side(512), bounces, told);
    run.record("rmse", 3, 0, told);
}

void run_perpendicular(CaseRun& run) {
    std::vector<Triangle> glass = grid({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 2, 2);
    const Camera before{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 60};
    const auto judge = [](const Frame& frame, StabilityRow& row) { must_not_hit(frame, Pass::rt_refl, 0, 8, row); };
    each_frame(run, run.subject(mirrors(glass, before)), (run.side(512) | 1), 1, judge);
    for (const Triangle& t : grid({-50, -50, 3}, {100, 0, 0}, {0, 100, 0}, 2, 2)) glass.push_back(t);
    each_frame(run, run.subject(mirrors(glass, before)), (run.side(512) | 1), 1,
               [&](const Frame& frame, StabilityRow& row) {
                   judge(frame, row);
                   for (const Hit& hit : frame.layer(Pass::rt_refl).hit.pixels)
                       if (hit.triangle < 8) CaseRun::fail(row, "the wall behind the camera was not reflected");
               });
}

void run_grazing_mirror(CaseRun& run) {
    std::string told = "RMSE against double precision:";
    for (const float angle : {1e-3f, 1e-5f}) {
        const Camera along{{-1, 0, angle}, {1, 0, -angle}, {0, 0, 1}, 1e-1f};
        FlatScene scene = mirrors(grid({-0.9f, -1, 0}, {2, 0, 0}, {0, 2, 0}, 4, 4), along);
        // Normals that lean every way, so that reflections go below the surface unless they are lifted.
        scene.has_normals = true;
        for (TriangleAttributes& a : scene.attributes)
            for (Vec3& n : a.normal) n = glm::normalize(Vec3(0, 0, 1) + 0.3f * random_direction(run.random()));
        const Subject subject = run.subject(std::move(scene));
        const int size = run.side(512);
        const PinholeCamera camera = pinhole(subject.scene.camera, size, size);
        std::int64_t under = 0, hits = 0;
        for (int i = 0; i < size * size; ++i) {
            const Ray ray = pixel_ray(camera, i % size, i / size, size, size);
            const Hit hit = plain_brute_force(subject.scene, ray);
            if (hit.triangle < 0) continue;
            const LeavingRay leaving = reflect_hit(subject.scene, ray, hit);
            ++hits;
            under += !(glm::dot(glm::dvec3(leaving.ray.direction), glm::dvec3(leaving.normal)) >= 0);
        }
        run.record("lifted", hits, under, under > 0 ? "a reflection goes below the surface" : "");
        judge_bounces(run, subject, size, 1, told);
        each_frame(run, subject, size, 1,
                   [](const Frame& frame, StabilityRow& row) { must_not_hit(frame, Pass::rt_refl, 0, 32, row); });
    }
    run.record("rmse", 2, 0, told);
}

/// Nothing here takes a power, so that the CPU and the software renderers differ by 0. A GPU's quotients and roots, 2.5
/// ulp each, make some 1e-6 of a colour; twenty times that is allowed.
constexpr float same_colour = 2e-5f;

void run_bad_normals(CaseRun& run) {
    Scene scene;
    Mesh mesh;
    for (const Triangle& t : stress_sphere(20, 10))
        for (const Vec3& p : t.corner) {
            mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
            mesh.positions.push_back(p);
        }
    scene.meshes = {mesh};
    scene.instances.push_back({});
    scene.materials = {mirror()};
    const Subject plain = run.subject(flatten(scene));
    Mesh& spoiled = scene.meshes[0];
    for (std::size_t i = 0; i < spoiled.positions.size(); ++i)
        spoiled.normals.push_back(i % 3 == 0 ? Vec3(0.0f) : i % 3 == 1 ? Vec3(nan) : Vec3(0, nan, 1));
    const Subject replaced = run.subject(flatten(scene));
    const bool told = replaced.scene.notes.size() > plain.scene.notes.size();
    run.record("flatten", std::int64_t(spoiled.normals.size()), told ? 0 : 1, told ? "" : "replaced without a word");
    FlatScene raw = plain.scene;  // as if nothing had checked them
    raw.has_normals = true;
    for (TriangleAttributes& a : raw.attributes) a.normal[0] = a.normal[1] = a.normal[2] = Vec3(0.0f);
    const Subject zero = run.subject(std::move(raw));
    const int size = run.side(512);
    Frame expected(size, size);
    CpuTracer(plain.scene, plain.tree).trace_frame({}, pinhole(plain.scene.camera, size, size), expected);
    for (const Subject* subject : {&replaced, &zero})
        each_frame(run, *subject, size, 1, [&](const Frame& frame, StabilityRow& row) {
            for (std::size_t i = 0; i < frame.colour.pixels.size(); ++i)
                if (glm::distance(frame.colour.pixels[i], expected.colour.pixels[i]) > same_colour)
                    CaseRun::fail(row, "a pixel is not as with geometric normals");
        });
}

}  // namespace

StabilityCase case_T40() {
    return {"T40",
            "Coplanar neighbours",
            "A tilted mirror of two triangles under two lights; shadow and reflection rays of a frame, and from the "
            "diagonal",
            "exact: nothing can be hit",
            "0 pixels of acne",
            run_coplanar};
}

StabilityCase case_T41() {
    return {"T41",
            "Mirror box",
            "Six mirrors seen from inside, 1, 2 and 8 bounces",
            "the same paths in double precision",
            "RMSE at most 1e-4, told for each number of bounces (colours are about 1); all colours finite",
            run_mirror_box};
}

StabilityCase case_T42() {
    return {"T42",
            "Mirror square to the view",
            "A mirror at right angles to the view, alone and with a wall behind the camera",
            "exact: the mirror never sees itself",
            "0 pixels of acne; the wall is seen in every pixel",
            run_perpendicular};
}

StabilityCase case_T43() {
    return {"T43",
            "Grazing mirror",
            "A mirror seen at 1e-3 and 1e-5 radians, with vertex normals that lean every way",
            "double precision; exact: no reflection goes below the surface",
            "0 reflections below the surface, 0 self-hits, RMSE at most 1e-4, all colours finite",
            run_grazing_mirror};
}

StabilityCase case_T44() {
    return {"T44",
            "Vertex normals that are none",
            "A mirror sphere with zero and NaN normals as from a file, and with zero normals unchecked",
            "the frame with geometric normals",
            "the same frame within 2e-5, all colours finite, replaced normals told",
            run_bad_normals};
}

}  // namespace kd

// "scatter": small triangles everywhere in the view, so that neighbouring rays part (paper, section 4.3).

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "renderer/scene/motion.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural_table.h"
#include "renderer/scene/random.h"

namespace kd {

namespace {

// The triangles fill the part of the view between these distances from the camera.
constexpr double nearest = 2.4;
constexpr double furthest = 4.4;
constexpr double eye_z = 3.4;
constexpr float fov_degrees = 45.0f;
// Of the 10 000: 6.0 pixels at the nearest and 3.3 at the furthest distance, in an image 512 pixels high.
constexpr double edge_of_10000 = 0.0233;

constexpr std::array<Vec3, 7> colours_by_depth{
    Vec3(0.95f, 0.76f, 0.36f), Vec3(0.93f, 0.58f, 0.34f), Vec3(0.85f, 0.43f, 0.40f), Vec3(0.68f, 0.40f, 0.56f),
    Vec3(0.46f, 0.44f, 0.68f), Vec3(0.32f, 0.52f, 0.70f), Vec3(0.30f, 0.62f, 0.64f)};

/// Equilateral, in a random turn, facing the camera to within 60 degrees so that it can be seen.
void add_triangle(Mesh& mesh, glm::dvec3 centre, double edge, Random& random) {
    const double azimuth = 2.0 * std::numbers::pi * random.unit();
    const double cosine = random.between(0.5, 1.0);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const glm::dvec3 normal(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
    const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), normal));
    const glm::dvec3 v = glm::cross(normal, u);
    const double start = 2.0 * std::numbers::pi * random.unit();
    for (int corner = 0; corner < 3; ++corner) {
        const double angle = start + 2.0 * std::numbers::pi * corner / 3.0;
        mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
        mesh.positions.emplace_back(centre + edge / std::numbers::sqrt3 * (std::cos(angle) * u + std::sin(angle) * v));
    }
}

/// Evenly over the volume seen by a square image, whole triangles inside of it.
glm::dvec3 point_in_view(double edge, Random& random) {
    const double slope = std::tan(0.5 * glm::radians(double(fov_degrees)));
    const double near_cubed = nearest * nearest * nearest;
    const double far_cubed = furthest * furthest * furthest;
    const double distance = std::cbrt(random.between(near_cubed, far_cubed));
    const double reach = slope * (distance - edge) - edge;
    const double x = random.between(-reach, reach);
    const double y = random.between(-reach, reach);
    return {x, y, eye_z - distance};
}

glm::dvec3 random_direction(Random& random) {
    const double z = random.between(-1.0, 1.0);
    const double azimuth = 2.0 * std::numbers::pi * random.unit();
    const double across = std::sqrt(1.0 - z * z);
    return {across * std::cos(azimuth), across * std::sin(azimuth), z};
}

/// All triangles fly from the middle of the view, at most to twice their distance from it, tumble, and come back.
class Explosion : public Motion {
  public:
    Explosion(const std::vector<Mesh>& meshes, unsigned seed) : seed_(seed) {
        for (const Mesh& mesh : meshes) at_rest_.push_back(mesh.positions);
    }

    [[nodiscard]] double duration() const override { return 4.0; }

    void pose(Scene& scene, double seconds) const override {
        const double part = seconds / duration();
        Random random(seed_);
        for (std::size_t mesh = 0; mesh < at_rest_.size(); ++mesh) {
            const std::vector<Vec3>& rest = at_rest_[mesh];
            for (std::size_t first = 0; first < rest.size(); first += 3)
                move_triangle(&rest[first], &scene.meshes[mesh].positions[first], part, random);
        }
    }

  private:
    /// `part` of the motion, 0 to 1. Rigidly: a turn about the triangle's centre and a way outwards.
    static void move_triangle(const Vec3* rest, Vec3* moved, double part, Random& random) {
        const double speed = random.between(0.4, 1.0);
        const int turns = random.unit() < 0.5 ? 1 : -1;
        const glm::dvec3 axis = random_direction(random);
        const glm::dquat turn = glm::angleAxis(2.0 * std::numbers::pi * turns * part, axis);
        const glm::dvec3 centre = (glm::dvec3(rest[0]) + glm::dvec3(rest[1]) + glm::dvec3(rest[2])) / 3.0;
        const glm::dvec3 middle(0.0, 0.0, eye_z - 0.5 * (nearest + furthest));
        const glm::dvec3 way = speed * std::sin(std::numbers::pi * part) * (centre - middle);
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 arm = glm::dvec3(rest[i]) - centre;
            // What the turn adds, so that it adds nothing at all at 0.
            moved[i] = Vec3(glm::dvec3(rest[i]) + (turn * arm - arm) + way);
        }
    }

    std::vector<std::vector<Vec3>> at_rest_;
    unsigned seed_;
};

Scene make_scatter(int size, unsigned seed) {
    Scene scene;
    Random random(seed);
    // More triangles are smaller ones, so that they neither fill the view nor vanish.
    const double edge = edge_of_10000 * std::cbrt(10000.0 / size);
    std::array<Mesh, colours_by_depth.size()> bands;
    for (int i = 0; i < size; ++i) {
        const glm::dvec3 centre = point_in_view(edge, random);
        const double depth = (eye_z - centre.z - nearest) / (furthest - nearest);
        const auto band = std::min(std::size_t(depth * double(bands.size())), bands.size() - 1);
        add_triangle(bands[band], centre, edge, random);
    }
    for (std::size_t i = 0; i < bands.size(); ++i) {
        bands[i].name = "band " + std::to_string(i + 1);
        place(scene, std::move(bands[i]), matte(colours_by_depth[i]));
    }

    scene.motion = std::make_shared<Explosion>(scene.meshes, seed);

    scene.ambient = Vec3(0.20f);
    scene.background = Vec3(0.07f, 0.08f, 0.10f);
    scene.lights.push_back(point_light({1.2f, 1.8f, float(eye_z)}, Vec3(0.80f), {1.0f, 0.0f}, 0.15f));
    scene.camera =
        Camera{.eye = {0.0f, 0.0f, float(eye_z)}, .target = {0.0f, 0.0f, 0.0f}, .fov_y_degrees = fov_degrees};
    return scene;
}

}  // namespace

ProceduralScene scatter_scene() {
    return {.name = "scatter",
            .default_size = 10000,
            .smallest_size = 1,
            .largest_size = 2000000,
            .summary = "N separate triangles of a few pixels each, all in view: neighbouring rays go separate ways; "
                       "they fly apart and come back.",
            .make = make_scatter,
            .seeded = true};
}

}  // namespace kd

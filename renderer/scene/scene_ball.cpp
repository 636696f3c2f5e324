// "ball" and "icoball": an open box with one wall removed and a tessellated ball inside (paper, section 4.1, figure 9).

#include <glm/ext/matrix_transform.hpp>
#include <memory>
#include <numbers>
#include <utility>

#include "renderer/scene/flat_shapes.h"
#include "renderer/scene/motion.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural_table.h"
#include "renderer/scene/sphere_shapes.h"

namespace kd {

namespace {

constexpr int box_triangles = 10;
constexpr float ball_radius = 0.72f;
const Vec3 ball_centre{0.0f, ball_radius, 0.0f};

/// Five walls, each a mesh of its own; the one towards the camera is missing.
Scene open_box() {
    Scene scene;
    const auto add_walls = [&](const char* name, unsigned faces, const Material& material) {
        Mesh walls{.name = name};
        add_box(walls,
                {.lower = {-1.2f, 0.0f, -1.2f}, .upper = {1.2f, 2.1f, 1.2f}, .seen_from_inside = true, .faces = faces});
        place(scene, std::move(walls), material);
    };
    Material floor = matte({0.50f, 0.49f, 0.47f});
    floor.reflectance = Vec3(0.25f);
    add_walls("floor", box_bottom, floor);
    add_walls("back wall and ceiling", box_back | box_top, matte({0.80f, 0.79f, 0.76f}));
    add_walls("left wall", box_left, matte({0.55f, 0.66f, 0.74f}));
    add_walls("right wall", box_right, matte({0.82f, 0.70f, 0.54f}));

    scene.ambient = Vec3(0.20f);
    scene.lights.push_back(point_light({-0.55f, 1.75f, 1.60f}, Vec3(0.88f), {0.75f, 0.06f}, 0.15f));
    scene.camera = Camera{.eye = {0.0f, 1.1f, 4.35f}, .target = {0.0f, 1.03f, 0.0f}, .fov_y_degrees = 38.0f};
    return scene;
}

/// The ball turns once about a vertical axis beside its centre, rigidly, so that it circles on the floor between the
/// walls without touching them.
class TurningBall : public Motion {
  public:
    explicit TurningBall(std::size_t instance) : instance_(instance) {}

    [[nodiscard]] double duration() const override { return 4.0; }

    void pose(Scene& scene, double seconds) const override {
        const glm::dvec3 axis_foot(0.22, 0.0, -0.16);
        glm::dmat4 to_world = glm::translate(glm::dmat4(1.0), axis_foot);
        to_world = glm::rotate(to_world, 2.0 * std::numbers::pi * seconds / duration(), glm::dvec3(0.0, 1.0, 0.0));
        // Not by a product with the inverse: at 0 this is the identity to the bit.
        scene.instances[instance_].to_world = glm::mat4(glm::translate(to_world, -axis_foot));
    }

  private:
    std::size_t instance_;
};

Scene with_ball(Mesh ball) {
    Scene scene = open_box();
    ball.name = "ball";
    place(scene, std::move(ball), glossy({0.17f, 0.50f, 0.54f}, 0.30f, 60.0f));
    scene.motion = std::make_shared<TurningBall>(scene.instances.size() - 1);
    return scene;
}

Scene make_ball(int size, unsigned) {
    Mesh ball;
    add_uv_sphere(ball, ball_centre, double(ball_radius), uv_tessellation(size - box_triangles));
    return with_ball(std::move(ball));
}

Scene make_icoball(int size, unsigned) {
    Mesh ball;
    add_icosphere(ball, ball_centre, double(ball_radius), icosphere_frequency(size - box_triangles));
    return with_ball(std::move(ball));
}

}  // namespace

ProceduralScene ball_scene() {
    return {.name = "ball",
            .default_size = 9000,
            .smallest_size = 16,
            .largest_size = 2000000,
            .summary = "An open box with a ball of meridians and parallels, about N triangles in all; the ball moves.",
            .make = make_ball};
}

ProceduralScene icoball_scene() {
    return {.name = "icoball",
            .default_size = 9000,
            .smallest_size = 30,
            .largest_size = 2000000,
            .summary = "The same box with a ball cut from an icosahedron: no poles, triangles of similar size.",
            .make = make_icoball};
}

}  // namespace kd

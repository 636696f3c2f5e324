// "cornell": the box of figure 1 with a red and a green side wall and two cubes, one face of them a mirror.

#include "renderer/scene/flat_shapes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural_table.h"

namespace kd {

namespace {

void place_box(Scene& scene, const char* name, const BoxShape& shape, const Material& material) {
    Mesh mesh{.name = name};
    add_box(mesh, shape);
    place(scene, std::move(mesh), material);
}

Scene make_cornell(int, unsigned) {
    Scene scene;
    BoxShape room{.lower = {-1.0f, 0.0f, -1.0f}, .upper = {1.0f, 2.0f, 1.0f}, .seen_from_inside = true};
    room.faces = box_bottom | box_top | box_back;
    place_box(scene, "white walls", room, matte(Vec3(0.76f, 0.75f, 0.72f)));
    room.faces = box_left;
    place_box(scene, "red wall", room, matte({0.70f, 0.13f, 0.11f}));
    room.faces = box_right;
    place_box(scene, "green wall", room, matte({0.18f, 0.52f, 0.18f}));

    BoxShape tall{.lower = {-0.62f, 0.0f, -0.66f}, .upper = {-0.02f, 1.2f, -0.06f}, .turn_degrees = 35.0};
    tall.faces = all_box_faces & ~unsigned(box_front);
    place_box(scene, "tall cube", tall, matte(Vec3(0.74f, 0.73f, 0.70f)));
    tall.faces = box_front;
    Material mirror = matte(Vec3(0.16f));
    mirror.reflectance = Vec3(0.7f);
    mirror.roughness = 0.2f;
    place_box(scene, "mirror face", tall, mirror);
    const BoxShape low{.lower = {0.20f, 0.0f, -0.05f}, .upper = {0.78f, 0.58f, 0.53f}, .turn_degrees = -17.0};
    place_box(scene, "low cube", low, matte(Vec3(0.74f, 0.73f, 0.70f)));

    scene.ambient = Vec3(0.20f);
    scene.lights.push_back(point_light({-0.1f, 1.85f, 0.90f}, Vec3(1.0f, 0.97f, 0.92f), {0.90f, 0.12f}, 0.25f));
    scene.camera = Camera{.eye = {0.0f, 1.0f, 3.95f}, .target = {0.0f, 1.0f, 0.0f}, .fov_y_degrees = 38.0f};
    return scene;
}

}  // namespace

ProceduralScene cornell_scene() {
    return {.name = "cornell",
            .default_size = 0,
            .smallest_size = 0,
            .largest_size = 0,
            .summary = "A box with a red and a green wall and two cubes, one face of them a mirror; 34 triangles.",
            .make = make_cornell};
}

}  // namespace kd

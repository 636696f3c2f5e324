// "rooms": 25 rooms, each with a box; the camera sees one of them (paper, section 4.2, figure 10).

#include <array>

#include "renderer/scene/flat_shapes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural_table.h"
#include "renderer/scene/random.h"

namespace kd {

namespace {

// 60 walls x 80 + 25 floors and 25 ceilings x 50 + 25 boxes x 108 = 10 000 triangles.
constexpr int rooms_per_side = 5;
constexpr float room_width = 4.0f;
constexpr float room_height = 3.0f;
constexpr int wall_columns = 8, wall_rows = 5, floor_cells = 5, box_cells = 3;

float grid_line(int i) { return room_width * (float(i) - 0.5f * float(rooms_per_side)); }

/// One sheet between neighbours: every room is closed.
Mesh all_walls() {
    Mesh walls{.name = "walls"};
    const Vec3 up(0.0f, room_height, 0.0f);
    for (int line = 0; line <= rooms_per_side; ++line) {
        for (int room = 0; room < rooms_per_side; ++room) {
            add_patch(walls, {grid_line(room), 0.0f, grid_line(line)}, {room_width, 0.0f, 0.0f}, up, wall_columns,
                      wall_rows);
            add_patch(walls, {grid_line(line), 0.0f, grid_line(room)}, {0.0f, 0.0f, room_width}, up, wall_columns,
                      wall_rows);
        }
    }
    return walls;
}

Mesh all_floors(const char* name, float height) {
    Mesh floors{.name = name};
    for (int row = 0; row < rooms_per_side; ++row) {
        for (int column = 0; column < rooms_per_side; ++column)
            add_patch(floors, {grid_line(column), height, grid_line(row + 1)}, {room_width, 0.0f, 0.0f},
                      {0.0f, 0.0f, -room_width}, floor_cells, floor_cells);
    }
    return floors;
}

constexpr std::array<Vec3, 5> box_colours{Vec3(0.70f, 0.36f, 0.24f), Vec3(0.28f, 0.46f, 0.60f),
                                          Vec3(0.74f, 0.60f, 0.28f), Vec3(0.36f, 0.54f, 0.38f),
                                          Vec3(0.54f, 0.40f, 0.56f)};

/// Each colour once in every row and column; the middle room's is the first.
void place_boxes(Scene& scene, Random& random) {
    std::array<Mesh, box_colours.size()> boxes;
    for (int row = 0; row < rooms_per_side; ++row) {
        for (int column = 0; column < rooms_per_side; ++column) {
            const double half = random.between(0.50, 0.65);
            const double height = random.between(0.9, 1.4);
            const glm::dvec3 foot(double(grid_line(column)) + 2.0, 0.0, double(grid_line(row)) + 2.0);
            BoxShape shape{.lower = Vec3(foot - glm::dvec3(half, 0.0, half)),
                           .upper = Vec3(foot + glm::dvec3(half, height, half))};
            shape.turn_degrees = random.between(10.0, 80.0);
            shape.cells = box_cells;
            add_box(boxes[std::size_t(2 * row + column + 4) % boxes.size()], shape);
        }
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        boxes[i].name = "boxes " + std::to_string(i + 1);
        place(scene, std::move(boxes[i]), glossy(box_colours[i], 0.12f, 30.0f));
    }
}

Scene make_rooms(int, unsigned seed) {
    Scene scene;
    Random random(seed);
    place(scene, all_floors("floors", 0.0f), matte({0.56f, 0.50f, 0.44f}));
    place(scene, all_floors("ceilings", room_height), matte(Vec3(0.80f)));
    place(scene, all_walls(), matte({0.74f, 0.74f, 0.70f}));
    place_boxes(scene, random);

    scene.ambient = Vec3(0.20f);
    scene.lights.push_back(point_light({1.1f, 2.5f, 1.3f}, Vec3(0.95f), {0.80f, 0.045f}, 0.15f));
    scene.camera = Camera{.eye = {1.75f, 1.85f, 1.8f}, .target = {-0.25f, 0.80f, -0.35f}, .fov_y_degrees = 62.0f};
    return scene;
}

}  // namespace

ProceduralScene rooms_scene() {
    return {.name = "rooms",
            .default_size = 0,
            .smallest_size = 0,
            .largest_size = 0,
            .summary = "25 closed rooms with a box in each, 10 000 triangles, of which the camera sees one room.",
            .make = make_rooms,
            .seeded = true};
}

}  // namespace kd

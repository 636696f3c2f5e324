// "sheet": a wavy, textured surface that fills the view with small triangles lying side by side.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "renderer/scene/motion.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural_table.h"
#include "renderer/scene/random.h"

namespace kd {

namespace {

constexpr double left = -2.8, right = 2.8;
constexpr double back = -3.4, front = 1.8;

/// height * sin(kx * x + kz * z + phase); in motion its crests pass `cycles` times, in either direction.
struct Wave {
    double height, kx, kz, phase;
    int cycles;
};
using Waves = std::array<Wave, 4>;

Waves random_waves(Random& random) {
    Waves waves{{{0.120, 1.9, 0.7, 0.0, 1},
                 {0.080, -1.2, 2.6, 0.0, 1},
                 {0.040, 4.3, 3.1, 0.0, -2},
                 {0.012, -8.0, 9.5, 0.0, 3}}};
    for (Wave& wave : waves) wave.phase = 2.0 * std::numbers::pi * random.unit();
    return waves;
}

void add_sheet_point(Mesh& mesh, const Waves& waves, double s, double t) {
    const double x = left + s * (right - left);
    const double z = front + t * (back - front);
    double height = 0.0;
    glm::dvec3 normal(0.0, 1.0, 0.0);
    for (const Wave& wave : waves) {
        const double angle = wave.kx * x + wave.kz * z + wave.phase;
        height += wave.height * std::sin(angle);
        normal.x -= wave.height * wave.kx * std::cos(angle);
        normal.z -= wave.height * wave.kz * std::cos(angle);
    }
    mesh.positions.emplace_back(glm::dvec3(x, height, z));
    mesh.normals.emplace_back(glm::normalize(normal));
    mesh.texture_coordinates.emplace_back(4.0 * s, 4.0 * t);
}

/// About `size` triangles in cells as near to squares as whole numbers of them allow.
Mesh make_surface(int size, const Waves& waves) {
    Mesh mesh{.name = "sheet"};
    const double cells = 0.5 * size;
    const auto columns = std::uint32_t(std::max(1L, std::lround(std::sqrt(cells * (right - left) / (front - back)))));
    const auto rows = std::uint32_t(std::max(1L, std::lround(cells / columns)));
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column)
            add_sheet_point(mesh, waves, double(column) / columns, double(row) / rows);
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column;
            const std::uint32_t b = a + columns + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    }
    return mesh;
}

/// Two quiet tones in squares, so that the waves can be followed; it repeats.
Image<Rgba8> chequers() {
    constexpr int cell = 16;
    Image<Rgba8> image(4 * cell, 4 * cell);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const bool light = (x / cell + y / cell) % 2 == 0;
            image.at(x, y) = light ? Rgba8{214, 206, 188, 255} : Rgba8{128, 158, 170, 255};
        }
    }
    return image;
}

/// The waves run through the sheet.
class WaveMotion : public Motion {
  public:
    WaveMotion(int size, const Waves& waves) : size_(size), waves_(waves) {}

    [[nodiscard]] double duration() const override { return 4.0; }

    void pose(Scene& scene, double seconds) const override {
        Waves moved = waves_;
        for (Wave& wave : moved) wave.phase -= 2.0 * std::numbers::pi * wave.cycles * seconds / duration();
        Mesh surface = make_surface(size_, moved);
        surface.material = scene.meshes.front().material;
        scene.meshes.front() = std::move(surface);
    }

  private:
    int size_;
    Waves waves_;
};

Scene make_sheet(int size, unsigned seed) {
    Scene scene;
    Random random(seed);
    scene.textures.push_back(plain_texture(chequers()));
    Material material = glossy(Vec3(0.95f), 0.12f, 40.0f);
    material.texture = 0;
    const Waves waves = random_waves(random);
    place(scene, make_surface(size, waves), material);
    scene.motion = std::make_shared<WaveMotion>(size, waves);

    scene.ambient = Vec3(0.20f);
    scene.lights.push_back(point_light({-2.2f, 2.6f, -2.4f}, Vec3(0.95f), {0.85f, 0.025f}, 0.2f));
    scene.camera = Camera{.eye = {0.0f, 2.6f, 3.0f}, .target = {0.0f, 0.0f, 0.2f}, .fov_y_degrees = 35.0f};
    return scene;
}

}  // namespace

ProceduralScene sheet_scene() {
    return {.name = "sheet",
            .default_size = 10000,
            .smallest_size = 2,
            .largest_size = 2000000,
            .summary =
                "A wavy sheet of about N triangles seen obliquely, filling the view; textured, with smooth normals; "
                "its waves move.",
            .make = make_sheet,
            .seeded = true};
}

}  // namespace kd

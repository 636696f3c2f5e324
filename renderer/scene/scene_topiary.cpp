// "topiary": leaves that an image cuts out of squares, before a frieze and a sign, on paving that only shading has.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "renderer/scene/flat_shapes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural_table.h"
#include "renderer/scene/random.h"

namespace kd {

namespace {

using Dvec3 = glm::dvec3;

/// An image of size x size pixels that `colour` gives for places of 0 to 1, from the upper left on.
template <class Colour>
Image<Rgba8> painted(int size, const Colour& colour) {
    Image<Rgba8> image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) image.at(x, y) = colour((x + 0.5) / size, (y + 0.5) / size);
    return image;
}

Rgba8 bytes(Dvec3 colour, double alpha = 1.0) {
    const auto byte = [](double x) { return static_cast<unsigned char>(std::lround(255.0 * std::clamp(x, 0.0, 1.0))); };
    return {byte(colour.x), byte(colour.y), byte(colour.z), byte(alpha)};
}

/// A pointed oval with a midrib from bottom to top; alpha falls from 1 to 0 across its edge.
Rgba8 leaf(double x, double y) {
    const double half_width = 0.38 * std::sin(std::numbers::pi * y) * (1.25 - 0.5 * y);
    const double off_middle = std::abs(x - 0.5);
    const double rib = off_middle < 0.025 ? 0.16 : 0.0;
    return bytes({0.23 + rib + 0.1 * y, 0.48 + rib, 0.17 + rib}, 0.5 + 12.0 * (half_width - off_middle));
}

constexpr int stones = 4;       // of the paving's images, each way
constexpr double joint = 0.06;  // of a stone's width
constexpr double bevel = 0.14;  // from the joint on

Rgba8 stone_colour(double x, double y) {
    const double u = x * stones, v = y * stones;
    const double to_edge = std::min({u - std::floor(u), std::ceil(u) - u, v - std::floor(v), std::ceil(v) - v});
    if (to_edge < joint) return bytes(Dvec3(0.36, 0.34, 0.32));
    const int number = int(u) * 7 + int(v) * 5;
    return bytes(Dvec3(0.66, 0.62, 0.56) * (0.86 + 0.035 * (number % 5)));
}

/// How far a stone's edge leans at a place of 0 to 1 across it: outwards at both ends.
double lean(double place) {
    if (place < joint || place > 1.0 - joint) return 0.0;
    if (place < joint + bevel) return -0.6;
    return place > 1.0 - joint - bevel ? 0.6 : 0.0;
}

/// In glTF's convention: x to the right, y up, each from -1 to 1 as 0 to 255.
Rgba8 stone_normal(double x, double y) {
    const double u = x * stones, v = y * stones;
    const Dvec3 normal = glm::normalize(Dvec3(lean(u - std::floor(u)), -lean(v - std::floor(v)), 1.0));
    return bytes(0.5 * normal + 0.5);
}

/// A wave and its crest, not symmetric: repeated it would jump at its edges, mirrored it goes on.
Rgba8 frieze(double x, double y) {
    const double crest = 0.2 + 0.6 * x * x;
    const bool wave = y > crest && y < crest + 0.22;
    return wave ? bytes({0.72, 0.30, 0.22}) : bytes({0.86, 0.82, 0.72});
}

/// A disc on a plain ground that goes on beyond the image's edges where it is clamped.
Rgba8 sign(double x, double y) {
    const double distance = std::hypot(x - 0.5, y - 0.5);
    if (distance > 0.46) return bytes({0.16, 0.30, 0.52});
    return distance > 0.30 ? bytes(Dvec3(0.92)) : bytes({0.16, 0.30, 0.52});
}

/// A parallelogram whose image goes from (s0, t0) at the upper left to (s1, t1) at the lower right; `corner` is the
/// lower left.
void add_picture(Mesh& mesh, Dvec3 corner, Dvec3 right, Dvec3 up, std::array<double, 4> place) {
    add_patch(mesh, Vec3(corner), Vec3(right), Vec3(up));
    const auto [s0, t0, s1, t1] = place;
    for (const Vec3& p : std::span(mesh.positions).subspan(mesh.texture_coordinates.size())) {
        const Dvec3 from = Dvec3(p) - corner;
        const double s = glm::dot(from, right) / glm::dot(right, right);
        const double t = glm::dot(from, up) / glm::dot(up, up);
        mesh.texture_coordinates.emplace_back(s0 + s * (s1 - s0), t1 + t * (t0 - t1));
    }
}

Dvec3 random_direction(Random& random) {
    const double z = random.between(-1.0, 1.0);
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(angle), z, radius * std::sin(angle)};
}

/// Squares about a ball, their faces outwards and askew, larger the fewer there are.
Mesh leaves(int count, unsigned seed) {
    Mesh mesh{.name = "leaves"};
    Random random(seed);
    const double size = 3.4 / std::sqrt(double(std::max(count, 50)));
    for (int i = 0; i < count; ++i) {
        const Dvec3 outwards = random_direction(random);
        const Dvec3 middle = Dvec3(-0.35, 0.8, 0.0) + outwards * (0.75 * std::cbrt(random.between(0.4, 1.0)));
        const Dvec3 facing = glm::normalize(outwards + 0.7 * random_direction(random));
        const Dvec3 right = glm::normalize(glm::cross(random_direction(random), facing)) * size;
        const Dvec3 up = glm::cross(facing, right);
        add_picture(mesh, middle - 0.5 * (right + up), right, up, {0.0, 0.0, 1.0, 1.0});
    }
    return mesh;
}

/// A material, and with it the texture that it shows.
Material showing(Scene& scene, Texture texture, int wrap = KD_WRAP_REPEAT) {
    texture.wrap_x = texture.wrap_y = wrap;
    Material material = matte(Vec3(0.95f));
    material.texture = int(scene.textures.size());
    scene.textures.push_back(std::move(texture));
    return material;
}

void place_picture(Scene& scene, const char* name, Dvec3 corner, Dvec3 right, Dvec3 up, std::array<double, 4> place_in,
                   const Material& material) {
    Mesh mesh{.name = name};
    add_picture(mesh, corner, right, up, place_in);
    place(scene, std::move(mesh), material);
}

Scene make_topiary(int size, unsigned seed) {
    Scene scene;
    Material green = showing(scene, mip_mapped_texture(painted(64, leaf), TexelKind::colour));
    green.alpha_cutoff = 0.5f;
    place(scene, leaves(size, seed), green);

    Material paving = showing(scene, mip_mapped_texture(painted(256, stone_colour), TexelKind::colour));
    paving.normal_texture = int(scene.textures.size());
    scene.textures.push_back(mip_mapped_texture(painted(256, stone_normal), TexelKind::normal));
    place_picture(scene, "paving", {-12.0, 0.0, 3.0}, {24.0, 0.0, 0.0}, {0.0, 0.0, -27.0}, {0.0, 0.0, 24.0, 27.0},
                  paving);
    const Material wave = showing(scene, mip_mapped_texture(painted(64, frieze), TexelKind::colour), KD_WRAP_MIRROR);
    place_picture(scene, "frieze", {-12.0, 0.0, -24.0}, {24.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, {0.0, 0.0, 8.0, 1.0}, wave);
    const Material disc = showing(scene, mip_mapped_texture(painted(64, sign), TexelKind::colour), KD_WRAP_CLAMP);
    place_picture(scene, "sign", {0.75, 0.1, -1.3}, {1.2, 0.0, 0.35}, {0.0, 1.2, 0.0}, {-0.2, -0.2, 1.2, 1.2}, disc);

    scene.ambient = Vec3(0.22f);
    scene.background = {0.55f, 0.66f, 0.78f};
    scene.lights.push_back(point_light({-3.2f, 4.2f, 2.6f}, Vec3(1.0f, 0.97f, 0.90f), {0.95f, 0.004f}, 0.35f));
    scene.camera = Camera{.eye = {0.3f, 1.35f, 3.9f}, .target = {0.15f, 0.8f, 0.0f}, .fov_y_degrees = 40.0f};
    return scene;
}

}  // namespace

ProceduralScene topiary_scene() {
    return {.name = "topiary",
            .default_size = 2000,
            .smallest_size = 1,
            .largest_size = 500000,
            .summary = "A ball of N leaves that an image cuts out of squares, on paving whose stones are a normal map; "
                       "images with mip maps, repeated, mirrored and clamped.",
            .make = make_topiary,
            .seeded = true};
}

}  // namespace kd

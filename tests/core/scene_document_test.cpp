// docs/scenes.md publishes every number that a picture of a procedural scene depends on; these rows keep it true.

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fstream>

#include "renderer/scene/procedural.h"

namespace kd {
namespace {

/// "(0, 1.1, 4.35)".
std::string point(Vec3 v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

/// "0.2" where all channels are the same.
std::string colour(Vec3 v) { return v.x == v.y && v.y == v.z ? fmt::format("{}", v.x) : point(v); }

std::string view_row(std::string_view name, const Scene& scene) {
    const Camera& camera = *scene.camera;
    const Light& light = scene.lights[0];
    return fmt::format("| `{}` | {} | {} | {}° | {} | {} | {}, {} | {} | {} | {} |", name, point(camera.eye),
                       point(camera.target), camera.fov_y_degrees, point(light.position), colour(light.colour),
                       light.attenuation.x, light.attenuation.y, light.radius, colour(scene.ambient),
                       colour(scene.background));
}

std::string material_row(std::string_view name, const Scene& scene, std::size_t i) {
    const Material& m = scene.materials[i];
    const bool shiny = m.specular != Vec3(0.0f);
    const std::string rough = m.roughness > 0.0f ? fmt::format(", roughness {}", m.roughness) : "";
    return fmt::format("| `{}` | {} | {} | {} | {} | {} |", name, scene.material_names[i],
                       colour(m.diffuse) + (m.texture >= 0 ? ", textured" : ""), colour(m.specular),
                       shiny ? fmt::format("{}", m.shininess) : "-", colour(m.reflectance) + rough);
}

TEST(ScenesDocument, HoldsEveryCameraLightAndMaterial) {
    std::ifstream file(std::string(KD_SOURCE_DIR) + "/docs/scenes.md");
    const std::string document{std::istreambuf_iterator<char>(file), {}};
    const auto expect_row = [&](const std::string& row) {
        EXPECT_NE(document.find("\n" + row + "\n"), std::string::npos) << "docs/scenes.md lacks\n" << row;
    };
    for (const ProceduralScene& entry : procedural_scenes()) {
        const Scene scene = make_procedural(entry.name).value();
        ASSERT_TRUE(scene.camera.has_value()) << entry.name;
        EXPECT_EQ(scene.camera->up, Vec3(0, 1, 0)) << entry.name << ": the document says so of all";
        ASSERT_EQ(scene.lights.size(), 1u) << entry.name << ": the document says so of all";
        expect_row(view_row(entry.name, scene));
        for (std::size_t i = 0; i < scene.materials.size(); ++i) expect_row(material_row(entry.name, scene, i));
    }
}

}  // namespace
}  // namespace kd

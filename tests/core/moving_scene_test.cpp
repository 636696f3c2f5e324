// A scene at any time: what is the same at all times, and what repeats to the bit.

#include "renderer/scene/moving_scene.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

#include "renderer/scene/motion.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural.h"
#include "renderer/scene/units.h"

namespace kd {
namespace {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// All that a picture is made of, to the bit; not the time.
bool same_bits(const FlatScene& a, const FlatScene& b) {
    return same_bytes(a.triangles, b.triangles) && same_bytes(a.attributes, b.attributes) &&
           same_bytes(a.lights, b.lights) && same_bytes(a.materials, b.materials) &&
           same_bytes(a.textures, b.textures) && a.texels == b.texels && a.kept == b.kept && a.bounds == b.bounds &&
           a.camera == b.camera && a.exponent == b.exponent && a.has_normals == b.has_normals && a.notes == b.notes &&
           a.name == b.name;
}

/// Poses by a function, within two seconds.
class FunctionMotion : public Motion {
  public:
    using Pose = void (*)(Scene&, double);
    explicit FunctionMotion(Pose how) : how_(how) {}
    [[nodiscard]] double duration() const override { return 2.0; }
    void pose(Scene& scene, double seconds) const override { how_(scene, seconds); }

  private:
    Pose how_;
};

/// Two triangles; the second one's last corner is what most motions here move.
Scene two_triangles(FunctionMotion::Pose how, float size = 1.0f) {
    Scene scene;
    Mesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
              .indices = {0, 1, 2, 3, 4, 5}};
    for (Vec3& position : mesh.positions) position *= size;
    place(scene, std::move(mesh), matte(Vec3(0.5f)));
    scene.motion = std::make_shared<FunctionMotion>(how);
    return scene;
}

std::vector<std::string_view> moving_names() {
    std::vector<std::string_view> names;
    for (const ProceduralScene& entry : procedural_scenes())
        if (make_procedural(entry.name)->motion) names.push_back(entry.name);
    return names;
}

TEST(PlaceInMotion, WrapsBothWays) {
    EXPECT_EQ(place_in_motion(0.0, 4.0), 0.0);
    EXPECT_EQ(place_in_motion(1.5, 4.0), 1.5);
    EXPECT_EQ(place_in_motion(4.0, 4.0), 0.0);
    EXPECT_EQ(place_in_motion(9.5, 4.0), 1.5);
    EXPECT_EQ(place_in_motion(-0.5, 4.0), 3.5);
    EXPECT_EQ(place_in_motion(-8.0, 4.0), 0.0);
    EXPECT_FALSE(std::signbit(place_in_motion(-8.0, 4.0)));
    EXPECT_EQ(place_in_motion(-1e-300, 4.0), 0.0) << "4 - 1e-300 rounds to 4, which is the next round";
    EXPECT_LT(place_in_motion(1e300, 4.0), 4.0);
    EXPECT_EQ(place_in_motion(3.0, 0.0), 0.0) << "nothing moves";
}

TEST(MovingScene, BeginsAsTheSceneIs) {
    for (const ProceduralScene& entry : procedural_scenes()) {
        const Scene scene = make_procedural(entry.name).value();
        const FlatScene flat = flatten(scene);
        const MovingScene moving(scene);
        EXPECT_TRUE(same_bits(moving.at(0.0), flat)) << entry.name;
        EXPECT_TRUE(same_bits(moving.at_rest(), flat)) << entry.name;
        EXPECT_EQ(moving.at_rest().duration, moving.duration());
        EXPECT_EQ(moving.at(0.0).time, 0.0);
    }
}

TEST(MovingScene, PosingAtZeroIsTheSceneAsMade) {
    // MovingScene::at(0) does not pose at all; a motion promises the same.
    for (const std::string_view name : moving_names()) {
        Scene scene = make_procedural(name).value();
        const FlatScene before = flatten(scene);
        scene.motion->pose(scene, 1.0);
        EXPECT_FALSE(same_bits(flatten(scene), before)) << name << " does not move";
        scene.motion->pose(scene, 0.0);
        EXPECT_TRUE(same_bits(flatten(scene), before)) << name;
    }
}

TEST(MovingScene, ATimeGivesTheSameBitsAgainAndFromTwoThreads) {
    for (const std::string_view name : moving_names()) {
        const MovingScene moving(make_procedural(name).value());
        const double early = 0.3, late = 0.7 * moving.duration();
        const FlatScene first = moving.at(early), last = moving.at(late);
        EXPECT_FALSE(same_bits(first, last)) << name;
        FlatScene here, there;
        std::thread other([&] { there = moving.at(late); });
        here = moving.at(early);
        other.join();
        EXPECT_TRUE(same_bits(here, first)) << name;
        EXPECT_TRUE(same_bits(there, last)) << name;
        EXPECT_EQ(here.time, early);
        EXPECT_EQ(here.duration, moving.duration());
    }
}

TEST(MovingScene, TimesWrap) {
    const MovingScene moving(make_procedural("sheet:600").value());
    EXPECT_TRUE(same_bits(moving.at(1.5 + 3 * moving.duration()), moving.at(1.5)));
    EXPECT_TRUE(same_bits(moving.at(1.5 - moving.duration()), moving.at(1.5)));
    EXPECT_EQ(moving.at(1.5 - moving.duration()).time, 1.5);
    EXPECT_TRUE(same_bits(moving.at(-2 * moving.duration()), moving.at_rest()));
}

TEST(MovingScene, WhatDoesNotMoveIsAtRestAtAllTimes) {
    Scene scene = make_procedural("cornell").value();
    const MovingScene still(scene);
    EXPECT_EQ(still.duration(), 0.0);
    EXPECT_TRUE(same_bits(still.at(1.3), still.at_rest()));
    EXPECT_EQ(still.at(1.3).time, 0.0);
    EXPECT_EQ(still.at(1.3).duration, 0.0);
}

TEST(MovingScene, TrianglesKeepTheirNumbersAndMaterials) {
    for (const std::string_view name : moving_names()) {
        const MovingScene moving(make_procedural(name).value());
        for (int i = 1; i < 8; ++i) {
            const FlatScene flat = moving.at(moving.duration() * i / 8);
            SCOPED_TRACE(std::string(name) + " at " + std::to_string(flat.time) + " s");
            ASSERT_TRUE(same_triangles(flat, moving.at_rest()));
            EXPECT_TRUE(flat.kept.empty());
            EXPECT_EQ(flat.notes, moving.at_rest().notes);
            for (std::size_t t = 0; t < flat.triangles.size(); ++t)
                ASSERT_EQ(flat.attributes[t].material, moving.at_rest().attributes[t].material) << t;
        }
    }
}

TEST(MovingScene, UnitsAndFittedCameraAreThoseOfRest) {
    const auto grow = [](Scene& scene, double seconds) {
        scene.instances[0].to_world = glm::scale(glm::mat4(1.0f), Vec3(float(1.0 + 1e6 * seconds)));
    };
    const Scene scene = two_triangles(grow, 0x1p20f);
    const MovingScene moving(scene);
    const FlatScene later = moving.at(1.0);
    EXPECT_EQ(moving.at_rest().exponent, 21);
    EXPECT_EQ(later.exponent, 21) << "though its own would be 41";
    EXPECT_EQ(later.camera, moving.at_rest().camera);
    EXPECT_EQ(later.triangles[0].corner[1].x, 1000001.0f * moving.at_rest().triangles[0].corner[1].x);
    EXPECT_EQ(later.bounds.upper.x, later.triangles[0].corner[1].x) << "bounds are those of the pose";
}

TEST(MovingScene, ACameraOfTheSceneMoves) {
    const auto look_round = [](Scene& scene, double seconds) { scene.camera->eye.x = float(seconds); };
    Scene scene = two_triangles(look_round);
    scene.camera = Camera{.eye = {0, 0, 5}, .target = {0, 0, 0}};
    const MovingScene moving(scene);
    EXPECT_EQ(moving.at_rest().camera.eye, Vec3(0, 0, 5));
    EXPECT_EQ(moving.at(0.5).camera.eye, Vec3(0.5f, 0, 5));
}

TEST(MovingScene, SaysWhichTrianglesAPoseDropped) {
    // In the second half of its motion the first triangle is a point.
    const auto collapse = [](Scene& scene, double seconds) {
        if (seconds >= 1.0) scene.meshes[0].positions[1] = scene.meshes[0].positions[2] = Vec3(0.0f);
    };
    const MovingScene moving(two_triangles(collapse));
    const FlatScene before = moving.at(0.5), after = moving.at(1.5);
    EXPECT_TRUE(before.kept.empty());
    EXPECT_TRUE(same_triangles(before, moving.at_rest()));
    ASSERT_EQ(after.triangles.size(), 1u);
    EXPECT_EQ(after.kept, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(after.triangles[0], moving.at_rest().triangles[1]);
    EXPECT_FALSE(same_triangles(after, moving.at_rest()));
}

TEST(MovingScene, EquallyManyTrianglesNeedNotBeTheSame) {
    // First one triangle is a point, then the other.
    const auto collapse = [](Scene& scene, double seconds) {
        const std::size_t first = seconds >= 1.0 ? 0 : 3;
        scene.meshes[0].positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
        for (std::size_t i = first; i < first + 3; ++i) scene.meshes[0].positions[i] = Vec3(0.0f);
    };
    const MovingScene moving(two_triangles(collapse));
    EXPECT_EQ(moving.at(0.5).triangles.size(), moving.at(1.5).triangles.size());
    EXPECT_FALSE(same_triangles(moving.at(0.5), moving.at(1.5)));
    EXPECT_TRUE(same_triangles(moving.at(0.5), moving.at(0.6)));
}

TEST(MovingScene, KnowsWhichWereTooSmallForItsUnits) {
    // 2^-60 beside a scene of 2^20: its area underflows what tests can bear.
    const auto shrink = [](Scene& scene, double) {
        for (std::size_t i = 0; i < 3; ++i) scene.meshes[0].positions[i] *= 0x1p-60f;
    };
    const FlatScene later = MovingScene(two_triangles(shrink)).at(1.0);
    EXPECT_EQ(later.kept, (std::vector<std::uint32_t>{1}));
}

TEST(MovingScene, HasNormalsWhereItHasThemAtRest) {
    // A bend with smooth normals is flat, with the normals of its triangles, in the second half.
    const auto flatten_out = [](Scene& scene, double seconds) {
        if (seconds >= 1.0) scene.meshes[0].normals.assign(6, Vec3(0, 0, 1));
    };
    Scene scene = two_triangles(flatten_out);
    scene.meshes[0].normals.assign(6, Vec3(0.6f, 0, 0.8f));
    const MovingScene moving(scene);
    EXPECT_TRUE(moving.at_rest().has_normals);
    EXPECT_TRUE(moving.at(1.5).has_normals);
}

}  // namespace
}  // namespace kd

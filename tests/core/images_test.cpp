// Images on surfaces, as the CPU tracer shows them: which texel, how coarse, bent normals, holes.

#include <cmath>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/parts.h"
#include "renderer/trace/walk_choices.h"

namespace kd {
namespace {

constexpr int pixels = 9;
constexpr float view_angle = 40.0f;

/// A square that fills the view from `distance`, whose image goes from `low` to `high` each way, left to right and top
/// to bottom; it glows with what its image says, and nothing lights it.
Scene glowing_square(const Texture& texture, float low, float high, float distance = 3.0f) {
    const float half = distance * std::tan(glm::radians(view_angle / 2.0f));
    Mesh square{.name = "square",
                .positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}},
                .texture_coordinates = {{low, high}, {high, high}, {high, low}, {low, low}},
                .indices = {0, 1, 2, 0, 2, 3}};
    Material glow = matte(Vec3(0.0f));
    glow.emission = Vec3(1.0f);
    glow.emission_texture = 0;
    Scene scene;
    scene.textures = {texture};
    scene.ambient = scene.background = Vec3(0.0f);
    place(scene, square, glow);
    scene.lights.push_back(point_light(Vec3(0, 0, 1), Vec3(0.0f)));
    scene.camera = Camera{.eye = {0, 0, distance}, .target = {0, 0, 0}, .fov_y_degrees = view_angle};
    return scene;
}

Frame picture(const Scene& scene, const TraceConfig& config = {}, CpuMode mode = CpuMode::scalar) {
    const FlatScene flat = flatten(scene);
    const KdTree tree = build_tree(flat.triangles, {});
    Frame frame(pixels, pixels);
    CpuTracer(flat, tree, mode).trace_frame(config, pinhole(flat.camera, pixels, pixels), frame, 1);
    return frame;
}

/// Red along the middle row, as thirds: 0, 1, 2 or 3.
std::string thirds(const Scene& scene) {
    const Frame frame = picture(scene);
    std::string row;
    for (int x = 0; x < pixels; ++x) row += char('0' + std::lround(3.0f * frame.colour.at(x, pixels / 2).x));
    return row;
}

/// Three columns, of red 0, 85 and 255: 0, 1 and 3 thirds.
Texture three_columns(int wrap) {
    Image<Rgba8> image(3, 1);
    image.pixels = {{0, 0, 0, 255}, {85, 0, 0, 255}, {255, 0, 0, 255}};
    Texture texture = plain_texture(image);
    texture.wrap_x = wrap;
    return texture;
}

TEST(Images, GoOnBeyondTheirEdgesAsTheySay) {
    // Nine pixels see the middles of nine texels: three before the image, itself, three behind it.
    EXPECT_EQ(thirds(glowing_square(three_columns(KD_WRAP_REPEAT), -1.0f, 2.0f)), "013013013");
    EXPECT_EQ(thirds(glowing_square(three_columns(KD_WRAP_CLAMP), -1.0f, 2.0f)), "000013333");
    EXPECT_EQ(thirds(glowing_square(three_columns(KD_WRAP_MIRROR), -1.0f, 2.0f)), "310013310");
    EXPECT_EQ(thirds(glowing_square(three_columns(KD_WRAP_MIRROR), -7.0f, -4.0f)), "310013310") << "far before";
}

TEST(Images, AreMixedBetweenTexels) {
    Image<Rgba8> image(2, 1);
    image.pixels = {{0, 0, 0, 255}, {255, 0, 0, 255}};
    Texture texture = plain_texture(image);
    texture.wrap_x = KD_WRAP_CLAMP;
    const Frame frame = picture(glowing_square(texture, 0.25f, 0.75f));
    // From the middle of the first texel to that of the second, in ninths.
    for (int x = 0; x < pixels; ++x) EXPECT_NEAR(frame.colour.at(x, 4).x, (float(x) + 0.5f) / pixels, 1e-6f) << x;
}

/// Levels that can be told apart: red for the whole image, green for its half, then blue.
Texture coloured_levels() {
    Texture texture = mip_mapped_texture(Image<Rgba8>(4, 4), TexelKind::colour);
    texture.levels[0] = Image<Rgba8>(4, 4, {255, 0, 0, 255});
    texture.levels[1] = Image<Rgba8>(2, 2, {0, 255, 0, 255});
    texture.levels[2] = Image<Rgba8>(1, 1, {0, 0, 255, 255});
    return texture;
}

Vec3 middle_of(const Scene& scene, const TraceConfig& config = {}) {
    return Vec3(picture(scene, config).colour.at(pixels / 2, pixels / 2));
}

void expect_near(Vec3 found, Vec3 expected, const char* what) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 2e-6f) << what;
}

TEST(MipMapsSeen, TheLevelIsThatOfWhatAPixelCovers) {
    // The middle pixel covers a ninth of the square each way, whatever the distance.
    const auto seen = [](float texels, float distance = 3.0f) {
        return middle_of(glowing_square(coloured_levels(), 0.0f, texels * pixels / 4.0f, distance));
    };
    expect_near(seen(0.5f), {1, 0, 0}, "half a texel");
    expect_near(seen(1.0f), {1, 0, 0}, "one");
    expect_near(seen(1.25f), {0.75f, 0.25f, 0}, "a quarter of the way to two");
    expect_near(seen(1.25f, 300.0f), {0.75f, 0.25f, 0}, "from afar, with all else as large");
    expect_near(seen(2.0f), {0, 1, 0}, "two");
    expect_near(seen(3.0f), {0, 0.5f, 0.5f}, "half of the way to four");
    expect_near(seen(4.0f), {0, 0, 1}, "four");
    expect_near(seen(100.0f), {0, 0, 1}, "beyond the last");
}

TEST(MipMapsSeen, ASurfaceThatLeansIsSeenCoarser) {
    Scene scene = glowing_square(coloured_levels(), 0.0f, 1.0f * pixels / 4.0f);
    scene.camera->eye = {0.0f, 3.0f * std::sin(glm::radians(60.0f)), 3.0f * std::cos(glm::radians(60.0f))};
    // At 60 degrees what a pixel covers is twice as long: two texels. Its corners are seen as before.
    expect_near(middle_of(scene), {0, 1, 0}, "leaning");
}

TEST(MipMapsSeen, TheConeGoesOnBehindAMirror) {
    // A mirror halfway between the camera and what it shows behind the camera: as far as seen directly from twice as
    // far.
    Scene scene = glowing_square(coloured_levels(), 0.0f, 0.75f * pixels / 4.0f, 3.0f);
    scene.camera->eye = {0, 0, 1.5f};
    scene.camera->target = {0, 0, 3.0f};
    Material mirror = matte(Vec3(0.0f));
    mirror.reflectance = Vec3(1.0f);
    Mesh square{.name = "mirror", .positions = {{-2, -2, 3}, {2, -2, 3}, {0, 4, 3}}, .indices = {0, 1, 2}};
    place(scene, square, mirror);
    // 1.5 to the mirror and 3 back to the square, where 3 would see 0.75 texels: 1.125.
    expect_near(middle_of(scene), {0.875f, 0.125f, 0}, "mirrored");
}

/// A square lit from the right, from 45 degrees; its image of normals is one colour.
Scene bent_square(Rgba8 normal, bool turned_over = false, bool mirrored_image = false) {
    Scene scene = glowing_square(plain_texture(Image<Rgba8>(1, 1, normal)), 0.0f, 1.0f);
    Material& white = scene.materials[0];
    white = matte(Vec3(1.0f));
    white.normal_texture = 0;
    scene.lights = {point_light(Vec3(1000, 0, 1000), Vec3(1.0f))};
    Mesh& square = scene.meshes[0];
    if (turned_over) square.indices = {0, 2, 1, 0, 3, 2};
    if (mirrored_image)
        for (Vec2& uv : square.texture_coordinates) uv.x = 1.0f - uv.x;
    return scene;
}

TEST(NormalMaps, BendTowardsTheImagesRightAndItsTop) {
    const float plain = std::sqrt(0.5f);
    const Rgba8 right{218, 128, 218, 255}, up{128, 218, 218, 255}, straight{128, 128, 255, 255};
    // 128 of 255 is not quite the middle: a bend of 0.004.
    constexpr float step = 0.006f;
    EXPECT_NEAR(middle_of(bent_square(straight)).x, plain, step);
    EXPECT_NEAR(middle_of(bent_square(right)).x, 1.0f, step) << "towards the light";
    EXPECT_NEAR(middle_of(bent_square(up)).x, 0.5f, step) << "45 degrees upwards from 45 to the right";
    EXPECT_NEAR(middle_of(bent_square({37, 128, 218, 255})).x, 0.0f, step) << "away from it";
    EXPECT_NEAR(middle_of(bent_square(right, false, true)).x, 0.0f, step) << "the image's right is to the left";
    Scene above = bent_square(up);
    above.lights = {point_light(Vec3(0, 1000, 1000), Vec3(1.0f))};
    EXPECT_NEAR(middle_of(above).x, 1.0f, step) << "up is up";
    above.meshes[0].texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_NEAR(middle_of(above).x, 0.0f, step) << "unless the image stands on its head";
}

TEST(NormalMaps, TheBackIsBentTheOtherWay) {
    // glTF 2.0, section 3.9.4: the normal of a back face is that of the front, reversed.
    EXPECT_NEAR(middle_of(bent_square({218, 128, 218, 255}, true)).x, 0.0f, 0.006f);
}

TEST(NormalMaps, AScaleOfNothingBendsNothing) {
    Scene scene = bent_square({218, 128, 218, 255});
    scene.materials[0].normal_scale = 0.0f;
    EXPECT_NEAR(middle_of(scene).x, std::sqrt(0.5f), 1e-6f);
}

/// The left half of the square is cut out; a blue wall stands behind it.
Scene cut_square() {
    Image<Rgba8> image(2, 1);
    image.pixels = {{255, 0, 0, 0}, {255, 0, 0, 255}};
    Texture texture = plain_texture(image);
    texture.wrap_x = KD_WRAP_CLAMP;
    Scene scene = glowing_square(texture, 0.0f, 1.0f);
    scene.materials[0].texture = 0;
    scene.materials[0].alpha_cutoff = 0.5f;
    Material blue = matte(Vec3(0.0f));
    blue.emission = Vec3(0, 0, 1);
    place(scene, {.name = "wall", .positions = {{-9, -9, -1}, {9, -9, -1}, {0, 18, -1}}, .indices = {0, 1, 2}}, blue);
    return scene;
}

TEST(AlphaMasks, LetRaysThroughOnEveryWalk) {
    const Scene scene = cut_square();
    for (const TraversalInfo& walk : traversals())
        for (const CpuMode mode : {CpuMode::scalar, CpuMode::wide, CpuMode::packet}) {
            const Frame frame = picture(scene, {.traversal = walk.id}, mode);
            const std::string what = std::string(walk.name) + " " + std::string(tracer_name(mode));
            EXPECT_EQ(Vec3(frame.colour.at(0, 4)), Vec3(0, 0, 1)) << what;
            EXPECT_EQ(Vec3(frame.colour.at(8, 4)), Vec3(1, 0, 0)) << what;
        }
    Scene solid = scene;
    solid.materials[0].alpha_cutoff = 0.0f;
    EXPECT_EQ(Vec3(picture(solid).colour.at(0, 4)), Vec3(1, 0, 0)) << "alpha alone cuts nothing";
}

TEST(AlphaMasks, LetLightThroughButNotBesideTheHole) {
    Scene scene = cut_square();
    scene.materials[1] = matte(Vec3(1.0f));
    scene.lights = {point_light(Vec3(0, 0, 900), Vec3(1.0f))};
    scene.camera->eye = {0.0f, 0.0f, -0.5f};  // behind the square, before the wall
    scene.camera->target = {0.0f, 0.0f, -1.0f};
    const Frame frame = picture(scene);
    EXPECT_GT(frame.colour.at(1, 4).x, 0.9f) << "through the hole, on the left";
    EXPECT_EQ(frame.colour.at(7, 4).x, 0.0f) << "behind what is left";
}

TEST(AlphaMasks, MayLeaveNothing) {
    Scene scene = cut_square();
    scene.materials[0].texture = -1;
    scene.materials[0].alpha_cutoff = 2.0f;
    EXPECT_EQ(Vec3(picture(scene).colour.at(8, 4)), Vec3(0, 0, 1));
}

}  // namespace
}  // namespace kd

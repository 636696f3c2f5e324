// The procedural scenes: their names, sizes, shapes, and what the camera sees of them.

#include "renderer/scene/procedural.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/sphere_shapes.h"
#include "tests/support/refusal.h"

namespace kd {
namespace {

FlatScene flat_scene(std::string_view name, unsigned seed = 1) { return flatten(make_procedural(name, seed).value()); }

std::string refusal(std::string_view name) {
    return test::refusal([&] { (void)make_procedural(name); });
}

/// Hits of the primary rays of a size x size image.
Image<Hit> primary_hits(const FlatScene& scene, int size) {
    const KdTree tree = build_tree(scene.triangles, {});
    CpuTracer tracer(scene, tree);
    Frame frame(size, size);
    const TraceConfig config{.shadows = false, .reflection_depth = 0};
    EXPECT_TRUE(tracer.trace_frame(config, pinhole(scene.camera, size, size), frame, 1));
    return frame.layer(Pass::rt_prim).hit;
}

const Mesh& mesh_called(const Scene& scene, std::string_view name) {
    return *std::ranges::find(scene.meshes, name, &Mesh::name);
}

TEST(Procedural, EverySceneIsReadyToTrace) {
    for (const ProceduralScene& entry : procedural_scenes()) {
        SCOPED_TRACE(entry.name);
        const Scene scene = make_procedural(entry.name).value();
        const FlatScene flat = flatten(scene);
        EXPECT_FALSE(flat.triangles.empty());
        EXPECT_TRUE(flat.notes.empty()) << ::testing::PrintToString(flat.notes);
        EXPECT_TRUE(scene.camera && is_valid(*scene.camera));
        EXPECT_EQ(scene.lights.size(), 1u);
        EXPECT_EQ(scene.material_names.size(), scene.materials.size());
        EXPECT_TRUE(entry.summary.ends_with('.'));
        const auto seen =
            std::ranges::count_if(primary_hits(flat, 64).pixels, [](const Hit& hit) { return hit.triangle >= 0; });
        EXPECT_GT(seen, 64 * 64 / 10);
    }
}

TEST(Procedural, NamesAreUnique) {
    std::set<std::string_view> names;
    for (const ProceduralScene& entry : procedural_scenes()) EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(names,
              (std::set<std::string_view>{"ball", "cornell", "icoball", "rooms", "scatter", "sheet", "topiary"}));
}

TEST(Procedural, SmallestSizesWork) {
    for (const ProceduralScene& entry : procedural_scenes()) {
        const FlatScene flat = flatten(entry.make(entry.smallest_size, 1));
        EXPECT_GE(flat.triangles.size(), std::size_t(entry.smallest_size)) << entry.name;
        EXPECT_TRUE(flat.notes.empty()) << entry.name;
    }
}

TEST(Procedural, NameMayCarryASize) {
    EXPECT_EQ(make_procedural("ball").value().name, "ball:9000");
    EXPECT_EQ(make_procedural("ball:1000").value().name, "ball:1000");
    EXPECT_EQ(make_procedural("rooms").value().name, "rooms");
    EXPECT_FALSE(make_procedural("teapot"));
    EXPECT_FALSE(make_procedural("teapot:9000"));
    EXPECT_FALSE(make_procedural("ball.gltf"));
    EXPECT_FALSE(make_procedural(""));
    EXPECT_FALSE(make_procedural(":9000"));
}

TEST(Procedural, RefusesWrongSizes) {
    EXPECT_EQ(refusal("ball:abc"), "ball:abc: size is not a whole number; try ball:9000");
    EXPECT_EQ(refusal("ball:9000x"), "ball:9000x: size is not a whole number; try ball:9000");
    EXPECT_EQ(refusal("ball:9e3"), "ball:9e3: size is not a whole number; try ball:9000");
    EXPECT_EQ(refusal("ball: 9000"), "ball: 9000: size is not a whole number; try ball:9000");
    EXPECT_EQ(refusal("ball:"), "ball:: size is missing; try ball:9000");
    EXPECT_EQ(refusal("ball:15"), "ball:15: size is not in 16..2000000; try ball:9000");
    EXPECT_EQ(refusal("ball:-9000"), "ball:-9000: size is not in 16..2000000; try ball:9000");
    EXPECT_EQ(refusal("scatter:99999999999999999999"),
              "scatter:99999999999999999999: size is not in 1..2000000; try scatter:10000");
    EXPECT_EQ(refusal("cornell:3"), "cornell:3: this scene takes no size; try cornell");
    EXPECT_EQ(refusal("ball:16"), "accepted");
}

TEST(Procedural, SameNameAndSeedGiveTheSameScene) {
    for (const ProceduralScene& entry : procedural_scenes()) {
        const FlatScene a = flat_scene(entry.name, 7);
        const FlatScene b = flat_scene(entry.name, 7);
        EXPECT_EQ(a.triangles, b.triangles) << entry.name;
        EXPECT_EQ(a.camera, b.camera) << entry.name;
    }
}

TEST(Procedural, SeedsGiveOtherScenesWhereThereIsChance) {
    for (const char* name : {"rooms", "scatter:100", "sheet:100", "topiary:100"})
        EXPECT_NE(flat_scene(name, 1).triangles, flat_scene(name, 2).triangles) << name;
    for (const char* name : {"ball:100", "icoball:100", "cornell"})
        EXPECT_EQ(flat_scene(name, 1).triangles, flat_scene(name, 2).triangles) << name;
}

TEST(BallScene, HasAsManyTrianglesAsAskedFor) {
    for (const int size : {1000, 4000, 9000, 50000}) {
        const auto triangles = [size](const char* name) {
            return double(flat_scene(name + std::to_string(size)).triangles.size());
        };
        EXPECT_NEAR(triangles("ball:"), size, 0.002 * size);
        // 20 n^2 has steps of 40 n.
        EXPECT_NEAR(triangles("icoball:"), size, std::max(0.05 * size, 20.0 * std::sqrt(size / 20.0)));
    }
    EXPECT_EQ(flat_scene("ball:1000").triangles.size(), 1000u);
    EXPECT_EQ(flat_scene("icoball:9000").triangles.size(), 10u + 20u * 21u * 21u);
}

TEST(BallScene, TessellationIsTheNearestOfItsShape) {
    for (int wanted = 6; wanted < 3000; wanted += 7) {
        const UvTessellation chosen = uv_tessellation(wanted);
        EXPECT_GE(chosen.segments, 3);
        EXPECT_GE(chosen.rings, 2);
        for (int rings = 2; rings < 60; ++rings) {
            for (int segments = (3 * rings + 1) / 2; segments <= 5 * rings / 2; ++segments)
                EXPECT_LE(std::abs(chosen.triangles() - wanted), std::abs(2 * segments * (rings - 1) - wanted))
                    << wanted;
        }
    }
}

TEST(BallScene, IcosphereFrequencyIsTheNearest) {
    EXPECT_EQ(icosphere_frequency(0), 1);
    EXPECT_EQ(icosphere_frequency(20), 1);
    EXPECT_EQ(icosphere_frequency(50), 1);
    EXPECT_EQ(icosphere_frequency(51), 2);
    EXPECT_EQ(icosphere_frequency(80), 2);
    EXPECT_EQ(icosphere_frequency(8990), 21);
}

TEST(BallScene, BoxLacksTheWallTowardsTheCamera) {
    for (const char* name : {"ball:1000", "icoball:1000"}) {
        const FlatScene flat = flat_scene(name);
        const auto in_plane = [&](int axis, float value) {
            return std::ranges::count_if(flat.triangles, [=](const Triangle& t) {
                return std::ranges::all_of(t.corner, [=](const Vec3& corner) { return corner[axis] == value; });
            });
        };
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(in_plane(axis, flat.bounds.lower[axis]), 2) << name << " lower " << axis;
            EXPECT_EQ(in_plane(axis, flat.bounds.upper[axis]), axis == 2 ? 0 : 2) << name << " upper " << axis;
        }
        EXPECT_GT(flat.camera.eye.z, flat.bounds.upper.z);
    }
}

/// Every directed edge once and its reverse once, one piece without holes, all faces outwards.
void expect_closed_sphere(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first}));
    }
    const auto faces = std::ptrdiff_t(mesh.indices.size() / 3);
    EXPECT_EQ(std::ptrdiff_t(mesh.positions.size()) - std::ptrdiff_t(edges.size() / 2) + faces, 2) << "Euler's number";

    Aabb box;
    for (const Vec3& position : mesh.positions) box.include(position);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
        const glm::dvec3 area = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        EXPECT_GT(glm::dot(area, glm::dvec3(mesh.normals[mesh.indices[i]])), 0.0);
    }
}

TEST(BallScene, BallsAreClosed) {
    for (const char* name :
         {"ball:16", "ball:31", "ball:1000", "ball:9000", "icoball:30", "icoball:90", "icoball:190", "icoball:9000"}) {
        SCOPED_TRACE(name);
        expect_closed_sphere(mesh_called(make_procedural(name).value(), "ball"));
    }
}

TEST(BallScene, BallIsRound) {
    for (const bool icosphere : {false, true}) {
        Mesh mesh;
        icosphere ? add_icosphere(mesh, {1, 2, 3}, 0.5, 7) : add_uv_sphere(mesh, {1, 2, 3}, 0.5, {15, 8});
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_NEAR(glm::distance(mesh.positions[i], Vec3(1, 2, 3)), 0.5f, 1e-6f);
            EXPECT_LT(glm::distance(mesh.positions[i], Vec3(1, 2, 3) + 0.5f * mesh.normals[i]), 1e-6f);
        }
    }
}

TEST(BallScene, ReflectionsAreSeen) {
    const FlatScene flat = flat_scene("ball:1000");
    const Image<Hit> hits = primary_hits(flat, 64);
    const auto reflective = std::ranges::count_if(hits.pixels, [&](const Hit& hit) {
        return hit.triangle >= 0 &&
               flat.materials[std::size_t(flat.attributes[std::size_t(hit.triangle)].material)].reflectance.x > 0.0f;
    });
    EXPECT_GT(reflective, 64 * 64 / 20);
}

TEST(RoomsScene, IsTenThousandTrianglesOfWhichOneRoomIsSeen) {
    const FlatScene flat = flat_scene("rooms");
    EXPECT_EQ(flat.triangles.size(), 10000u);
    EXPECT_EQ(flat.bounds, (Aabb{{-10, 0, -10}, {10, 3, 10}}));

    // The middle room is 4 x 3 x 4 around the origin.
    const auto in_room = [](Vec3 p) {
        return std::abs(p.x) <= 2.0f && std::abs(p.z) <= 2.0f && p.y >= 0.0f && p.y <= 3.0f;
    };
    EXPECT_TRUE(in_room(flat.camera.eye));
    EXPECT_TRUE(in_room(flat.lights[0].position));
    for (const Hit& hit : primary_hits(flat, 96).pixels) {
        ASSERT_GE(hit.triangle, 0) << "the room is closed";
        for (const Vec3& corner : flat.triangles[std::size_t(hit.triangle)].corner) EXPECT_TRUE(in_room(corner));
    }
}

TEST(ScatterScene, AllTrianglesAreOnScreenAndAFewPixelsLarge) {
    const FlatScene flat = flat_scene("scatter:10000");
    ASSERT_EQ(flat.triangles.size(), 10000u);
    EXPECT_FALSE(flat.has_normals);
    const PinholeCamera view = pinhole(flat.camera, 512, 512);
    for (const Triangle& triangle : flat.triangles) {
        for (const Vec3& corner : triangle.corner) {
            const Vec3 offset = corner - view.eye;
            const float depth = glm::dot(offset, view.forward);
            ASSERT_GT(depth, 0.0f);
            EXPECT_LE(std::abs(glm::dot(offset, view.right)), depth * glm::dot(view.right, view.right));
            EXPECT_LE(std::abs(glm::dot(offset, view.up)), depth * glm::dot(view.up, view.up));
        }
        const float depth = glm::dot(triangle.corner[0] - view.eye, view.forward);
        const float pixels =
            glm::distance(triangle.corner[0], triangle.corner[1]) / depth * 256.0f / glm::length(view.up);
        EXPECT_GT(pixels, 3.0f);
        EXPECT_LT(pixels, 6.2f);
    }
}

TEST(ScatterScene, ManyTrianglesAreSeen) {
    const FlatScene flat = flat_scene("scatter:10000");
    std::set<int> seen;
    for (const Hit& hit : primary_hits(flat, 512).pixels) seen.insert(hit.triangle);
    EXPECT_GT(seen.size(), 8000u);
}

TEST(SheetScene, FillsTheViewWithAboutNTriangles) {
    for (const int size : {2, 100, 10000, 100000}) {
        const auto triangles = double(flat_scene("sheet:" + std::to_string(size)).triangles.size());
        EXPECT_NEAR(triangles, size, std::max(0.02 * size, size < 1000 ? 0.1 * size : 0.0)) << size;
    }
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const FlatScene flat = flat_scene("sheet:10000", seed);
        EXPECT_TRUE(flat.has_normals);
        EXPECT_TRUE(
            std::ranges::all_of(primary_hits(flat, 64).pixels, [](const Hit& hit) { return hit.triangle >= 0; }));
    }
}

TEST(CornellScene, HasColouredWallsAndOneMirrorFace) {
    const Scene scene = make_procedural("cornell").value();
    EXPECT_EQ(flatten(scene).triangles.size(), 34u);
    const auto material = [&](std::string_view name) {
        return scene.materials[std::size_t(mesh_called(scene, name).material)];
    };
    EXPECT_GT(material("red wall").diffuse.r, 3.0f * material("red wall").diffuse.g);
    EXPECT_GT(material("green wall").diffuse.g, 2.0f * material("green wall").diffuse.r);
    const auto reflective =
        std::ranges::count_if(scene.materials, [](const Material& m) { return m.reflectance != Vec3(0.0f); });
    EXPECT_EQ(reflective, 1);
    EXPECT_EQ(mesh_called(scene, "mirror face").indices.size(), 6u);
    EXPECT_GT(scene.lights[0].position.y, 1.8f);
    EXPECT_LT(scene.lights[0].position.y, 2.0f);
}

}  // namespace
}  // namespace kd

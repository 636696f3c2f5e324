// What a scene does not need is missed by nobody, and what is left out takes no memory.
#include <map>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/memory_plan.h"
#include "renderer/gl/pass_programs.h"
#include "renderer/measure/needs_check.h"
#include "renderer/measure/needs_costs.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

constexpr int width = 48, height = 32;

/// Flat, matte, of one material, with one light: as little as a picture can need.
FlatScene plain_scene() {
    FlatScene scene = test::mirror_scene(60, 5);
    scene.has_normals = false;
    scene.lights.resize(1);
    for (TriangleAttributes& a : scene.attributes) a.material = int(scene.materials.size());
    scene.materials.push_back(matte(Vec3(0.6f, 0.5f, 0.4f)));
    return scene;
}

NeedsCheckReport check(const FlatScene& scene, const TraceConfig& trace) {
    NeedsCheckConfig config;
    config.width = width;
    config.height = height;
    config.trace = trace;
    config.traversals = {trace.traversal};
    config.contexts = {ContextKind::osmesa};
    config.threads = 1;
    return check_needs(scene, build_tree(scene.triangles, {}), config);
}

/// Rows by machine and feature.
std::map<std::string, int> rows_of(const NeedsCheckReport& report) {
    std::map<std::string, int> rows;
    for (const NeedsCheckRow& row : report.rows) {
        ++rows[row.tracer + " " + row.feature];
        EXPECT_TRUE(row.good()) << row.tracer << " " << row.traversal << " with " << row.feature << ": " << row.colours
                                << " colours, " << row.hits << " hits, " << row.counters << " counters differ";
    }
    return rows;
}

bool has_context() {
    try {
        (void)Context::create(ContextKind::osmesa);
        return true;
    } catch (const ContextError&) {
        return false;
    }
}

TEST(NeedsCheck, PlainSceneMissesNothing) {
    if (!has_context()) GTEST_SKIP() << "NO CONTEXT";
    auto rows = rows_of(check(plain_scene(), {}));
    for (const char* feature : {"reflections", "many-lights", "directional-lights", "spot-lights", "highlights",
                                "emission", "textures", "mip-maps", "wraps", "normal-maps", "masks", "normals",
                                "material-numbers", "wide-references", "deep-tree", "node-boxes", "leaf-copies", "all"})
        EXPECT_EQ(rows[std::string("gl-fragment ") + feature], 1) << feature;
    for (const char* feature : {"reflections", "highlights", "emission", "textures", "mip-maps", "wraps", "normal-maps",
                                "masks", "normals", "node-boxes", "leaf-copies", "all"})
        EXPECT_EQ(rows[std::string("cpu ") + feature], 1) << feature;
    EXPECT_EQ(rows.size(), 32u);
}

TEST(NeedsCheck, AnImageMissesNothingThatImagesMayHave) {
    if (!has_context()) GTEST_SKIP() << "NO CONTEXT";
    const FlatScene sheet = flatten(*make_procedural("sheet:200"));
    ASSERT_TRUE(scene_needs(sheet, KdTree{}, {}).textures);
    auto rows = rows_of(check(sheet, {}));
    for (const char* feature : {"mip-maps", "wraps", "normal-maps", "masks"})
        EXPECT_EQ(rows[std::string("gl-fragment ") + feature] + rows[std::string("cpu ") + feature], 2) << feature;
    const SceneNeeds needs = scene_needs(flatten(*make_procedural("topiary:20")), KdTree{}, {});
    EXPECT_TRUE(needs.mip_maps && needs.wraps && needs.normal_maps && needs.masks) << "a scene that has them all";
}

TEST(NeedsCheck, NobodyMissesSixteenBytesANode) {
    if (!has_context()) GTEST_SKIP() << "NO CONTEXT";
    auto rows = rows_of(check(plain_scene(), {.traversal = Traversal::restart, .nodes = NodeEncoding::packed}));
    EXPECT_EQ(rows["gl-fragment wide-nodes"] + rows["cpu wide-nodes"], 2);
}

TEST(NeedsCheck, DarkSceneMissesNoShadows) {
    if (!has_context()) GTEST_SKIP() << "NO CONTEXT";
    FlatScene scene = plain_scene();
    scene.lights.clear();
    auto rows = rows_of(check(scene, {}));
    EXPECT_EQ(rows["gl-fragment shadows"] + rows["gl-fragment placed-lights"] + rows["cpu shadows"], 3);
}

TEST(NeedsCheck, SunlitSceneMissesNoPlacedLights) {
    if (!has_context()) GTEST_SKIP() << "NO CONTEXT";
    FlatScene scene = plain_scene();
    scene.lights[0].kind = KD_LIGHT_DIRECTIONAL;
    scene.lights[0].direction = Vec3(0, -1, 0);
    auto rows = rows_of(check(scene, {.traversal = Traversal::restart}));
    EXPECT_EQ(rows["gl-fragment placed-lights"] + rows["gl-fragment deep-tree"], 2);
}

TEST(NeedsCheck, MirrorsMissNoBounceThatCannotCount) {
    if (!has_context()) GTEST_SKIP() << "NO CONTEXT";
    const TraceConfig trace{.reflection_depth = 4, .least_contribution = 0.3f};
    const FlatScene scene = test::mirror_scene(60, 6);
    const SceneNeeds needs = scene_needs(scene, build_tree(scene.triangles, {}), trace);
    ASSERT_TRUE(needs.bounces >= 1 && needs.bounces < 4) << needs.bounces;
    auto rows = rows_of(check(scene, trace));
    EXPECT_EQ(rows["gl-fragment later-bounces"] + rows["cpu later-bounces"], 2);
}

TEST(NeedsCheck, SeesOneBitOfDifference) {
    Frame a(3, 2);
    EXPECT_TRUE(compare_frames(a, a).good());
    Frame b = a;
    b.colour.pixels[4].y = std::nextafter(b.colour.pixels[4].y, 1.0f);
    EXPECT_EQ(compare_frames(a, b).colours, 1);
    EXPECT_FALSE(compare_frames(a, b).good());
    b = a;
    b.layers[0].hit.pixels[2].u = -0.0f;
    EXPECT_EQ(compare_frames(a, b).hits, 1) << "the other zero";
    b = a;
    ++b.layers[0].counters.pixels[1].leaves;
    EXPECT_EQ(compare_frames(a, b).counters, 1);
    b = a;
    ++b.layers[2].counters.pixels[1].leaves;
    EXPECT_EQ(compare_frames(a, b).others[2], 1);
    EXPECT_TRUE(compare_frames(a, b).good()) << "of rays that the feature adds: told, not judged";
}

TEST(NeedsCheck, NothingCheckedIsNoPass) {
    EXPECT_FALSE(NeedsCheckReport{}.passed());
    NeedsCheckReport report;
    report.rows.emplace_back();
    EXPECT_FALSE(report.passed()) << "a row of no pixels";
}

class NeedsGl : public ContextTest {};
KD_FOR_ALL_CONTEXTS(NeedsGl);

void expect_equal(const GlMemory& found, const GlMemory& planned, std::string_view what) {
    EXPECT_EQ(found.nodes, planned.nodes) << what;
    EXPECT_EQ(found.boxes, planned.boxes) << what;
    EXPECT_EQ(found.references, planned.references) << what;
    EXPECT_EQ(found.triangles, planned.triangles) << what;
    EXPECT_EQ(found.attributes, planned.attributes) << what;
    EXPECT_EQ(found.textures, planned.textures) << what;
    EXPECT_EQ(found.targets, planned.targets) << what;
}

TEST_P(NeedsGl, UploadsAreWhatIsReported) {
    for (const bool plain : {true, false}) {
        const FlatScene scene = plain ? plain_scene() : test::mirror_scene(60, 5);
        const KdTree tree = build_tree(scene.triangles, {});
        const SceneFacts facts = scene_facts(scene, tree);
        const TraceConfig trace{.nodes = plain ? NodeEncoding::packed : NodeEncoding::float4,
                                .reflection_depth = plain ? 1 : 3};
        GlTracer tracer(*context);
        tracer.upload(scene, tree);
        const auto memory = [&](FeatureSet forced) {
            GlTraceConfig config;
            config.trace = trace;
            config.trace.forced = forced;
            tracer.prepare(config, width, height);
            const SceneNeeds needs = scene_needs(facts, config.trace);
            expect_equal(tracer.memory(), planned_memory(scene, tree, needs, width, height), "forced");
            return tracer.memory().total();
        };
        const std::int64_t without = memory({});
        for (const Feature feature : removable(facts, trace, false)) {
            EXPECT_EQ(memory(feature) - without,
                      feature_bytes(feature, scene, tree, facts, trace, std::nullopt, width, height))
                << info(feature).name;
            EXPECT_EQ(memory({}), without) << info(feature).name << " was let go";
        }
    }
}

TEST(NeedsBytes, OfTheCpusTables) {
    const FlatScene scene = plain_scene();
    const KdTree tree = build_tree(scene.triangles, {});
    const SceneFacts facts = scene_facts(scene, tree);
    CpuTracer tracer(scene, tree);
    for (const Feature feature : removable(facts, {}, true)) {
        tracer.prepare({.forced = feature});
        EXPECT_EQ(tracer.table_bytes(), feature_bytes(feature, scene, tree, facts, {}, CpuMode::scalar, width, height))
            << info(feature).name;
    }
    tracer.prepare({});
    EXPECT_EQ(tracer.table_bytes(), 0);
    TraceConfig packed{.nodes = NodeEncoding::packed};
    tracer.prepare(packed);
    EXPECT_EQ(tracer.table_bytes(), std::int64_t(8 * tree.nodes.size()));
    EXPECT_EQ(feature_bytes(Feature::wide_nodes, scene, tree, facts, packed, CpuMode::scalar, width, height),
              -tracer.table_bytes())
        << "the tree's own nodes have 16 bytes: on the CPU those of 8 are a table more";
    packed.forced = Feature::wide_nodes;
    tracer.prepare(packed);
    EXPECT_EQ(tracer.table_bytes(), 0);
}

TEST(NeedsPrograms, EachFeatureThatIsCodeMakesOtherPrograms) {
    const FlatScene scene = plain_scene();
    const KdTree tree = build_tree(scene.triangles, {});
    const SceneFacts facts = scene_facts(scene, tree);
    const auto shading = [&](const TraceConfig& trace, Step step) {
        ProgramSettings settings;
        settings.trace = trace;
        settings.needs = scene_needs(facts, trace);
        return program_key(step, settings);
    };
    for (const Feature feature : {Feature::many_lights, Feature::directional_lights, Feature::spot_lights,
                                  Feature::highlights, Feature::emission, Feature::textures, Feature::normals,
                                  Feature::material_numbers, Feature::deep_tree, Feature::leaf_copies})
        EXPECT_NE(shading({.forced = feature}, Step::shade_prim), shading({}, Step::shade_prim)) << info(feature).name;
    constexpr TraceConfig packed{.nodes = NodeEncoding::packed};
    TraceConfig wide = packed;
    wide.forced = Feature::wide_nodes;
    EXPECT_NE(shading(packed, Step::shade_prim), shading({}, Step::shade_prim));
    EXPECT_EQ(shading(wide, Step::shade_prim), shading({}, Step::shade_prim));
    for (const Traversal traversal : {Traversal::naive, Traversal::backtrack}) {
        TraceConfig config = packed;
        config.traversal = traversal;
        EXPECT_EQ(shading(config, Step::shade_prim), shading({.traversal = traversal}, Step::shade_prim))
            << "which reads none, or others";
    }
    EXPECT_NE(shading({.forced = Feature::reflections}, Step::rt_prim), shading({}, Step::rt_prim));
    // Tables alone.
    for (const Feature feature : {Feature::wide_references, Feature::node_boxes})
        EXPECT_EQ(shading({.forced = feature}, Step::shade_prim), shading({}, Step::shade_prim)) << info(feature).name;
}

TEST(NeedsTimes, AreOfEachFeatureAlone) {
    const std::vector<Feature> features{Feature::textures, Feature::normals};
    std::vector<FeatureSet> seen;
    const auto frame = [&](FeatureSet forced) {
        seen.push_back(forced);
        return TimeSample{forced.has(Feature::textures) ? 12.0 : 10.0, 11.0};
    };
    const std::vector<FeatureTime> times = time_features(features, frame, 6);
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].feature, Feature::textures);
    EXPECT_DOUBLE_EQ(times[0].saved.median, 2);
    EXPECT_DOUBLE_EQ(times[0].share(), 0.2);
    EXPECT_NEAR(times[0].clock_discrepancy, 0.1, 1e-12) << "of the frames without: 11 over 10";
    EXPECT_TRUE(times[0].seen());
    EXPECT_DOUBLE_EQ(times[1].saved.median, 0);
    EXPECT_FALSE(times[1].seen());
    ASSERT_EQ(seen.size(), 6u * 3 * 2) << "each frame once for warmth and once for time, in turn";
    const FeatureSet none{}, images(Feature::textures), normals(Feature::normals);
    const std::vector<FeatureSet> there_and_back{none,    none,    images, images, normals, normals,
                                                 normals, normals, images, images, none,    none};
    EXPECT_TRUE(std::equal(there_and_back.begin(), there_and_back.end(), seen.begin()))
        << "a machine that grows slower favours nobody";

    EXPECT_TRUE(time_features(features, frame, 3, [](float done) { return done < 0.5f; }).empty()) << "stopped";
}

}  // namespace
}  // namespace kd

// What scenes and settings call for, and the lines that tell what is left out.

#include "renderer/scene/needs.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "renderer/kdtree/build.h"
#include "renderer/scene/needs_sizes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural.h"

namespace kd {
namespace {

/// A triangle of each material but the last, which nothing uses.
FlatScene with_materials(const std::vector<Material>& materials) {
    FlatScene flat;
    flat.materials = materials;
    add_texture(flat, plain_texture(Image<Rgba8>(1, 1)));
    for (std::size_t i = 0; i + 1 < materials.size(); ++i) {
        flat.triangles.push_back({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
        flat.attributes.emplace_back().material = int(i);
    }
    flat.lights.push_back(point_light(Vec3(1.0f), Vec3(1.0f)));
    return flat;
}

FlatScene plain() { return with_materials({matte(Vec3(0.5f)), matte(Vec3(0.5f))}); }

Material mirror(Vec3 reflectance) {
    Material material = matte(Vec3(0.5f));
    material.reflectance = reflectance;
    return material;
}

Material textured() {
    Material material = matte(Vec3(0.5f));
    material.texture = 0;
    return material;
}

SceneNeeds needs_of(const FlatScene& scene, const TraceConfig& config = {}) {
    return scene_needs(scene, KdTree{}, config);
}

/// Features in use, without those that every picture has.
std::set<std::string> in_use(const SceneNeeds& needs) {
    std::set<std::string> names;
    for (const FeatureInfo& feature : features())
        if (needs.*feature.in_use) names.emplace(feature.name);
    EXPECT_EQ(names.erase("counters") + names.erase("exact-products") + names.erase("wide-nodes"), 3u);
    return names;
}

using Names = std::set<std::string>;

std::string why_not(Feature feature, const FlatScene& scene, const TraceConfig& config = {}) {
    const FeatureNeed need = info(feature).need(scene_facts(scene, KdTree{}), config);
    EXPECT_FALSE(need.needed);
    return need.why;
}

bool can_return(Feature feature, const FlatScene& scene, const TraceConfig& config) {
    return info(feature).need(scene_facts(scene, KdTree{}), config).can_return;
}

TEST(SceneNeeds, PlainSceneNeedsItsLightAndShadows) {
    EXPECT_EQ(in_use(needs_of(plain())), (Names{"shadows", "placed-lights"}));
    const std::vector<std::string> lines = left_out(scene_facts(plain(), KdTree{}), {}, false);
    EXPECT_EQ(lines.front(), "RTRefl, ShadeRefl: no reflective material");
    EXPECT_NE(std::ranges::find(lines, "texture fetch: no textured material"), lines.end());
    EXPECT_NE(std::ranges::find(lines, "interpolated normals: all normals are flat"), lines.end());
    EXPECT_EQ(lines.size(), features().size() - 5);
}

TEST(SceneNeeds, TheCpuIsNotToldWhatOnlyTheGpusProgramsLeaveOut) {
    const SceneFacts facts = scene_facts(plain(), KdTree{});
    const std::vector<std::string> cpu = left_out(facts, {}, true), gpu = left_out(facts, {}, false);
    const auto names = [](const std::vector<std::string>& lines, std::string_view title) {
        return std::ranges::any_of(lines, [&](const std::string& line) { return line.starts_with(title); });
    };
    EXPECT_TRUE(names(gpu, "spot lights") && names(gpu, "loop over lights"));
    EXPECT_FALSE(names(cpu, "spot lights") || names(cpu, "loop over lights"));
    EXPECT_TRUE(names(cpu, "texture fetch"));
    for (const FeatureInfo& feature : features())
        EXPECT_EQ(names(cpu, feature.title), feature.on_cpu && names(gpu, feature.title)) << feature.name;
}

TEST(SceneNeeds, WhyOneFeatureIsLeftOut) {
    const SceneFacts facts = scene_facts(plain(), KdTree{});
    EXPECT_EQ(why_left_out(Feature::reflections, facts, {}), "no reflective material");
    EXPECT_EQ(why_left_out(Feature::reflections, facts, {.reflection_depth = 0}), "switched off");
    EXPECT_EQ(why_left_out(Feature::reflections, facts, {.forced = Feature::reflections}), "") << "put back";
    EXPECT_EQ(why_left_out(Feature::shadows, facts, {}), "") << "needed";
}

TEST(SceneNeeds, OnlyUsedMaterialsCount) {
    const FlatScene unused = with_materials({matte(Vec3(0.5f)), mirror(Vec3(0.5f))});
    EXPECT_FALSE(needs_of(unused).reflections);
    EXPECT_FALSE(needs_of(unused).material_numbers);
    EXPECT_FALSE(needs_of(with_materials({matte(Vec3(0.5f)), textured()})).textures);

    const FlatScene used = with_materials({mirror(Vec3(0.5f)), textured(), matte(Vec3(0.5f))});
    EXPECT_EQ(in_use(needs_of(used)),
              (Names{"textures", "shadows", "placed-lights", "reflections", "material-numbers"}));
    EXPECT_EQ(needs_of(used).bounces, 1);
}

TEST(SceneNeeds, TheOnlyMaterialNeedNotBeTheFirst) {
    FlatScene flat = with_materials({matte(Vec3(0.5f)), matte(Vec3(0.7f))});
    flat.attributes[0].material = 1;
    EXPECT_EQ(needs_of(flat).only_material, 1);
    EXPECT_FALSE(needs_of(flat).material_numbers);
}

TEST(SceneNeeds, OneChannelOfReflectanceIsEnough) {
    EXPECT_TRUE(needs_of(with_materials({mirror({0, 0, 0.3f}), matte(Vec3(1.0f))})).reflections);
}

TEST(SceneNeeds, ReflectanceBelowTheLeastContributionIsLeftOut) {
    const FlatScene flat = with_materials({mirror(Vec3(0.25f)), matte(Vec3(1.0f))});
    EXPECT_TRUE(needs_of(flat, {.least_contribution = 0.25f}).reflections) << "equal counts, as in the passes";
    EXPECT_FALSE(needs_of(flat, {.least_contribution = 0.26f}).reflections);
    EXPECT_EQ(why_not(Feature::reflections, flat, {.least_contribution = 0.26f}),
              "no material reflects as much as the least contribution of 0.26");
    // With no least contribution a black mirror still reflects nothing.
    const FlatScene black = with_materials({mirror(Vec3(0.0f)), matte(Vec3(1.0f))});
    EXPECT_FALSE(needs_of(black, {.least_contribution = 0.0f}).reflections);
}

TEST(SceneNeeds, DepthZeroSwitchesReflectionOff) {
    const FlatScene flat = with_materials({mirror(Vec3(0.5f)), matte(Vec3(1.0f))});
    EXPECT_EQ(needs_of(flat, {.reflection_depth = 0}).bounces, 0);
    EXPECT_EQ(why_not(Feature::reflections, flat, {.reflection_depth = 0}), "switched off");
    EXPECT_FALSE(can_return(Feature::reflections, flat, {.reflection_depth = 0})) << "it would change the picture";
}

TEST(SceneNeeds, BouncesEndWhereNoPathCanCount) {
    const FlatScene flat = with_materials({mirror(Vec3(0.25f)), mirror({0.5f, 0, 0}), mirror(Vec3(1.0f))});
    // 0.5, 0.25, 0.125 count against 0.1; 0.0625 does not.
    TraceConfig config{.reflection_depth = 8, .least_contribution = 0.1f};
    EXPECT_EQ(needs_of(flat, config).bounces, 3);
    EXPECT_EQ(why_not(Feature::later_bounces, flat, config),
              "after bounce 3 no path can still reach the least contribution of 0.1");
    config.forced = Feature::later_bounces;
    EXPECT_EQ(needs_of(flat, config).bounces, 8);
    EXPECT_EQ(needs_of(flat, {.reflection_depth = 2, .least_contribution = 0.1f}).bounces, 2);
    const FlatScene perfect = with_materials({mirror(Vec3(1.0f)), matte(Vec3(1.0f))});
    EXPECT_EQ(needs_of(perfect, {.reflection_depth = 100}).bounces, 100);
    EXPECT_TRUE(needs_of(perfect, {.reflection_depth = 100}).later_bounces);
}

TEST(SceneNeeds, ShadowsNeedALightAndTheSwitch) {
    FlatScene flat = plain();
    const TraceConfig off{.shadows = false, .forced = Feature::shadows};
    EXPECT_FALSE(needs_of(flat, off).shadows) << "what a person switched off stays off";
    EXPECT_EQ(why_not(Feature::shadows, flat, off), "switched off");
    flat.lights.clear();
    EXPECT_FALSE(needs_of(flat).shadows);
    EXPECT_EQ(why_not(Feature::shadows, flat), "no light");
    EXPECT_TRUE(needs_of(flat, {.forced = Feature::shadows}).shadows);
}

TEST(SceneNeeds, LightsByNumberAndKind) {
    FlatScene flat = plain();
    EXPECT_EQ(needs_of(flat).lights, 1);
    flat.lights[0].kind = KD_LIGHT_DIRECTIONAL;
    EXPECT_EQ(in_use(needs_of(flat)), (Names{"shadows", "directional-lights"}));
    flat.lights.push_back(point_light(Vec3(1.0f), Vec3(1.0f)));
    flat.lights[1].kind = KD_LIGHT_SPOT;
    EXPECT_EQ(in_use(needs_of(flat)),
              (Names{"shadows", "directional-lights", "placed-lights", "spot-lights", "many-lights"}));
    flat.lights.clear();
    EXPECT_TRUE(in_use(needs_of(flat)).empty());
}

TEST(SceneNeeds, HighlightsNeedASpecularColour) {
    Material shiny = matte(Vec3(0.5f));
    shiny.specular = Vec3(0, 0, 0.1f);
    EXPECT_TRUE(needs_of(with_materials({shiny, matte(Vec3(0.5f))})).highlights);
    EXPECT_FALSE(needs_of(with_materials({matte(Vec3(0.5f)), shiny})).highlights) << "nothing has this material";
}

TEST(SceneNeeds, EmissionNeedsAMaterialThatEmits) {
    Material lamp = matte(Vec3(0.5f));
    lamp.emission = Vec3(0, 0, 0.1f);
    EXPECT_TRUE(needs_of(with_materials({lamp, matte(Vec3(0.5f))})).emission);
    EXPECT_FALSE(needs_of(with_materials({matte(Vec3(0.5f)), lamp})).emission) << "nothing has this material";
    // An image that tints nothing is not fetched.
    lamp.emission_texture = 0;
    EXPECT_TRUE(needs_of(with_materials({lamp, matte(Vec3(0.5f))})).textures);
    lamp.emission = Vec3(0.0f);
    EXPECT_FALSE(needs_of(with_materials({lamp, matte(Vec3(0.5f))})).textures);
}

TEST(SceneNeeds, ImagesAreAskedForByWhatTheyHave) {
    const auto in_use_with = [](const Material& material, const Texture& texture) {
        FlatScene flat = with_materials({material, matte(Vec3(0.5f))});
        flat.textures.clear();
        add_texture(flat, texture);
        return in_use(needs_of(flat));
    };
    const Names always{"shadows", "placed-lights"};
    const auto and_also = [&](Names names) {
        names.insert(always.begin(), always.end());
        return names;
    };
    const Texture plain_image = plain_texture(Image<Rgba8>(2, 2));
    const Texture halved = mip_mapped_texture(Image<Rgba8>(2, 2), TexelKind::colour);
    Texture clamped = plain_image;
    clamped.wrap_y = KD_WRAP_CLAMP;
    EXPECT_EQ(in_use_with(matte(Vec3(0.5f)), halved), always) << "no material shows it";
    EXPECT_EQ(in_use_with(textured(), plain_image), and_also({"textures"}));
    EXPECT_EQ(in_use_with(textured(), halved), and_also({"textures", "mip-maps"}));
    EXPECT_EQ(in_use_with(textured(), clamped), and_also({"textures", "wraps"}));
    Material bent = matte(Vec3(0.5f));
    bent.normal_texture = 0;
    EXPECT_EQ(in_use_with(bent, halved), and_also({"normal-maps", "mip-maps"}));
    Material cut = textured();
    cut.alpha_cutoff = 0.5f;
    EXPECT_EQ(in_use_with(cut, plain_image), and_also({"textures", "masks"}));
}

TEST(SceneNeeds, LeafListsGrowWideWithTheScene) {
    SceneFacts facts;
    facts.triangles = narrow_numbers;  // 0..65535
    EXPECT_FALSE(scene_needs(facts, {}).wide_references);
    ++facts.triangles;
    EXPECT_TRUE(scene_needs(facts, {}).wide_references);
}

TEST(SceneNeeds, RoomForTheTreeThatIsThere) {
    SceneFacts facts;
    for (const auto& [deepest, levels] : {std::pair(0, 8), {8, 8}, {9, 16}, {33, 48}, {49, 64}, {64, 64}}) {
        facts.deepest_leaf = deepest;
        EXPECT_EQ(scene_needs(facts, {}).levels, levels) << deepest;
        EXPECT_EQ(scene_needs(facts, {}).deep_tree, levels == 64) << deepest;
    }
    // A restart trail has one word or two.
    const TraceConfig restart{.traversal = Traversal::restart};
    facts.deepest_leaf = 33;
    EXPECT_TRUE(scene_needs(facts, restart).deep_tree);
    facts.deepest_leaf = 32;
    EXPECT_FALSE(scene_needs(facts, restart).deep_tree);
    EXPECT_FALSE(info(Feature::deep_tree).need(facts, {.traversal = Traversal::backtrack}).can_return);
}

TEST(SceneNeeds, OfTheWalkAndTheLeafLists) {
    EXPECT_TRUE(needs_of(plain(), {.traversal = Traversal::backtrack}).node_boxes);
    EXPECT_TRUE(needs_of(plain(), {.leaf_lists = LeafLists::duplicated}).leaf_copies);
    EXPECT_FALSE(needs_of(plain(), {.counters = false}).counters);
}

TEST(SceneNeeds, WideNodesForThoseWhoChooseThemAndForWalksThatClimb) {
    constexpr TraceConfig packed{.nodes = NodeEncoding::packed};
    EXPECT_TRUE(needs_of(plain()).wide_nodes);
    EXPECT_FALSE(needs_of(plain(), packed).wide_nodes);
    for (const TraversalInfo& walk : traversals()) {
        TraceConfig config = packed;
        config.traversal = walk.id;
        EXPECT_EQ(needs_of(plain(), config).wide_nodes, walk.id == Traversal::backtrack) << walk.name;
        EXPECT_EQ(nodes_in_force(config) == NodeEncoding::float4, walk.id == Traversal::backtrack) << walk.name;
    }
    TraceConfig forced = packed;
    forced.forced = Feature::wide_nodes;
    EXPECT_TRUE(needs_of(plain(), forced).wide_nodes);
}

TEST(SceneNeeds, ForcedFeaturesReturnOneByOne) {
    const SceneFacts facts = scene_facts(plain(), KdTree{});
    const SceneNeeds before = scene_needs(facts, {});
    const std::vector<Feature> all = removable(facts, {}, false);
    EXPECT_GE(all.size(), 10u);
    for (const Feature feature : all) {
        const SceneNeeds with = scene_needs(facts, {.forced = feature});
        EXPECT_FALSE(with == before) << info(feature).name;
        for (const FeatureInfo& other : features())
            EXPECT_EQ(with.*other.in_use, other.id == feature || before.*other.in_use)
                << info(feature).name << " brought " << other.name;
    }
    EXPECT_LT(removable(facts, {}, true).size(), all.size()) << "the CPU has fewer to leave out";
}

TEST(SceneNeeds, OfTheProceduralScenes) {
    const auto needs = [](const char* name) {
        const FlatScene scene = flatten(make_procedural(name).value());
        return in_use(scene_needs(scene, build_tree(scene.triangles, {}), {}));
    };
    const Names lit{"shadows", "placed-lights"};
    const auto with = [&](Names more) {
        more.insert(lit.begin(), lit.end());
        return more;
    };
    EXPECT_EQ(needs("ball:1000"), with({"normals", "reflections", "highlights", "material-numbers"}));
    EXPECT_EQ(needs("icoball:1000"), needs("ball:1000"));
    EXPECT_EQ(needs("rooms"), with({"material-numbers", "highlights"}));
    EXPECT_EQ(needs("scatter:100"), with({"material-numbers"}));
    EXPECT_EQ(needs("sheet:100"), with({"textures", "normals", "highlights"}));
    EXPECT_EQ(needs("cornell"), with({"reflections", "material-numbers"}));
}

}  // namespace
}  // namespace kd

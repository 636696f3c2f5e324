// The table of features: what each is, and which scenes and settings need it.
#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "renderer/scene/needs.h"
#include "renderer/scene/needs_sizes.h"
#include "renderer/trace/walk_choices.h"

namespace kd {

namespace {

using Facts = const SceneFacts&;
using Config = const TraceConfig&;

FeatureNeed needed(std::string why) { return {true, std::move(why), false}; }
/// Not needed, and it would do no harm.
FeatureNeed idle(std::string why) { return {false, std::move(why), true}; }
/// Not there because somebody chose so: with it, the picture or the walk would be another.
FeatureNeed refused(std::string why) { return {false, std::move(why), false}; }

std::string counted(std::int64_t n, std::string_view what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

FeatureNeed reflections(Facts f, Config c) {
    if (c.reflection_depth <= 0) return refused("switched off");
    if (countable_bounces(f, c) > 0) return needed(fmt::format("materials mirror up to {}", f.largest_reflectance));
    if (!(f.largest_reflectance > 0.0f)) return idle("no reflective material");
    return idle(fmt::format("no material reflects as much as the least contribution of {}", c.least_contribution));
}

FeatureNeed later_bounces(Facts f, Config c) {
    if (c.reflection_depth <= 1) return refused("no second bounce is asked for");
    const int bounces = countable_bounces(f, c);
    if (bounces == 0) return refused("nothing reflects once");
    if (bounces == c.reflection_depth) return needed(fmt::format("paths can count after {} bounces", bounces));
    return idle(fmt::format("after bounce {} no path can still reach the least contribution of {}", bounces,
                            c.least_contribution));
}

FeatureNeed shadows(Facts f, Config c) {
    if (!c.shadows) return refused("switched off");
    return f.lights > 0 ? needed(counted(f.lights, "light")) : idle("no light");
}

FeatureNeed many_lights(Facts f, Config) {
    return f.lights > 1 ? needed(counted(f.lights, "light")) : idle(f.lights == 1 ? "one light" : "no light");
}

FeatureNeed directional_lights(Facts f, Config) {
    return f.directional_lights > 0 ? needed(counted(f.directional_lights, "directional light"))
                                    : idle("no directional light");
}

FeatureNeed placed_lights(Facts f, Config) {
    const int placed = f.lights - f.directional_lights;
    return placed > 0 ? needed(counted(placed, "point or spot light")) : idle("no point or spot light");
}

FeatureNeed spot_lights(Facts f, Config) {
    return f.spot_lights > 0 ? needed(counted(f.spot_lights, "spot light")) : idle("no spot light");
}

FeatureNeed highlights(Facts f, Config) {
    if (f.lights == 0) return idle("no light");
    return f.highlights ? needed("a material has a specular colour") : idle("no material has a specular colour");
}

FeatureNeed emission(Facts f, Config) {
    return f.emission ? needed("a material emits light") : idle("no material emits light");
}

/// Why an effect of sampled light was not chosen; empty where it was.
std::string unchosen(Config c, bool Sampling::*effect) {
    if (c.sampling.sample < 0) return "light is not sampled";
    return c.sampling.*effect ? "" : "switched off";
}

FeatureNeed soft_shadows(Facts f, Config c) {
    if (const std::string why = unchosen(c, &Sampling::soft_shadows); !why.empty()) return refused(why);
    return f.large_lights > 0 ? needed(counted(f.large_lights, "light with a radius")) : idle("all lights are points");
}

FeatureNeed gloss(Facts f, Config c) {
    if (const std::string why = unchosen(c, &Sampling::gloss); !why.empty()) return refused(why);
    if (countable_bounces(f, c) == 0) return idle("nothing is reflected");
    if (f.roughest_reflection > 0.0f) return needed(fmt::format("roughness up to {}", f.roughest_reflection));
    return idle("what reflects is a mirror");
}

FeatureNeed indirect(Facts f, Config c) {
    if (const std::string why = unchosen(c, &Sampling::indirect); !why.empty()) return refused(why);
    return f.diffuse ? needed("a material scatters light") : idle("no material scatters light");
}

FeatureNeed textures(Facts f, Config) {
    return f.textures ? needed("a material has an image") : idle("no textured material");
}

FeatureNeed mip_maps(Facts f, Config) {
    return f.mip_maps ? needed("an image has mip maps") : idle("no image has mip maps");
}

FeatureNeed wraps(Facts f, Config) {
    return f.wraps ? needed("an image is clamped or mirrored") : idle("all images repeat");
}

FeatureNeed normal_maps(Facts f, Config) {
    return f.normal_maps ? needed("a material has an image of normals") : idle("no material has an image of normals");
}

FeatureNeed masks(Facts f, Config) { return f.masks ? needed("a material has holes") : idle("no material has holes"); }

FeatureNeed normals(Facts f, Config) {
    return f.normals ? needed("vertex normals differ from the flat ones") : idle("all normals are flat");
}

FeatureNeed material_numbers(Facts f, Config) {
    return f.materials > 1 ? needed(counted(f.materials, "material")) : idle("all triangles have one material");
}

FeatureNeed wide_references(Facts f, Config) {
    const std::string triangles = counted(f.triangles, "triangle");
    return f.triangles > narrow_numbers ? needed(fmt::format("{}; 16 bits number {}", triangles, narrow_numbers))
                                        : idle(fmt::format("16 bits number {}", triangles));
}

FeatureNeed deep_tree(Facts f, Config c) {
    const TraversalInfo& walk = info(c.traversal);
    const bool trail = walk.has(walk_trail) && rules_in_force(c) == Rules::robust;
    if (!walk.has(walk_stack) && !trail) return refused("this walk keeps neither stack nor trail");
    const int levels = compiled_levels(f.deepest_leaf);
    const bool full = levels == max_tree_depth || (trail && f.deepest_leaf > short_trail);
    const std::string deepest = fmt::format("the deepest leaf lies at {}", f.deepest_leaf);
    return full ? needed(deepest) : idle(fmt::format("{}, {} are enough", deepest, trail ? short_trail : levels));
}

FeatureNeed wide_nodes(Facts, Config c) {
    const TraversalInfo& walk = info(c.traversal);
    if (walk.has(walk_parents)) return needed(fmt::format("{} climbs to parents", walk.name));
    if (nodes_in_force(c) == NodeEncoding::float4) return needed("nodes of 16 bytes are chosen");
    return idle("nodes of 8 bytes are chosen");
}

FeatureNeed node_boxes(Facts, Config c) {
    const TraversalInfo& walk = info(c.traversal);
    if (walk.has(walk_boxes)) return needed(fmt::format("{} reads them", walk.name));
    if (enters_by_tile(c)) return needed("entry points of tiles are cells to enter");
    return idle(fmt::format("{} has its interval instead", walk.name));
}

FeatureNeed ropes(Facts, Config c) {
    const TraversalInfo& walk = info(c.traversal);
    return walk.has(walk_ropes) ? needed("the walk goes along them") : idle(fmt::format("{} follows none", walk.name));
}

FeatureNeed leaf_copies(Facts, Config c) {
    if (c.leaf_lists == LeafLists::duplicated) return needed("leaf lists of copies are chosen");
    return idle("leaves hold triangle numbers");
}

FeatureNeed counters(Facts, Config c) {
    return c.counters ? needed("maps, tables and the note on unfinished pixels read them") : idle("nothing reads them");
}

FeatureNeed exact_products(Facts, Config) {
    return needed("rays through edges occur in any scene, and only the lost digits tell on which side they pass");
}

constexpr std::array table{
    FeatureInfo{Feature::reflections, "reflections", "RTRefl, ShadeRefl",
                "The passes of mirror rays with their targets, and the look at each primary hit's material whether it "
                "mirrors.",
                &SceneNeeds::reflections, true, reflections},
    FeatureInfo{Feature::later_bounces, "later-bounces", "later bounces",
                "RTRefl and ShadeRefl again for every bounce asked for, with a second set of targets to go on from.",
                &SceneNeeds::later_bounces, true, later_bounces},
    FeatureInfo{Feature::shadows, "shadows", "shadow rays",
                "A ray per light and hit in the shading passes, which then hold a whole walk, and the targets of its "
                "hit and counters.",
                &SceneNeeds::shadows, true, shadows},
    FeatureInfo{Feature::many_lights, "many-lights", "loop over lights",
                "Shading any number of lights rather than one or none.", &SceneNeeds::many_lights, false, many_lights},
    FeatureInfo{Feature::directional_lights, "directional-lights", "directional lights",
                "The question at each light whether it is one.", &SceneNeeds::directional_lights, false,
                directional_lights},
    FeatureInfo{Feature::placed_lights, "placed-lights", "lights in a place",
                "Distance and fall-off of point and spot lights.", &SceneNeeds::placed_lights, false, placed_lights},
    FeatureInfo{Feature::spot_lights, "spot-lights", "spot lights", "The cone of light.", &SceneNeeds::spot_lights,
                false, spot_lights},
    FeatureInfo{Feature::highlights, "highlights", "highlights",
                "The specular term: a half-way vector and a power per light.", &SceneNeeds::highlights, true,
                highlights},
    FeatureInfo{Feature::emission, "emission", "emission", "A fourth texel per material, added at each hit.",
                &SceneNeeds::emission, true, emission},
    FeatureInfo{Feature::soft_shadows, "soft-shadows", "soft shadows",
                "A point of each light's disc for each sample, rather than its middle.", &SceneNeeds::soft_shadows,
                true, soft_shadows},
    FeatureInfo{Feature::gloss, "gloss", "glossy reflection",
                "A facet for each mirror ray of a rough surface, rather than its normal.", &SceneNeeds::gloss, true,
                gloss},
    FeatureInfo{Feature::indirect, "indirect", "RTIndirect, ShadeIndirect",
                "The passes of rays that scatter from primary hits to what lights them, with their targets.",
                &SceneNeeds::indirect, true, indirect},
    FeatureInfo{Feature::textures, "textures", "texture fetch",
                "Texture coordinates of every corner, the images, and four texels per hit.", &SceneNeeds::textures,
                true, textures},
    FeatureInfo{Feature::mip_maps, "mip-maps", "mip maps",
                "How much of an image a pixel sees, and eight texels of two of its levels rather than four.",
                &SceneNeeds::mip_maps, true, mip_maps},
    FeatureInfo{Feature::wraps, "wraps", "clamped and mirrored images",
                "The question at each texel how its image goes on beyond its edges.", &SceneNeeds::wraps, true, wraps},
    FeatureInfo{Feature::normal_maps, "normal-maps", "normal maps",
                "Tangents from the corners' texture coordinates, and a look at the image of normals, at each hit.",
                &SceneNeeds::normal_maps, true, normal_maps},
    FeatureInfo{Feature::masks, "masks", "alpha masks",
                "Four texels for each triangle that a ray meets, before that is a hit.", &SceneNeeds::masks, true,
                masks},
    FeatureInfo{Feature::normals, "normals", "interpolated normals", "Three normals per triangle, blended at each hit.",
                &SceneNeeds::normals, true, normals},
    FeatureInfo{Feature::material_numbers, "material-numbers", "material numbers",
                "A number per triangle, looked up at each hit.", &SceneNeeds::material_numbers, false,
                material_numbers},
    FeatureInfo{Feature::wide_references, "wide-references", "32-bit leaf lists",
                "Four bytes per entry of the leaf lists rather than two.", &SceneNeeds::wide_references, false,
                wide_references},
    FeatureInfo{Feature::deep_tree, "deep-tree", "room for 64 levels",
                "A stack of 64 entries, or a restart trail of 64 bits, whatever the tree's depth.",
                &SceneNeeds::deep_tree, false, deep_tree},
    FeatureInfo{Feature::wide_nodes, "wide-nodes", "16-byte nodes",
                "Sixteen bytes per node rather than eight: numbers as floats, and a link to the parent.",
                &SceneNeeds::wide_nodes, true, wide_nodes},
    FeatureInfo{Feature::node_boxes, "node-boxes", "node boxes", "Two corners per node, for walks that climb or cross.",
                &SceneNeeds::node_boxes, true, node_boxes},
    FeatureInfo{Feature::ropes, "ropes", "ropes", "Six links per node, to what lies beyond the faces of its cell.",
                &SceneNeeds::ropes, true, ropes},
    FeatureInfo{Feature::leaf_copies, "leaf-copies", "copies in leaves",
                "Three vertices per entry of the leaf lists, read instead of the triangles'.", &SceneNeeds::leaf_copies,
                true, leaf_copies},
    FeatureInfo{Feature::counters, "counters", "counters", "What every ray did, in two targets per pass.",
                &SceneNeeds::counters, true, counters},
    FeatureInfo{Feature::exact_products, "exact-products", "exact products",
                "Products without rounding error where an edge function rounds to zero: they stand in for a test in "
                "double precision.",
                &SceneNeeds::exact_products, true, exact_products},
};

static_assert(std::ranges::all_of(table, [i = 0](const FeatureInfo& row) mutable { return int(row.id) == i++; }),
              "rows stand in the order of Feature");

}  // namespace

std::span<const FeatureInfo> features() { return table; }

const FeatureInfo& info(Feature feature) { return table[static_cast<std::size_t>(feature)]; }

}  // namespace kd

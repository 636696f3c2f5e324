// The shared text as C++: hooks that read a SceneView and tell an observer, then shaders/shared/kernel.glsl itself.
//
// No include guard and no namespace of its own: tile_kernel.cpp includes it once per instruction set.

/// How leaves are tested: one triangle after the other, as the shared text does.
struct SingleTests {
    template <class Kernel, class Setup>
    KD_FN static void test(Kernel& kernel, const Setup& s, const KdNode& leaf, Hit& hit) {
        kernel.test_leaf(s, leaf, hit);
    }
};

/// `Node` is TreeNode or PackedNode, of which the view has to hold the table: no fetch asks which. `Leaves` is
/// SingleTests, or BlockTests (block_test.h) with a view in blocks.
template <class Observer, Rules rules, class Node = TreeNode, class Leaves = SingleTests>
class Kernel {
  public:
    Kernel(const SceneView& scene_view, const TraceConfig& config, Observer& first)
        : nodes(scene_view.nodes<Node>()), references(scene_view.tree->references.data()),
          blocks(scene_view.leaf_blocks.data()), corners(scene_view.scene->triangles.data()),
          duplicates(scene_view.needs.leaf_copies ? scene_view.duplicated_corners.data() : nullptr), view(scene_view),
          chosen(config.traversal), short_stack(config.short_stack),
          most_steps(config.step_budget > 0 ? config.step_budget : cpu_step_budget), sampling(config.sampling),
          masked(scene_view.needs.masks), observer(&first) {}

    void observe(Observer& next) { observer = &next; }
    /// Where the walks that follow begin: the root, or a node that holds all that their rays can meet.
    void begin_at(int node) { first_node = node; }

    KD_FN const LeafBlock* block_at(int place) const { return blocks + place; }
    KD_FN KdNode fetch_node(int node) const { return node_as_read(nodes[node]); }
    Light fetch_light(int index) const {
        if constexpr (requires { observer->on_light(index); }) observer->on_light(index);
        return view.scene->lights[std::size_t(index)];
    }
    int light_count() const { return int(view.scene->lights.size()); }
    bool shadows_enabled() const { return view.needs.shadows; }
    real3 scene_background() const { return view.scene->background; }

    // Observer; tests/bench/costs_bench.cpp has a twin that tells none.
#ifdef KD_NO_OBSERVER
    KD_FN void on_triangle(int) {}
#else
    KD_FN void on_interior(int node, bool again) { observer->on_interior(node, again); }
    KD_FN void on_leaf(int node) { observer->on_leaf(node); }
    KD_FN void on_triangle(int slot) { observer->on_triangle(slot); }
    KD_FN void on_push(int depth) { observer->on_push(depth); }
    KD_FN void on_restart() { observer->on_restart(); }
    KD_FN void on_backtrack() { observer->on_backtrack(); }
    KD_FN void on_exit(int reason) { observer->on_exit(reason); }
#endif

  private:
    const Node* nodes;
    const std::int32_t* references;
    const LeafBlock* blocks;
    const Triangle* corners;     // by triangle number
    const Triangle* duplicates;  // by slot of the leaf lists; null where leaves go by number
    const SceneView& view;
    Traversal chosen;
    int short_stack;
    int most_steps;
    Sampling sampling;
    bool masked;  // some triangles have holes
    int first_node = 0;
    Observer* observer;

    // Tree.
    KD_FN int fetch_reference(int slot) const { return references[slot]; }
    KD_FN void fetch_bounds(real3& lower, real3& upper) const {
        lower = view.scene->bounds.lower;
        upper = view.scene->bounds.upper;
    }
    KD_FN void fetch_node_box(int node, real3& lower, real3& upper) const {
        lower = view.boxes[std::size_t(node)].lower;
        upper = view.boxes[std::size_t(node)].upper;
    }

    KD_FN int fetch_rope(int node, int face) const {
        return view.ropes[std::size_t(node) * faces_of_a_cell + std::size_t(face)];
    }
    KD_FN int entry_node() const { return first_node; }
    KD_FN int short_stack_entries() const { return short_stack; }

    // Triangles and attributes.
    KD_FN void fetch_corners(int slot, int triangle, int3 axes, real3& a, real3& b, real3& c) const {
        const float* p = &(duplicates && slot >= 0 ? duplicates[slot] : corners[triangle]).corner[0].x;
        a = real3(p[axes.x], p[axes.y], p[axes.z]);
        b = real3(p[3 + axes.x], p[3 + axes.y], p[3 + axes.z]);
        c = real3(p[6 + axes.x], p[6 + axes.y], p[6 + axes.z]);
    }
    const TriangleAttributes& attributes(int triangle) const { return view.scene->attributes[std::size_t(triangle)]; }
    void fetch_normals(int triangle, real3& a, real3& b, real3& c) const {
        const std::array<Vec3, 3> normals = vertex_normals(*view.scene, triangle);
        a = normals[0];
        b = normals[1];
        c = normals[2];
    }
    void fetch_texture_coordinates(int triangle, real2& a, real2& b, real2& c) const {
        const TriangleAttributes& t = attributes(triangle);
        a = t.uv[0];
        b = t.uv[1];
        c = t.uv[2];
    }
    int fetch_material_index(int triangle) const { return attributes(triangle).material; }
    Material fetch_material(int index) const { return view.scene->materials[std::size_t(index)]; }
    TextureImage fetch_texture(int texture) const { return view.scene->textures[std::size_t(texture)]; }
    real4 fetch_texel(int index) const {
        const Rgba8 c = view.scene->texels[std::size_t(index)];
        return real4(c.r, c.g, c.b, c.a);
    }
    int triangle_count() const { return int(view.scene->triangles.size()); }

    // Settings.
    bool scene_has_normals() const { return view.needs.normals; }
    bool scene_has_textures() const { return view.needs.textures; }
    bool scene_has_mip_maps() const { return view.needs.mip_maps; }
    bool scene_has_wraps() const { return view.needs.wraps; }
    bool scene_has_normal_maps() const { return view.needs.normal_maps; }
    KD_FN bool scene_has_masks() const { return masked; }
    bool scene_has_highlights() const { return view.needs.highlights; }
    bool scene_has_emission() const { return view.needs.emission; }
    bool scene_has_directional_lights() const { return true; }
    bool scene_has_placed_lights() const { return true; }
    bool scene_has_spot_lights() const { return true; }
    bool scene_has_soft_shadows() const { return view.needs.soft_shadows; }
    bool scene_has_gloss() const { return view.needs.gloss; }
    bool scene_has_indirect() const { return view.needs.indirect; }
    int sample_number() const { return sampling.sample; }
    uint sample_seed() const { return sampling.seed; }
    real3 scene_ambient() const { return view.scene->ambient; }
    int step_budget() const { return most_steps; }

  public:
#define KD_STACK_SIZE max_tree_depth
#define KD_LONG_TRAIL 1
#define KD_SHORT_STACK max_short_stack
#define KD_TRAVERSE traverse_chosen
#define KD_TEST_LEAF test_chosen
#define KD_RULES int(rules)
#include "shaders/shared/kernel.glsl"
#undef KD_RULES
#undef KD_TEST_LEAF
#undef KD_TRAVERSE
#undef KD_SHORT_STACK
#undef KD_LONG_TRAIL
#undef KD_STACK_SIZE

  private:
    KD_FN void test_chosen(const RaySetup& s, const KdNode& leaf, Hit& hit) { Leaves::test(*this, s, leaf, hit); }

    void traverse_chosen(const RaySetup& s, bool any_hit, Hit& hit) {
        switch (chosen) {
#define KD_TRAVERSAL(name, ...)                                                                                        \
    case Traversal::name:                                                                                              \
        return run_##name(s, any_hit, hit);
#include "shaders/shared/traversals.glsl"
#undef KD_TRAVERSAL
        }
    }

    // One copy of each walk per kernel; every ray type calls it. What needs parents walks no packed nodes: see
    // nodes_in_force().
#define KD_TRAVERSAL(name, label, published, needs, ...)                                                               \
    [[gnu::noinline]] void run_##name(const RaySetup& s, bool any_hit, Hit& hit) {                                     \
        if constexpr (std::is_same_v<Node, PackedNode> && ((needs)&walk_parents) != 0)                                 \
            on_exit(KD_EXIT_INVALID_RAY);                                                                              \
        else if constexpr (rules == Rules::robust)                                                                     \
            traverse_##name(s, any_hit, hit);                                                                          \
        else                                                                                                           \
            published(s, any_hit, hit);                                                                                \
    }
#include "shaders/shared/traversals.glsl"
#undef KD_TRAVERSAL
};

// Every bit of what is uploaded as bits comes back from a shader's texelFetch: leaf lists, tables and rays, whose
// texels are integers, with all that a float texel might lose among them. Float texels (nodes, corners) carry no
// integer's bits: whole numbers stand in them as values (node_texels_gl_test.cpp), and beside them normal floats and
// zeros alone, which come back bit for bit too.

#include <bit>

#include "tests/gl/gl_test.h"
#include "tests/support/environment_variable.h"
#include "tests/support/faulty_shaders.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

class BitPatternsGl : public ContextTest {
  public:
    enum Table { references, tables, rays, nodes, corners };
    using Texel = std::array<std::uint32_t, 4>;

  protected:
    /// What a shader reads of `table` at `at`, whatever else is traced.
    void ask(Table table, std::size_t at, Texel expected, const char* what) {
        rays_.push_back({Vec3(5, 0, 0), Vec3(1, 0, 0), asks_from + float(table), 1, int(at)});
        expected_.push_back({rays_.size() - 1, expected, std::string(what) + " " + std::to_string(at)});
    }
    void expect_all(const FlatScene& scene, const KdTree& tree, const TraceConfig& config);

    std::vector<Ray> rays_;

  private:
    static constexpr float asks_from = 1024;  // t_min of rays that ask
    struct Expected {
        std::size_t ray;
        Texel texel;
        std::string what;
    };
    std::vector<Expected> expected_;
};

std::filesystem::path shaders_that_tell_texels() {
    return test::shaders_with("fragment/rays.frag", "run_pass(this_pixel());", R"(
        run_pass(this_pixel());
        int index = this_pixel().y * frame.rays.z + this_pixel().x;
        float asked = index < frame.rays.y ? uintBitsToFloat(texelFetch(kd_rays, 3 * index).w) - 1024.0 : -1.0;
        int at = int(texelFetch(kd_rays, 3 * index + 2).x);
        if (asked == 0.0) out_hit = uvec4(texelFetch(kd_references, at).x);
        if (asked == 1.0) out_hit = texelFetch(kd_tables, at);
        if (asked == 2.0) out_hit = texelFetch(kd_rays, at);
        if (asked == 3.0) out_hit = floatBitsToUint(texelFetch(kd_nodes, at));
        if (asked == 4.0) out_hit = floatBitsToUint(texelFetch(kd_corners, at));)");
}

void BitPatternsGl::expect_all(const FlatScene& scene, const KdTree& tree, const TraceConfig& config) {
    const test::Variable shaders("KD_SHADER_DIR", shaders_that_tell_texels().string());
    GlTracer tracer(*context);
    tracer.upload(scene, tree);
    std::vector<Hit> told(rays_.size());
    tracer.trace_rays(config, rays_, false, told, {});
    ASSERT_FALSE(expected_.empty());
    for (const auto& [ray, texel, what] : expected_) {
        const Hit& hit = told[ray];
        const Texel found{std::uint32_t(hit.triangle), std::bit_cast<std::uint32_t>(hit.t),
                          std::bit_cast<std::uint32_t>(hit.u), std::bit_cast<std::uint32_t>(hit.v)};
        EXPECT_EQ(found, texel) << what;
    }
}

KD_FOR_ALL_CONTEXTS(BitPatternsGl);

/// Small whole numbers, which are denormal as floats, both zeros, both kinds of NaN, infinities, and all bits.
constexpr std::uint32_t any_bits[] = {0,          1,          2,          0x007fffff, 0x00800000, 0x00ffffff,
                                      0x01000000, 0x01000001, 0x3f800000, 0x4b800001, 0x7f7fffff, 0x7f800000,
                                      0x7f800001, 0x7fc00001, 0x7fffffff, 0x80000000, 0x80000001, 0xff800000,
                                      0xff800001, 0xffc00001, 0xfffffffe, 0xffffffff};
constexpr std::size_t any_count = std::size(any_bits);

/// Both zeros and normal floats from end to end.
constexpr std::uint32_t plain_bits[] = {0x00000000, 0x80000000, 0x00800000, 0x80800001, 0x3f800001,
                                        0xbfffffff, 0x4b7fffff, 0x4b800000, 0x7f7fffff, 0xff7fffff};

std::uint32_t any(std::size_t i) { return any_bits[i % any_count]; }
float as_float(std::uint32_t bits) { return std::bit_cast<float>(bits); }
Vec3 as_floats(std::size_t i) { return {as_float(any(i)), as_float(any(i + 1)), as_float(any(i + 2))}; }

struct Uploaded {
    FlatScene scene = test::scene_of(test::random_soup(1, 0.2f, 1));
    KdTree tree = build_tree(scene.triangles, {});
};

TEST_P(BitPatternsGl, EntriesOfLeafLists) {
    Uploaded u;
    u.tree.references.resize(1);  // what the leaf names; no walk comes to the others
    for (const std::uint32_t bits : any_bits) u.tree.references.push_back(std::bit_cast<std::int32_t>(bits));
    for (std::size_t i = 0; i < any_count; ++i) ask(references, i + 1, {any(i), any(i), any(i), any(i)}, "entry");
    expect_all(u.scene, u.tree, {.forced = Feature::wide_references});
}

TEST_P(BitPatternsGl, EntriesOf16BitsOfLeafLists) {
    Uploaded u;
    u.tree.references.resize(1);
    for (const std::uint32_t bits : {0u, 1u, 0x03ffu, 0x0400u, 0x7c00u, 0x7c01u, 0x7e01u, 0x8000u, 0xfc01u, 0xffffu}) {
        u.tree.references.push_back(std::int32_t(bits));
        ask(references, u.tree.references.size() - 1, {bits, bits, bits, bits}, "entry");
    }
    expect_all(u.scene, u.tree, {});
}

TEST_P(BitPatternsGl, TablesOfMaterials) {
    Uploaded u;
    for (std::size_t i = 0; i < any_count; ++i) {  // behind the one that the triangle has
        u.scene.materials.push_back({as_floats(i), as_floats(i + 3), as_floats(i + 6), as_floats(i + 11),
                                     as_float(any(i + 9)), int(any(i + 10)), int(any(i + 14)), as_float(any(i + 2)),
                                     int(any(i + 5)), as_float(any(i + 8)), as_float(any(i + 13))});
        const std::size_t at = 5 * (u.scene.materials.size() - 1);
        ask(tables, at, {any(i), any(i + 1), any(i + 2), any(i + 9)}, "material");
        ask(tables, at + 1, {any(i + 3), any(i + 4), any(i + 5), any(i + 10)}, "material");
        ask(tables, at + 2, {any(i + 6), any(i + 7), any(i + 8), any(i + 14)}, "material");
        ask(tables, at + 3, {any(i + 11), any(i + 12), any(i + 13), any(i + 2)}, "material");
        ask(tables, at + 4, {any(i + 5), any(i + 8), any(i + 13), 0}, "material");
    }
    expect_all(u.scene, u.tree, {});
}

TEST_P(BitPatternsGl, RaysOfATable) {
    const Uploaded u;
    for (std::size_t i = 0; i < any_count; ++i)
        rays_.push_back({as_floats(i), as_floats(i + 3), as_float(any(i + 6)), as_float(any(i + 7)), int(any(i + 8))});
    for (std::size_t i = 0; i < any_count; ++i) {
        ask(rays, 3 * i, {any(i), any(i + 1), any(i + 2), any(i + 6)}, "ray");
        ask(rays, 3 * i + 1, {any(i + 3), any(i + 4), any(i + 5), any(i + 7)}, "ray");
        ask(rays, 3 * i + 2, {any(i + 8), 0, 0, 0}, "ray");
    }
    expect_all(u.scene, u.tree, {});
}

TEST_P(BitPatternsGl, NormalFloatsOfNodesAndCorners) {
    Uploaded u;
    const std::uint32_t root = std::bit_cast<std::uint32_t>(0.0f), flag = std::bit_cast<std::uint32_t>(2.0f);
    for (const std::uint32_t bits : plain_bits) {
        TreeNode node;  // behind the root, which is a leaf
        node.flag = 2;
        node.split = as_float(bits);
        node.parent = 0;
        u.tree.nodes.push_back(node);
        ask(nodes, u.tree.nodes.size() - 1, {flag, bits, 0, root}, "node");
        const Vec3 corner(as_float(bits), 1, as_float(bits));
        u.scene.triangles.push_back({{corner, corner, corner}});
        u.scene.attributes.push_back(u.scene.attributes.front());
        ask(corners, 3 * u.scene.triangles.size() - 1, {bits, 0x3f800000, bits, 0}, "corner");
    }
    expect_all(u.scene, u.tree, {});
}

}  // namespace
}  // namespace kd

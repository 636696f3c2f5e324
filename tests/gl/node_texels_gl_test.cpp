// The whole numbers of the tree's nodes, float texels or packed ones, come back from a shader as they went in, up to
// the limit that the upload holds them to.

#include "renderer/kdtree/encode.h"
#include "tests/gl/gl_test.h"
#include "tests/support/environment_variable.h"
#include "tests/support/faulty_shaders.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

using NodeTexelsGl = ContextTest;
KD_FOR_ALL_CONTEXTS(NodeTexelsGl);

/// A ray whose source is -2 - n is not traced but answered with what the shader reads of node n.
std::filesystem::path shaders_that_tell_nodes() {
    return test::shaders_with("opengl/rays.glsl", "traverse(ray, frame.rays.x != 0, hit);", R"(
        if (ray.source > -2) {
            traverse(ray, frame.rays.x != 0, hit);
        } else {
            KdNode n = fetch_node(-2 - ray.source);
            int low = n.flag == KD_LEAF ? n.count % 65536 : 0;
            float high = n.flag == KD_LEAF ? float(n.count / 65536) : n.split;
            hit = Hit(n.link, high, float(4 * low + n.flag), float(n.parent));
        })");
}

/// Behind the root, which is a leaf, no ray comes to these.
void add_nodes(KdTree& tree, std::int32_t limit) {
    for (const std::int32_t number : {0, 1, 65'535, 65'537, limit / 2 + 1, limit - 1, limit})
        for (const std::int32_t flag : {1, KD_LEAF}) {
            TreeNode node;
            node.flag = flag;
            node.link = number;
            node.parent = 0;
            if (node.is_leaf())
                node.count = limit - number;
            else
                node.split = 0.1f;
            tree.nodes.push_back(node);
        }
}

void expect_numbers_back(Context& context, NodeEncoding nodes, std::int64_t limit) {
    const test::Variable shaders("KD_SHADER_DIR", shaders_that_tell_nodes().string());
    const FlatScene scene = test::scene_of(test::random_soup(1, 0.2f, 1));
    KdTree tree = build_tree(scene.triangles, {});
    ASSERT_EQ(tree.nodes.size(), 1u);
    add_nodes(tree, std::int32_t(limit));
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        rays.push_back({Vec3(5, 0, 0), Vec3(1, 0, 0), 0, 1, -2 - int(i)});
    std::vector<Hit> told(rays.size());
    GlTracer tracer(context);
    tracer.upload(scene, tree);
    tracer.trace_rays({.nodes = nodes}, rays, false, told, {});
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const int count = node.is_leaf() ? node.count : 0;
        EXPECT_EQ(told[i].triangle, node.link);
        EXPECT_EQ(told[i].t, node.is_leaf() ? float(count / 65536) : node.split) << node.link;
        EXPECT_EQ(told[i].u, float(4 * (count % 65536) + node.flag)) << node.link;
        EXPECT_EQ(told[i].v, nodes == NodeEncoding::packed ? -1.0f : float(node.parent)) << node.link;
    }
}

TEST_P(NodeTexelsGl, NumbersUpToTheLimitOfFloatsComeBackExactly) {
    expect_numbers_back(*context, NodeEncoding::float4, float_index_limit);
}

TEST_P(NodeTexelsGl, NumbersUpToThirtyBitsComeBackExactlyFromNodesOfEightBytes) {
    expect_numbers_back(*context, NodeEncoding::packed, packed_link_limit);
}

}  // namespace
}  // namespace kd

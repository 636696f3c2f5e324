#include "renderer/measure/stability/placed_tree.h"

#include "renderer/measure/stability/case_rays.h"

namespace kd {

namespace {

/// In the second half of its cell; the first quarter of a cell is empty.
Triangle triangle_of_cell(std::int32_t cell, float height = 0) {
    const auto corner = [&](float x, float y, float z) { return Vec3(float(cell) + x, y, z + height); };
    return {{corner(0.5f, -1, 0), corner(0.75f, -1, 0.5f), corner(0.5f, 1, 0.25f)}};
}

class TreeWriter {
  public:
    TreeWriter(const TreePlaces& places, KdTree& tree) : places_(places), tree_(tree), next_(places.block) {}

    void write(std::int32_t first_triangle) {
        // To what reads all nodes the passed over ones are empty leaves below the root.
        TreeNode nothing;
        nothing.parent = 0;
        tree_.nodes.assign(std::size_t(places_.nodes), nothing);
        tree_.references.assign(std::size_t(places_.nodes), 0);
        split(0, -1, 0.0f, places_.block);
        leaf(1, 0, 1, first_triangle);
        grow(0, std::int32_t(places_.leaves.size()), 0, first_triangle + 1);
    }

  private:
    TreeNode& node(std::int32_t at) { return tree_.nodes[std::size_t(at)]; }
    void split(std::int32_t at, std::int32_t parent, float plane, std::int32_t above) {
        node(at).flag = 0;
        node(at).split = plane;
        node(at).link = above;
        node(at).parent = parent;
    }
    void leaf(std::int32_t at, std::int32_t parent, std::int32_t list, std::int32_t triangle) {
        node(at).count = 1;
        node(at).link = list;
        node(at).parent = parent;
        tree_.references[std::size_t(list)] = triangle;
    }
    /// The inner nodes above the cells `first` to `last`, not included, halved until one is left.
    void grow(std::int32_t first, std::int32_t last, std::int32_t parent, std::int32_t triangle) {
        const std::int32_t at = next_++;
        if (last - first == 1) {
            const std::int32_t place = places_.leaves[std::size_t(first)];
            node(next_++).parent = at;  // the empty quarter
            split(at, parent, float(first) + 0.25f, place);
            leaf(place, at, place, triangle);
            return;
        }
        const std::int32_t half = (last - first) / 2;
        grow(first, first + half, at, triangle);
        split(at, parent, float(first + half), next_);
        grow(first + half, last, at, triangle + half);
    }

    const TreePlaces& places_;
    KdTree& tree_;
    std::int32_t next_;  // of the block
};

}  // namespace

Subject placed_subject(const TreePlaces& places, std::int32_t unseen) {
    std::vector<Triangle> triangles(std::size_t(unseen), triangle_of_cell(0, 100));
    for (std::int32_t cell = -1; cell < std::int32_t(places.leaves.size()); ++cell)
        triangles.push_back(triangle_of_cell(cell));
    Subject made;
    made.scene = bare_scene(std::move(triangles));
    made.tree.bounds = made.scene.bounds;
    TreeWriter(places, made.tree).write(unseen);
    return made;
}

std::vector<Ray> rays_to_leaves(const TreePlaces& places) {
    std::vector<Ray> rays;
    for (std::size_t cell = 0; cell < places.leaves.size(); ++cell)
        rays.push_back(ray_along(Vec3(float(cell) + 0.5625f, -0.5f, 2), Vec3(0, 0, -1)));
    return rays;
}

std::vector<Ray> rays_across_leaves(Random& random, const TreePlaces& places, std::size_t count) {
    const auto cells = int(places.leaves.size());
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 above(float(cells + 1) * float(random.unit()) - 1, 2 * float(random.unit()) - 1, 2);
        rays.push_back(ray_to(above, point_in(random, triangle_of_cell(random_below(random, cells + 1) - 1))));
    }
    return rays;
}

}  // namespace kd

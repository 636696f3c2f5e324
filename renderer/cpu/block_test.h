// A leaf's triangles eight at a time, before one ray. What is rare (an edge function of 0, a sliver) the shared text
// does.
//
// No include guard: included once per instruction set, behind lane_test.h.

struct BlockTests {
    /// Tests the triangles of a leaf whose link leads to its first block.
    template <class Kernel, class Setup>
    KD_FN static void test(Kernel& kernel, const Setup& s, const KdNode& leaf, Hit& hit) {
        const LeafBlock* block = kernel.block_at(leaf.link);
        for (int left = leaf.count; left > 0; left -= block_size, ++block) {
            const int count = std::min(left, block_size);
            for (int i = 0; i < count; ++i) kernel.on_triangle(i);
            test_block(kernel, s, *block, count, hit);
        }
    }

  private:
    using Test = LaneTest<block_size>;
    using L = Test::L;

    template <class Setup>
    KD_FN static Test::Corner load(const Setup& s, const LeafBlock& block, std::size_t corner) {
        const auto along = [&](int axis, float origin) {
            return L::load(block.corner[corner][std::size_t(axis)].data()) - L::all(origin);
        };
        const L z = along(s.axes.z, s.permuted_origin.z);
        return {along(s.axes.x, s.permuted_origin.x) - L::all(s.shear.x) * z,
                along(s.axes.y, s.permuted_origin.y) - L::all(s.shear.y) * z, z};
    }

    /// The first `count` triangles.
    template <class Kernel, class Setup>
    KD_FN static void test_block(Kernel& kernel, const Setup& s, const LeafBlock& block, int count, Hit& hit) {
        Test test;
        if (!test.run(load(s, block, 0), load(s, block, 1), load(s, block, 2), L::all(s.shear.z), Kernel::KD_THIN,
                      LaneMask<block_size>::first(count)))
            return;
        // The nearest so far, or as near: ties are for the loop below.
        const auto nearer = test.may_hit & (test.t <= L::all(hit.t)) & (L::all(s.ray.t_min) < test.t);
        unsigned wanted = (nearer | test.rare).bits();
        if (wanted == 0) return;
        const unsigned singly = test.rare.bits();
        alignas(32) float t[block_size], b[block_size], c[block_size], determinant[block_size];
        test.t.store(t);
        test.edge_b.store(b);
        test.edge_c.store(c);
        test.determinant.store(determinant);
        for (; wanted != 0; wanted &= wanted - 1) {
            const auto i = std::size_t(std::countr_zero(wanted));
            const int triangle = block.triangle[i];
            if (singly >> i & 1u)
                kernel.intersect_triangle(s, -1, triangle, hit);
            else if ((t[i] < hit.t || (t[i] == hit.t && triangle < hit.triangle)) && triangle != s.ray.source)
                hit = {triangle, t[i], b[i] / determinant[i], c[i] / determinant[i]};
        }
    }
};

// The triangle test of shaders/shared/triangle.glsl over blocks of eight: the same operations in the same order, so
// that every bit of a hit is the same. What is rare there (an edge function of 0, a sliver) is done there.
//
// No include guard: tile kernels include it once per instruction set, like kernel.h.

struct BlockTests {
    /// Tests the triangles of a leaf whose link leads to its first block.
    template <class Kernel, class Setup>
    KD_FN static void test(Kernel& kernel, const Setup& s, const KdNode& leaf, Hit& hit) {
        const LeafBlock* block = kernel.block_at(leaf.link);
        for (int left = leaf.count; left > 0; left -= block_size, ++block) {
            for (int i = 0; i < std::min(left, block_size); ++i) kernel.on_triangle(i);
            for (int lane = 0; lane < std::min(left, block_size); lane += lanes)
                test_lanes(kernel, s, *block, lane, std::min(left - lane, lanes), hit);
        }
    }

  private:
    static constexpr hn::CappedTag<float, block_size> tag{};
    static constexpr int lanes = int(hn::MaxLanes(hn::CappedTag<float, block_size>{}));
    using V = hn::Vec<decltype(tag)>;

    struct Corner {
        V x, y, z;
    };

    /// A corner of the block's triangles as the ray sees it: permuted, from its origin, sheared but for z.
    template <class Setup>
    KD_FN static Corner load(const Setup& s, const LeafBlock& block, std::size_t corner, std::size_t lane) {
        const auto along = [&](int axis, float origin) {
            return hn::LoadU(tag, &block.corner[corner][std::size_t(axis)][lane]) - hn::Set(tag, origin);
        };
        const V z = along(s.axes.z, s.permuted_origin.z);
        return {along(s.axes.x, s.permuted_origin.x) - hn::Set(tag, s.shear.x) * z,
                along(s.axes.y, s.permuted_origin.y) - hn::Set(tag, s.shear.y) * z, z};
    }

    /// The first `count` lanes from `lane` on.
    template <class Kernel, class Setup>
    KD_FN static void test_lanes(Kernel& kernel, const Setup& s, const LeafBlock& block, int lane, int count,
                                 Hit& hit) {
        const auto at = std::size_t(lane);
        const Corner a = load(s, block, 0, at), b = load(s, block, 1, at), c = load(s, block, 2, at);
        const V product_a = c.x * b.y, product_b = a.x * c.y, product_c = b.x * a.y;
        const V edge_a = product_a - c.y * b.x;
        const V edge_b = product_b - a.y * c.x;
        const V edge_c = product_c - b.y * a.x;
        const V least = hn::Min(edge_a, hn::Min(edge_b, edge_c));
        const V greatest = hn::Max(edge_a, hn::Max(edge_b, edge_c));
        const V inside = hn::Max(least, hn::Neg(greatest));
        const auto may_hit = hn::And(hn::Ge(inside, hn::Zero(tag)), hn::FirstN(tag, std::size_t(count)));
        if (hn::AllFalse(tag, may_hit)) return;

        const V determinant = edge_a + edge_b + edge_c;
        const V largest = hn::Max(hn::Abs(product_a), hn::Max(hn::Abs(product_b), hn::Abs(product_c)));
        const V kept = hn::Abs(determinant) - hn::Set(tag, Kernel::KD_THIN) * largest;
        const auto rare = hn::And(may_hit, hn::Le(hn::Min(inside, kept), hn::Zero(tag)));

        const V shear_z = hn::Set(tag, s.shear.z);
        const V scaled_t = edge_a * (shear_z * a.z) + edge_b * (shear_z * b.z) + edge_c * (shear_z * c.z);
        const V t = scaled_t / determinant;
        // The nearest so far, or as near: ties are for the loop below.
        const auto nearer =
            hn::And(hn::And(may_hit, hn::Le(t, hn::Set(tag, hit.t))), hn::Gt(t, hn::Set(tag, s.ray.t_min)));
        unsigned wanted = bits(hn::Or(nearer, rare));
        if (wanted == 0) return;
        const unsigned singly = bits(rare);
        alignas(32) float ts[lanes], bs[lanes], cs[lanes], determinants[lanes];
        hn::StoreU(t, tag, ts);
        hn::StoreU(edge_b, tag, bs);
        hn::StoreU(edge_c, tag, cs);
        hn::StoreU(determinant, tag, determinants);
        for (; wanted != 0; wanted &= wanted - 1) {
            const auto i = std::size_t(std::countr_zero(wanted));
            const int triangle = block.triangle[at + i];
            if (singly >> i & 1u)
                kernel.intersect_triangle(s, -1, triangle, hit);
            else if ((ts[i] < hit.t || (ts[i] == hit.t && triangle < hit.triangle)) && triangle != s.ray.source)
                hit = {triangle, ts[i], bs[i] / determinants[i], cs[i] / determinants[i]};
        }
    }

    template <class Mask>
    KD_FN static unsigned bits(Mask mask) {
        std::uint8_t stored[8] = {};
        hn::StoreMaskBits(tag, mask, stored);
        return stored[0];
    }
};

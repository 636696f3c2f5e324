// Rays that walk together (Wald, Slusallek, Benthin, Wagner, "Interactive Rendering with Coherent Ray Tracing", 2001):
// traverse_stack.glsl with N intervals for one path. Every lane makes the visits that it would make alone, in that
// order, so that its hit and its counters are those of the single walk; a node is fetched once for all of them.
//
// No include guard: included once per instruction set, behind ray_batch.h.

/// `Observer` is the kernel's; each lane has its own.
template <class Kernel, class Observer, int N>
class PacketWalk {
  public:
    using Batch = RayBatch<Kernel, N>;

    /// Of all lanes: `hits` are answered, `observers` told.
    PacketWalk(Kernel& kernel, const Batch& batch, bool any_hit, Hit* hits, Observer* observers)
        : kernel_(kernel), batch_(batch), any_hit_(any_hit), hits_(hits), observers_(observers) {}

    /// Walks the lanes `together`, which enter the tree, with equal signs of their directions and the same longest
    /// axis.
    void walk(unsigned together) {
        const int first = std::countr_zero(together);
        for (int axis = 0; axis < 3; ++axis) upwards_[axis] = (batch_.upwards[axis] >> first & 1u) != 0;
        z_ = batch_.longest_axis_of(first);
        x_ = z_ == 2 ? 0 : z_ + 1;
        y_ = x_ == 2 ? 0 : x_ + 1;
        L begin, end;
        enter(together, begin, end);
        int node = 0;
        do {
            const KdNode leaf = descend(node, begin, end);
            test(node, leaf, begin <= end);
        } while (pop(node, begin, end));
        answer(together);
    }

  private:
    using L = Lanes<N>;
    using Mask = LaneMask<N>;
    using Row = float[N];

    /// A far child with the lanes that have to visit it: those whose interval is not empty.
    struct Pending {
        alignas(64) Row begin, end;
        int node;
        unsigned pushed;  // lanes that went near first, where counted: to the others it is their only child
    };

    Kernel& kernel_;
    const Batch& batch_;
    const bool any_hit_;
    Hit* hits_;
    Observer* observers_;
    int x_ = 0, y_ = 0, z_ = 0;
    bool upwards_[3] = {};
    int pending_ = 0;
    // The nearest hits so far; u and v are yet to be divided by the determinant.
    alignas(64) Row t_, u_, v_, determinant_;
    alignas(64) Row horizon_;  // behind it no cell can hold a nearer hit: see beyond_hit()
    alignas(64) std::int32_t triangle_[N];
    int depth_[N];  // pending cells of each lane, where counted
    Pending stack_[max_tree_depth];

    static constexpr bool counting = requires(Observer o) { o.counters; };

    /// Calls `tell` with every lane of the mask, where there is somebody to tell.
    template <class Tell>
    KD_FN void observe(const Mask& lanes, const Tell& tell) {
        if constexpr (counting)
            for (unsigned left = lanes.bits(); left != 0; left &= left - 1) tell(std::countr_zero(left));
    }

    KD_FN void enter(unsigned together, L& begin, L& end) {
        for (int i = 0; i < N; ++i) {
            triangle_[i] = -1;
            depth_[i] = 0;
            horizon_[i] = (together >> i & 1u) != 0 ? 0.0f : -1.0f;
        }
        const Mask walking = L::all(0.0f) <= L::load(horizon_);
        // Far beyond any t: rays from afar are walked from near the scene, so that theirs may be negative, or infinite
        // where they run beside the bounds.
        begin = choose(walking, L::load(batch_.begin), L::all(KD_T_LIMIT));
        end = choose(walking, L::load(batch_.end), L::all(-KD_T_LIMIT));
        L::load(batch_.t_max).store(t_);
        L::all(KD_T_LIMIT).store(horizon_);
        L::all(0.0f).store(u_);
        L::all(0.0f).store(v_);
        L::all(1.0f).store(determinant_);
    }

    /// Down to a leaf, near child first, as visit_children() says of each lane: an interval that is cut to nothing is
    /// a child that the lane does not visit.
    KD_FN KdNode descend(int& node, const L& begin, L& end) {
        KdNode n = kernel_.fetch_node(node);
        while (n.flag != KD_LEAF) {
            const int axis = n.flag;
            observe(begin <= end, [&](int lane) { observers_[lane].on_interior(node, false); });
            const L t_plane = (L::all(n.split) - L::load(batch_.origin[axis])) * L::load(batch_.inverse[axis]);
            const L wider = L::load(batch_.t_slack[axis]);
            const L near_end = least(t_plane + wider, end);
            const L far_begin = greatest(t_plane - wider, begin);
            const Mask near = begin <= near_end, far = far_begin <= end;
            const bool no_near = near.none(), no_far = far.none();
            if (!no_near && !no_far) {
                observe(near & far, [&](int lane) { observers_[lane].on_push(++depth_[lane]); });
                Pending& next = stack_[pending_++];
                if constexpr (counting) next.pushed = (near & far).bits();
                far_begin.store(next.begin);
                end.store(next.end);
                next.node = kernel_.child_of(node, n, !upwards_[axis]);
                end = near_end;
            }
            node = kernel_.child_of(node, n, upwards_[axis] != no_near);
            n = kernel_.fetch_node(node);
        }
        return n;
    }

    using Test = LaneTest<N>;
    using Corner = typename Test::Corner;

    KD_FN void test(int node, const KdNode& leaf, const Mask& lanes) {
        observe(lanes, [&](int lane) { observers_[lane].on_leaf(node); });
        if (leaf.count == 0) return;
        const L origin_x = L::load(batch_.origin[x_]), origin_y = L::load(batch_.origin[y_]),
                origin_z = L::load(batch_.origin[z_]);
        const L shear_x = L::load(batch_.shear[0]), shear_y = L::load(batch_.shear[1]);
        const LeafBlock* block = kernel_.block_at(leaf.link);
        for (int left = leaf.count; left > 0; left -= block_size, ++block) {
            const float *x = block->corner[0][std::size_t(x_)].data(), *y = block->corner[0][std::size_t(y_)].data(),
                        *z = block->corner[0][std::size_t(z_)].data();
            const auto corner = [&](int i) -> Corner {
                const L along = L::all(z[i]) - origin_z;
                return {L::all(x[i]) - origin_x - shear_x * along, L::all(y[i]) - origin_y - shear_y * along, along};
            };
            constexpr int next = int(sizeof(block->corner[0]) / sizeof(float));  // corner of the same triangle
            for (int i = 0; i < std::min(left, block_size); ++i) {
                observe(lanes, [&](int lane) { observers_[lane].on_triangle(i); });
                intersect(corner(i), corner(next + i), corner(2 * next + i), block->triangle[std::size_t(i)], lanes);
            }
        }
    }

    /// As intersect_triangle(), of the lanes of the mask.
    KD_FN void intersect(const Corner& a, const Corner& b, const Corner& c, std::int32_t triangle, const Mask& lanes) {
        Test test;
        if (!test.run(a, b, c, L::load(batch_.shear[2]), Kernel::KD_THIN, lanes)) return;
        const L& t = test.t;
        const L nearest = L::load(t_);
        if (KD_RARE(!test.rare.none()))
            for (unsigned left = test.rare.bits(); left != 0; left &= left - 1)
                intersect_singly(std::countr_zero(left), triangle);
        Mask nearer = (test.may_hit - test.rare) & (L::load(batch_.t_min) < t) & (t <= nearest);
        if (nearer.none()) return;
        nearer = nearer - Mask::equal(batch_.source, triangle);
        nearer = nearer - ((t == nearest) & Mask::less(triangle_, triangle));  // of equal t the lowest number wins
        t.store(nearer, t_);
        test.edge_b.store(nearer, u_);
        test.edge_c.store(nearer, v_);
        test.determinant.store(nearer, determinant_);
        nearer.put(triangle, triangle_);
        (any_hit_ ? L::all(-KD_T_LIMIT) : t * L::all(1.0f + KD_T_PADDING)).store(nearer, horizon_);
    }

    [[nodiscard]] Hit hit_of(int lane) const {
        const float over = determinant_[lane];
        return {triangle_[lane], t_[lane], u_[lane] / over, v_[lane] / over};
    }

    void keep(int lane, const Hit& hit) {
        triangle_[lane] = hit.triangle;
        t_[lane] = hit.t;
        u_[lane] = hit.u;
        v_[lane] = hit.v;
        determinant_[lane] = 1.0f;
        if (hit.triangle >= 0) horizon_[lane] = any_hit_ ? -KD_T_LIMIT : hit.t * (1.0f + KD_T_PADDING);
    }

    /// A lane whose edge functions or determinant the shared text looks at more closely.
    [[gnu::noinline]] void intersect_singly(int lane, std::int32_t triangle) {
        typename Kernel::RaySetup s;
        batch_.extract(lane, s);
        Hit hit = hit_of(lane);
        kernel_.intersect_triangle(s, -1, triangle, hit);
        if (hit.triangle == triangle) keep(lane, hit);
    }

    /// To the next pending cell that some lane still has to visit; false where there is none. However few have: parting
    /// from a single one was no faster (docs/performance.md).
    KD_FN bool pop(int& node, L& begin, L& end) {
        while (pending_ > 0) {
            const Pending& next = stack_[--pending_];
            begin = L::load(next.begin);
            end = L::load(next.end);
            const Mask waiting = begin <= end;
            if constexpr (counting)
                for (unsigned left = next.pushed; left != 0; left &= left - 1) --depth_[std::countr_zero(left)];
            const Mask walking = waiting - (L::load(horizon_) < begin);
            if (walking.none()) continue;
            node = next.node;
            end = choose(walking, end, L::all(-KD_T_LIMIT));
            return true;
        }
        return false;
    }

    KD_FN void answer(unsigned together) {
        const L over = L::load(determinant_);
        const L u = L::load(u_) / over, v = L::load(v_) / over;
        if (std::popcount(together) == N) {
            store_hits(triangle_, L::load(t_), u, v, hits_);
        } else {
            u.store(u_);
            v.store(v_);
            for (unsigned left = together; left != 0; left &= left - 1) {
                const int lane = std::countr_zero(left);
                hits_[lane] = {triangle_[lane], t_[lane], u_[lane], v_[lane]};
            }
        }
        if constexpr (counting)
            for (unsigned left = together; left != 0; left &= left - 1) {
                const int lane = std::countr_zero(left);
                observers_[lane].on_exit(triangle_[lane] >= 0 ? KD_EXIT_HIT : KD_EXIT_MISS);
            }
    }
};

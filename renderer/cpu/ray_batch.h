// N rays set up side by side: shaders/shared/ray.glsl and box.glsl on vectors, to the same bits.
//
// No include guard: included once per instruction set, behind kernel.h and lanes.h.

template <class Kernel, int N>
class RayBatch {
  public:
    using L = Lanes<N>;
    using Row = float[N];

    alignas(64) Row origin[3], direction[3], inverse[3], t_slack[3], shear[3], slack;
    alignas(64) Row t_min, t_max;
    alignas(64) Row begin, end;  // the part inside of the tree's bounds
    alignas(64) std::int32_t source[N];
    // Lanes in bits.
    unsigned regular = 0;                       // set up here; the others are for setup_ray()
    unsigned entered = 0;                       // of these, those that meet the bounds
    unsigned upwards[3] = {}, longest[3] = {};  // whose direction grows along an axis, and is longest along it

    /// At least one ray, at most N.
    void load(std::span<const Ray> rays, const Aabb& bounds) {
        for (std::size_t i = 0; i < N; i += 4) {
            const auto at = [&](std::size_t ray) -> const Ray& { return rays[ray < rays.size() ? ray : 0]; };
            const Ray &a = at(i), &b = at(i + 1), &c = at(i + 2), &d = at(i + 3);
            static_assert(offsetof(Ray, direction) == 12 && offsetof(Ray, t_min) == 24 && offsetof(Ray, t_max) == 28);
            turn({&a.origin.x, &b.origin.x, &c.origin.x, &d.origin.x},
                 {&origin[0][i], &origin[1][i], &origin[2][i], &direction[0][i]});
            turn({&a.direction.y, &b.direction.y, &c.direction.y, &d.direction.y},
                 {&direction[1][i], &direction[2][i], &t_min[i], &t_max[i]});
            for (std::size_t lane = 0; lane < 4; ++lane) source[i + lane] = at(i + lane).source;
        }
        regular = set_up(bounds) & ((1u << rays.size()) - 1);
        entered = bounds.lower.x <= bounds.upper.x ? clip(bounds) & regular : 0;
    }

    /// A regular lane as setup_ray() makes it.
    KD_FN void extract(int lane, typename Kernel::RaySetup& s) const {
        const auto at = [lane](const Row(&rows)[3]) { return Vec3(rows[0][lane], rows[1][lane], rows[2][lane]); };
        const int z = longest_axis_of(lane);
        const int x = z == 2 ? 0 : z + 1;
        const int y = x == 2 ? 0 : x + 1;
        s.ray = {at(origin), at(direction), t_min[lane], t_max[lane], source[lane]};
        s.t_shift = 0.0f;
        s.inverse = at(inverse);
        s.slack = slack[lane];
        s.t_slack = at(t_slack);
        s.axes = int3(x, y, z);
        s.shear = at(shear);
        s.permuted_origin = Vec3(origin[x][lane], origin[y][lane], origin[z][lane]);
    }

    [[nodiscard]] KD_FN int longest_axis_of(int lane) const {
        return longest[0] >> lane & 1u ? 0 : longest[1] >> lane & 1u ? 1 : 2;
    }

  private:
    // t at a plane, above which its sums and products may leave single precision (3.4e38).
    static constexpr float farthest_t = 1e37f;

    /// Four rows of four numbers as columns.
    KD_FN static void turn(const std::array<const float*, 4>& row, const std::array<float*, 4>& column) {
#if HWY_TARGET == HWY_SCALAR
        for (std::size_t i = 0; i < 16; ++i) column[i % 4][i / 4] = row[i / 4][i % 4];
#else
        const hn::FixedTag<float, 4> four;
        const auto a = hn::LoadU(four, row[0]), b = hn::LoadU(four, row[1]), c = hn::LoadU(four, row[2]),
                   d = hn::LoadU(four, row[3]);
        const auto ac_low = hn::InterleaveLower(four, a, c), bd_low = hn::InterleaveLower(four, b, d);
        const auto ac_high = hn::InterleaveUpper(four, a, c), bd_high = hn::InterleaveUpper(four, b, d);
        hn::Store(hn::InterleaveLower(four, ac_low, bd_low), four, column[0]);
        hn::Store(hn::InterleaveUpper(four, ac_low, bd_low), four, column[1]);
        hn::Store(hn::InterleaveLower(four, ac_high, bd_high), four, column[2]);
        hn::Store(hn::InterleaveUpper(four, ac_high, bd_high), four, column[3]);
#endif
    }

    /// The lanes that are valid_ray() and ask for nothing rare: no axis that the ray is parallel to, no start from
    /// afar, no product beyond single precision.
    KD_FN unsigned set_up(const Aabb& bounds) {
        const L d[3] = {L::load(direction[0]), L::load(direction[1]), L::load(direction[2])};
        const L size[3] = {magnitude(d[0]), magnitude(d[1]), magnitude(d[2])};
        const L largest = greatest(size[0], greatest(size[1], size[2]));
        const L smallest = L::all(KD_PARALLEL) * largest;
        auto fine =
            (largest <= L::all(Kernel::KD_LONGEST_DIRECTION)) & (L::all(Kernel::KD_SHORTEST_DIRECTION) < largest);
        L reach = L::all(0.0f);
        for (int axis = 0; axis < 3; ++axis) {
            const L from = L::load(origin[axis]);
            fine = fine & (magnitude(from) <= L::all(KD_COORDINATE_LIMIT)) & (smallest < size[axis]);
            reach = greatest(reach, greatest(magnitude(L::all(AXIS(bounds.lower, axis)) - from),
                                             magnitude(L::all(AXIS(bounds.upper, axis)) - from)));
        }
        const float extent =
            (bounds.upper.x - bounds.lower.x) + (bounds.upper.y - bounds.lower.y) + (bounds.upper.z - bounds.lower.z);
        const L width = L::all(KD_SLACK) * reach;
        width.store(slack);
        L reciprocal[3];
        for (int axis = 0; axis < 3; ++axis) {
            reciprocal[axis] = L::all(1.0f) / d[axis];
            reciprocal[axis].store(inverse[axis]);
            (magnitude(reciprocal[axis]) * width).store(t_slack[axis]);
            fine = fine & (magnitude(reciprocal[axis]) * reach <= L::all(farthest_t));
            upwards[axis] = (L::all(0.0f) < reciprocal[axis]).bits();
        }
        set_shear(d, size, reciprocal);
        const L first = L::load(t_min);
        const L last = least(L::all(KD_T_LIMIT), L::load(t_max));
        last.store(t_max);
        return (fine & (reach <= L::all(Kernel::KD_NEAR_THE_SCENE * extent)) & (L::all(0.0f) <= first) & (first < last))
            .bits();
    }

    KD_FN void set_shear(const L (&d)[3], const L (&size)[3], const L (&reciprocal)[3]) {
        const auto x_above_y = size[1] < size[0];
        const auto along_x = x_above_y & (size[2] < size[0]);
        const auto along_y = (size[2] < size[1]) - x_above_y;
        longest[0] = along_x.bits();
        longest[1] = along_y.bits();
        longest[2] = ~(longest[0] | longest[1]);
        const auto of_axes = [&](const L& x, const L& y, const L& z) {
            return choose(along_x, x, choose(along_y, y, z));
        };
        const L shear_z = of_axes(reciprocal[0], reciprocal[1], reciprocal[2]);
        const auto shear_of = [&](const L& component) {
            const L product = component * shear_z;
            const auto none = (magnitude(component) < L::all(Kernel::KD_LEAST_COMPONENT)) |
                              (magnitude(product) < L::all(Kernel::KD_LEAST_SHEAR));
            return choose(none, L::all(0.0f), product);
        };
        shear_of(of_axes(d[1], d[2], d[0])).store(shear[0]);
        shear_of(of_axes(d[2], d[0], d[1])).store(shear[1]);
        shear_z.store(shear[2]);
    }

    /// clip_to_box() of lanes that are parallel to no axis.
    KD_FN unsigned clip(const Aabb& bounds) {
        L first = L::load(t_min), last = L::load(t_max);
        for (int axis = 0; axis < 3; ++axis) {
            const L from = L::load(origin[axis]), over = L::load(inverse[axis]), wider = L::load(t_slack[axis]);
            const L t_lower = (L::all(AXIS(bounds.lower, axis)) - from) * over;
            const L t_upper = (L::all(AXIS(bounds.upper, axis)) - from) * over;
            first = greatest(first, least(t_lower, t_upper) - wider);
            last = least(last, greatest(t_lower, t_upper) + wider);
        }
        first.store(begin);
        last.store(end);
        return (first <= last).bits();
    }
};

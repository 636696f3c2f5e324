// N floats side by side in as many vectors as they take: what rays that walk together are made of.
//
// No include guard: included once per instruction set, behind Highway.

/// Of each of N lanes a truth value.
template <int N>
struct LaneMask {
    static constexpr hn::CappedTag<float, N> tag{};
    static constexpr hn::CappedTag<std::int32_t, N> whole{};
    static constexpr int width = int(hn::MaxLanes(hn::CappedTag<float, N>{}));
    static constexpr int parts = N / width;
    hn::Mask<hn::CappedTag<float, N>> part[parts];

    KD_FN bool none() const {
        bool none = true;
        for (int i = 0; i < parts; ++i) none = none && hn::AllFalse(tag, part[i]);
        return none;
    }
    /// Lane i in bit i.
    KD_FN unsigned bits() const {
        unsigned bits = 0;
        for (int i = 0; i < parts; ++i) {
            std::uint8_t stored[8] = {};
            hn::StoreMaskBits(tag, part[i], stored);
            bits |= (unsigned(stored[0]) | unsigned(stored[1]) << 8u) << unsigned(i * width);
        }
        return bits;
    }
    /// The first `count` lanes.
    KD_FN static LaneMask first(int count) {
        LaneMask mask;
        for (int i = 0; i < parts; ++i)
            mask.part[i] = hn::FirstN(tag, std::size_t(std::clamp(count - i * width, 0, width)));
        return mask;
    }
    /// Of N whole numbers: those that are `other`, and those that are less.
    KD_FN static LaneMask equal(const std::int32_t* numbers, std::int32_t other) {
        LaneMask mask;
        for (int i = 0; i < parts; ++i)
            mask.part[i] = hn::RebindMask(tag, hn::Eq(hn::Load(whole, numbers + i * width), hn::Set(whole, other)));
        return mask;
    }
    KD_FN static LaneMask less(const std::int32_t* numbers, std::int32_t other) {
        LaneMask mask;
        for (int i = 0; i < parts; ++i)
            mask.part[i] = hn::RebindMask(tag, hn::Lt(hn::Load(whole, numbers + i * width), hn::Set(whole, other)));
        return mask;
    }
    /// Writes `number` where the mask is true.
    KD_FN void put(std::int32_t number, std::int32_t* numbers) const {
        for (int i = 0; i < parts; ++i)
            hn::BlendedStore(hn::Set(whole, number), hn::RebindMask(whole, part[i]), whole, numbers + i * width);
    }
    KD_FN friend LaneMask operator&(LaneMask a, const LaneMask& b) {
        for (int i = 0; i < parts; ++i) a.part[i] = hn::And(a.part[i], b.part[i]);
        return a;
    }
    KD_FN friend LaneMask operator|(LaneMask a, const LaneMask& b) {
        for (int i = 0; i < parts; ++i) a.part[i] = hn::Or(a.part[i], b.part[i]);
        return a;
    }
    /// `a` without `b`.
    KD_FN friend LaneMask operator-(LaneMask a, const LaneMask& b) {
        for (int i = 0; i < parts; ++i) a.part[i] = hn::AndNot(b.part[i], a.part[i]);
        return a;
    }
};

template <int N>
struct Lanes {
    using Mask = LaneMask<N>;
    static constexpr auto tag = Mask::tag;
    static constexpr int width = Mask::width, parts = Mask::parts;
    hn::Vec<hn::CappedTag<float, N>> part[parts];

    /// From N floats that lie at a multiple of their size.
    KD_FN static Lanes load(const float* from) {
        Lanes a;
        for (int i = 0; i < parts; ++i) a.part[i] = hn::Load(tag, from + i * width);
        return a;
    }
    KD_FN static Lanes all(float value) {
        Lanes a;
        for (int i = 0; i < parts; ++i) a.part[i] = hn::Set(tag, value);
        return a;
    }
    KD_FN void store(float* to) const {
        for (int i = 0; i < parts; ++i) hn::Store(part[i], tag, to + i * width);
    }
    /// Where `mask` is true.
    KD_FN void store(const Mask& mask, float* to) const {
        for (int i = 0; i < parts; ++i) hn::BlendedStore(part[i], mask.part[i], tag, to + i * width);
    }

#define KD_LANEWISE(name, expression)                                                                                  \
    KD_FN friend Lanes name(const Lanes& a, const Lanes& b) {                                                          \
        Lanes c;                                                                                                       \
        for (int i = 0; i < parts; ++i) c.part[i] = expression;                                                        \
        return c;                                                                                                      \
    }
    KD_LANEWISE(operator+, a.part[i] + b.part[i])
    KD_LANEWISE(operator-, a.part[i] - b.part[i])
    KD_LANEWISE(operator*, a.part[i] * b.part[i])
    KD_LANEWISE(operator/, a.part[i] / b.part[i])
    KD_LANEWISE(least, hn::Min(a.part[i], b.part[i]))
    KD_LANEWISE(greatest, hn::Max(a.part[i], b.part[i]))
#undef KD_LANEWISE
#define KD_COMPARE(name, compare)                                                                                      \
    KD_FN friend Mask name(const Lanes& a, const Lanes& b) {                                                           \
        Mask c;                                                                                                        \
        for (int i = 0; i < parts; ++i) c.part[i] = hn::compare(a.part[i], b.part[i]);                                 \
        return c;                                                                                                      \
    }
    KD_COMPARE(operator<, Lt)
    KD_COMPARE(operator<=, Le)
    KD_COMPARE(operator==, Eq)
#undef KD_COMPARE
    KD_FN friend Lanes magnitude(Lanes a) {
        for (int i = 0; i < parts; ++i) a.part[i] = hn::Abs(a.part[i]);
        return a;
    }
    KD_FN friend Lanes operator-(Lanes a) {
        for (int i = 0; i < parts; ++i) a.part[i] = hn::Neg(a.part[i]);
        return a;
    }
    KD_FN friend Lanes choose(const Mask& mask, const Lanes& yes, const Lanes& no) {
        Lanes c;
        for (int i = 0; i < parts; ++i) c.part[i] = hn::IfThenElse(mask.part[i], yes.part[i], no.part[i]);
        return c;
    }
};

/// N hits from rows of their parts.
template <int N>
KD_FN void store_hits(const std::int32_t* triangle, const Lanes<N>& t, const Lanes<N>& u, const Lanes<N>& v,
                      Hit* hits) {
    static_assert(sizeof(Hit) == 4 * sizeof(float) && offsetof(Hit, t) == 4 && offsetof(Hit, u) == 8);
    constexpr auto tag = Lanes<N>::tag;
    constexpr int width = Lanes<N>::width;
    for (int i = 0; i < Lanes<N>::parts; ++i)
        hn::StoreInterleaved4(hn::BitCast(tag, hn::Load(LaneMask<N>::whole, triangle + i * width)), t.part[i],
                              u.part[i], v.part[i], tag, reinterpret_cast<float*>(hits + i * width));
}

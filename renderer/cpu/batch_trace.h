// Up to N rays at once: set up side by side, walked together where they agree, else one by one.
//
// No include guard: included once per instruction set, behind packet_walk.h.

template <class Kernel, class Observer, int N>
class BatchTracer {
  public:
    /// Without `together` every ray walks alone.
    BatchTracer(Kernel& kernel, const Aabb& bounds, bool together)
        : kernel_(kernel), bounds_(bounds), together_(together) {}

    /// As Kernel::traverse() for each of 1 to N rays, by the stack. `hits` and `observers`: N.
    void trace(std::span<const Ray> rays, bool any_hit, Hit* hits, Observer* observers) {
        batch_.load(rays, bounds_);
        for (unsigned left = ((1u << rays.size()) - 1) & ~batch_.entered; left != 0; left &= left - 1)
            miss(rays, std::countr_zero(left), any_hit, hits, observers);
        for (unsigned left = batch_.entered; left != 0;) {
            const unsigned alike = together_ ? alike_of(left) : left;
            left &= ~alike;
            if (together_ && std::popcount(alike) >= fewest_together)
                PacketWalk<Kernel, Observer, N>(kernel_, batch_, any_hit, hits, observers).walk(alike);
            else
                for (unsigned alone = alike; alone != 0; alone &= alone - 1)
                    walk(std::countr_zero(alone), any_hit, hits, observers);
        }
    }

  private:
    static constexpr int fewest_together = N / 4 + 1;  // rays alike that are worth a packet

    Kernel& kernel_;
    const Aabb bounds_;
    const bool together_;
    RayBatch<Kernel, N> batch_;

    /// The lanes of `left` whose direction is like that of the first of them.
    [[nodiscard]] KD_FN unsigned alike_of(unsigned left) const {
        const int first = std::countr_zero(left);
        unsigned alike = left;
        for (int axis = 0; axis < 3; ++axis) {
            for (const unsigned lanes : {batch_.upwards[axis], batch_.longest[axis]})
                alike &= (lanes >> first & 1u) != 0 ? lanes : ~lanes;
        }
        return alike;
    }

    /// A ray that does not enter the tree, or that only the shared text sets up.
    void miss(std::span<const Ray> rays, int lane, bool any_hit, Hit* hits, Observer* observers) {
        const Ray& ray = rays[std::size_t(lane)];
        hits[lane] = kernel_.no_hit(ray);
        kernel_.observe(observers[lane]);
        if ((batch_.regular >> lane & 1u) != 0)
            observers[lane].on_exit(KD_EXIT_MISS);
        else
            kernel_.traverse(ray, any_hit, hits[lane]);
    }

    KD_FN void walk(int lane, bool any_hit, Hit* hits, Observer* observers) {
        typename Kernel::RaySetup s;
        batch_.extract(lane, s);
        hits[lane] = {-1, batch_.t_max[lane], 0.0f, 0.0f};
        kernel_.observe(observers[lane]);
        kernel_.walk_subtree(s, 0, batch_.begin[lane], batch_.end[lane], any_hit, hits[lane]);
    }
};

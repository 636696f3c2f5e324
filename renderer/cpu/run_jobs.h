// A job through a kernel: included by tile_kernel.cpp and wide_kernel.cpp once per instruction set, behind kernel.h.

/// Calls `use` with what the job's kernel is made of: its observer and its nodes.
template <class Use>
void with_parts(const SceneView& view, bool counting, const Use& use) {
    const auto with = [&]<class Observer>(Observer) {
        view.needs.wide_nodes ? use(Observer{}, TreeNode{}) : use(Observer{}, PackedNode{});
    };
    counting ? with(CountingObserver{}) : with(NullObserver{});
}

template <class Kernel, class Observer>
void run_on(const TileJob& job) {
    Observer observer;
    Kernel kernel(job.view, job.config, observer);
    for (int y = job.tile.y0; y < job.tile.y1; ++y)
        for (int x = job.tile.x0; x < job.tile.x1; ++x) trace_pixel<Kernel, Observer>(kernel, job, x, y);
}

template <class Kernel, class Observer>
void run_on(const RayJob& job) {
    Observer first;
    Kernel kernel(job.view, job.config, first);
    for (std::size_t i = 0; i < job.rays.size(); ++i) {
        Observer observer;
        kernel.observe(observer);
        // In place: a copy would wait for the stores of its parts.
        job.hits[i] = kernel.no_hit(job.rays[i]);
        kernel.traverse(job.rays[i], job.any_hit, job.hits[i]);
        if constexpr (requires { observer.counters; }) job.counters[i] = observer.counters;
    }
}

[[nodiscard]] inline bool counts(const TileJob& job) { return job.view.needs.counters; }
[[nodiscard]] inline bool counts(const RayJob& job) { return !job.counters.empty(); }

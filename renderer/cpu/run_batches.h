// A job through a kernel over leaves in blocks, N rays at a time where they walk by the stack.
//
// No include guard: included once per instruction set, behind pixel_batch.h and run_jobs.h.

/// Rays by the stack, N at a time.
template <class Kernel, class Observer, int N>
void run_batches(const RayJob& job) {
    std::array<Observer, N> observers;
    std::array<Hit, N> hits;
    Kernel kernel(job.view, job.config, observers[0]);
    BatchTracer<Kernel, Observer, N> tracer(kernel, job.view.scene->bounds, job.view.in_force == CpuMode::packet);
    for (std::size_t first = 0; first < job.rays.size(); first += N) {
        const std::size_t count = std::min(job.rays.size() - first, std::size_t(N));
        observers = {};
        const bool whole = count == N;
        tracer.trace(job.rays.subspan(first, count), job.any_hit, whole ? &job.hits[first] : hits.data(),
                     observers.data());
        if (!whole) std::copy_n(hits.begin(), count, job.hits.begin() + std::ptrdiff_t(first));
        if constexpr (requires { observers[0].counters; })
            for (std::size_t i = 0; i < count; ++i) job.counters[first + i] = observers[i].counters;
    }
}

/// Blocks of N pixels, as square as they can be.
template <class Kernel, class Observer, int N>
void run_batches(const TileJob& job) {
    constexpr int width = N == 4 ? 2 : 4, height = N / width;
    Observer observer;
    Kernel kernel(job.view, job.config, observer);
    PixelBatch<Kernel, Observer, N> pixels(kernel, job);
    for (int y = job.tile.y0; y < job.tile.y1; y += height)
        for (int x = job.tile.x0; x < job.tile.x1; x += width)
            pixels.trace({x, y, std::min(x + width, job.tile.x1), std::min(y + height, job.tile.y1)});
}

template <class Kernel, class Observer, class Job>
void run_by_size(const Job& job) {
    if (!walks_in_batches(job.config)) return run_on<Kernel, Observer>(job);
    switch (job.view.in_force == CpuMode::packet ? job.config.packet_size : block_size) {
        case 4: return run_batches<Kernel, Observer, 4>(job);
        case 8: return run_batches<Kernel, Observer, 8>(job);
        default: return run_batches<Kernel, Observer, 16>(job);
    }
}

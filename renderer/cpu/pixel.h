// One pixel through the paper's four passes. Included by tile_kernel.cpp once per instruction set, like kernel.h.

template <class Kernel, class Observer>
void trace_pixel(Kernel& kernel, const TileJob& job, int x, int y) {
    using Path = typename Kernel::Path;
    Frame& frame = job.frame;
    const std::size_t i = frame.colour.index(x, y);
    std::array<Observer, pass_count> seen{};
    std::array<Hit, pass_count> hits;
    hits.fill(Hit{-1, 0.0f, 0.0f, 0.0f});
    const auto observe = [&](Pass pass) { kernel.observe(seen[std::size_t(pass)]); };

    observe(Pass::rt_prim);
    Path path = kernel.trace_primary(job.camera, int2(x, y), int2(frame.width, frame.height));
    hits[0] = path.hit;

    observe(Pass::shade_prim);
    Vec3 colour = kernel.shade_path(path, hits[1]);

    for (int bounce = 0; bounce < job.view.needs.bounces; ++bounce) {
        if (!kernel.reflection_counts(kernel.reflected_weight(path), job.config.least_contribution)) break;
        observe(Pass::rt_refl);
        path = kernel.trace_reflection(path);
        if (bounce == 0) hits[2] = path.hit;
        observe(Pass::shade_refl);
        colour += kernel.shade_path(path, hits[3]);
    }

    frame.colour.pixels[i] = Vec4(colour, 1.0f);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        frame.layers[pass].hit.pixels[i] = hits[pass];
        if constexpr (requires { seen[pass].counters; }) frame.layers[pass].counters.pixels[i] = seen[pass].counters;
    }
}

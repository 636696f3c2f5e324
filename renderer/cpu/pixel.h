// One pixel through the passes. Included by tile_kernel.cpp once per instruction set, like kernel.h.

/// Traces one pixel's rays, those of each pass told to its observer in `seen` and answered in `hits`. Returns the
/// colour, which is the pixel's where all passes ran; those after `last` do not.
template <class Kernel, class Observer>
Vec3 walk_pixel(Kernel& kernel, const TileJob& job, int2 pixel, int2 size, Pass last,
                std::array<Observer, pass_count>& seen, std::array<Hit, pass_count>& hits) {
    using Path = typename Kernel::Path;
    hits.fill(Hit{-1, 0.0f, 0.0f, 0.0f});
    const auto observe = [&](Pass pass) { kernel.observe(seen[std::size_t(pass)]); };

    observe(Pass::rt_prim);
    kernel.begin_at(job.entries.at(pixel.x, pixel.y));
    Path path = kernel.trace_primary(job.camera, pixel, size);
    kernel.begin_at(0);
    hits[0] = path.hit;
    if (last == Pass::rt_prim) return Vec3(0);

    observe(Pass::shade_prim);
    Vec3 colour = kernel.shade_path(path, hits[1]);
    if (last == Pass::shade_prim) return colour;

    const Path primary = path;
    for (int bounce = 0; bounce < job.view.needs.bounces; ++bounce) {
        if (!kernel.reflection_counts(kernel.reflected_weight(path), job.config.least_contribution)) break;
        observe(Pass::rt_refl);
        path = kernel.trace_reflection(path);
        if (bounce == 0) hits[2] = path.hit;
        if (!kernel.path_counts(path)) break;
        observe(Pass::shade_refl);
        colour += kernel.shade_path(path, hits[3]);
    }
    if (of_reflections(last) || !job.view.needs.indirect || !kernel.scatters(primary)) return colour;

    observe(Pass::rt_indirect);
    path = kernel.trace_indirect(primary);
    hits[4] = path.hit;
    observe(Pass::shade_indirect);
    if (kernel.path_counts(path)) colour += kernel.shade_path(path, hits[5]);
    return colour;
}

template <class Kernel, class Observer>
void trace_pixel(Kernel& kernel, const TileJob& job, int x, int y) {
    Frame& frame = job.frame;
    const std::size_t i = frame.colour.index(x, y);
    std::array<Observer, pass_count> seen{};
    std::array<Hit, pass_count> hits;
    const Vec3 colour =
        walk_pixel(kernel, job, int2(x, y), int2(frame.width, frame.height), Pass::shade_indirect, seen, hits);

    frame.colour.pixels[i] = Vec4(colour, 1.0f);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        if (!frame.holds(Pass(pass))) continue;
        frame.layers[pass].hit.pixels[i] = hits[pass];
        if constexpr (requires { seen[pass].counters; }) frame.layers[pass].counters.pixels[i] = seen[pass].counters;
    }
}

// Up to N pixels through the passes, ray type by ray type, so that rays that are alike are traced
// together. What it computes of a pixel is what walk_pixel() does, to the same bits.
//
// No include guard: included once per instruction set, behind batch_trace.h.

template <class Kernel, class Observer, int N>
class PixelBatch {
  public:
    PixelBatch(Kernel& kernel, const TileJob& job)
        : kernel_(kernel), job_(job), tracer_(kernel, job.view.scene->bounds, job.view.in_force == CpuMode::packet) {}

    /// The pixels of a block of at most N.
    void trace(const Tile& block) {
        begin(block);
        trace_primary();
        shade(Pass::shade_prim);
        for (int bounce = 0; bounce < job_.view.needs.bounces; ++bounce) {
            if (!reflect(bounce == 0)) break;
            shade(Pass::shade_refl);
        }
        if (job_.view.needs.indirect) {
            scatter();
            shade(Pass::shade_indirect);
        }
        write();
    }

  private:
    using Path = typename Kernel::Path;
    using Surface = typename Kernel::Surface;
    template <class T>
    using Each = std::array<T, N>;

    /// Rays to trace, of some of the pixels.
    struct Rays {
        Each<Ray> ray;
        Each<Hit> hit;
        Each<int> pixel;
        std::size_t count = 0;

        void add(int of_pixel, const Ray& added) {
            pixel[count] = of_pixel;
            ray[count++] = added;
        }
    };

    Kernel& kernel_;
    const TileJob& job_;
    BatchTracer<Kernel, Observer, N> tracer_;
    int count_ = 0;
    Each<int2> place_;
    Each<Path> path_, primary_;
    Each<bool> alive_;  // the path goes on
    Each<Vec3> colour_;
    std::array<Each<Observer>, pass_count> seen_;
    std::array<Each<Hit>, pass_count> hits_;

    void begin(const Tile& block) {
        count_ = 0;
        for (int y = block.y0; y < block.y1; ++y)
            for (int x = block.x0; x < block.x1; ++x) place_[std::size_t(count_++)] = int2(x, y);
        seen_ = {};
        for (Each<Hit>& hits : hits_) hits.fill(Hit{-1, 0.0f, 0.0f, 0.0f});
        alive_.fill(true);
        colour_.fill(Vec3(0));
    }

    void trace(Rays& rays, Pass pass, bool any_hit) {
        if (rays.count == 0) return;
        Each<Observer> told{};
        Each<Observer>& seen = seen_[std::size_t(pass)];
        for (std::size_t i = 0; i < rays.count; ++i) told[i] = seen[std::size_t(rays.pixel[i])];
        tracer_.trace({rays.ray.data(), rays.count}, any_hit, rays.hit.data(), told.data());
        for (std::size_t i = 0; i < rays.count; ++i) seen[std::size_t(rays.pixel[i])] = told[i];
    }

    void trace_primary() {
        Rays rays;
        const int2 size(job_.frame.width, job_.frame.height);
        for (std::size_t i = 0; i < std::size_t(count_); ++i) {
            path_[i] = kernel_.primary_leg(job_.camera, place_[i], size);
            rays.add(int(i), path_[i].ray);
        }
        trace(rays, Pass::rt_prim, false);
        for (std::size_t i = 0; i < rays.count; ++i) hits_[0][i] = path_[i].hit = rays.hit[i];
        primary_ = path_;
    }

    /// shade_path() of every path that goes on: light_surface() with the loop over lights outside.
    void shade(Pass pass) {
        Each<Surface> surface;
        Each<Vec3> total{}, to_viewer;
        std::array<bool, N> shaded{};
        for (std::size_t i = 0; i < std::size_t(count_); ++i) {
            if (!alive_[i]) continue;
            if (path_[i].hit.triangle < 0) {
                colour_[i] += path_[i].weight * kernel_.scene_background();
                continue;
            }
            shaded[i] = true;
            surface[i] = kernel_.surface_of(path_[i]);
            total[i] = kernel_.own_light(surface[i], path_[i].leg);
            to_viewer[i] = -kernel_.normalise3(path_[i].ray.direction);
        }
        for (int i = 0; i < kernel_.light_count(); ++i) add_light(pass, i, surface, shaded, to_viewer, total);
        for (std::size_t i = 0; i < std::size_t(count_); ++i)
            if (shaded[i]) colour_[i] += path_[i].weight * total[i];
    }

    void add_light(Pass pass, int number, const Each<Surface>& surface, const std::array<bool, N>& shaded,
                   const Each<Vec3>& to_viewer, Each<Vec3>& total) {
        const Light light = kernel_.fetch_light(number);
        Each<typename Kernel::LightSample> sample;
        std::array<bool, N> lit{};
        Rays rays;
        for (std::size_t i = 0; i < std::size_t(count_); ++i) {
            if (!shaded[i]) continue;
            sample[i] = kernel_.sample_light(light, surface[i].position, kernel_.light_key(path_[i], number));
            lit[i] = kernel_.faces_light(surface[i], sample[i]);
            if (lit[i] && kernel_.shadows_enabled()) rays.add(int(i), kernel_.shadow_ray(surface[i], sample[i]));
        }
        trace(rays, pass, true);
        for (std::size_t k = 0; k < rays.count; ++k) {
            if (rays.hit[k].triangle < 0) continue;
            const auto i = std::size_t(rays.pixel[k]);
            lit[i] = false;
            Hit& first_blocked = hits_[std::size_t(pass)][i];
            if (first_blocked.triangle < 0) first_blocked = rays.hit[k];
        }
        for (std::size_t i = 0; i < std::size_t(count_); ++i)
            if (lit[i]) total[i] = total[i] + kernel_.reflected_light(surface[i], sample[i], to_viewer[i]);
    }

    /// The reflections that still count; false where none does.
    bool reflect(bool first) {
        Rays rays;
        for (std::size_t i = 0; i < std::size_t(count_); ++i) {
            if (!alive_[i]) continue;
            alive_[i] = kernel_.reflection_counts(kernel_.reflected_weight(path_[i]), job_.config.least_contribution);
            if (!alive_[i]) continue;
            path_[i] = kernel_.reflected_leg(path_[i]);
            rays.add(int(i), path_[i].ray);
        }
        trace_legs(rays, Pass::rt_refl, first);
        return rays.count > 0;
    }

    /// Indirect light, of the primary hits that scatter it.
    void scatter() {
        Rays rays;
        for (std::size_t i = 0; i < std::size_t(count_); ++i) {
            alive_[i] = kernel_.scatters(primary_[i]);
            if (!alive_[i]) continue;
            path_[i] = kernel_.indirect_leg(primary_[i]);
            rays.add(int(i), path_[i].ray);
        }
        trace_legs(rays, Pass::rt_indirect, true);
    }

    void trace_legs(Rays& rays, Pass pass, bool first) {
        trace(rays, pass, false);
        for (std::size_t k = 0; k < rays.count; ++k) {
            const auto i = std::size_t(rays.pixel[k]);
            path_[i].hit = rays.hit[k];
            alive_[i] = kernel_.path_counts(path_[i]);
            if (first) hits_[std::size_t(pass)][i] = rays.hit[k];
        }
    }

    void write() {
        Frame& frame = job_.frame;
        for (std::size_t i = 0; i < std::size_t(count_); ++i) {
            const std::size_t at = frame.colour.index(place_[i].x, place_[i].y);
            frame.colour.pixels[at] = Vec4(colour_[i], 1.0f);
            for (std::size_t pass = 0; pass < pass_count; ++pass) {
                if (!frame.holds(Pass(pass))) continue;
                frame.layers[pass].hit.pixels[at] = hits_[pass][i];
                if constexpr (requires { seen_[pass][i].counters; })
                    frame.layers[pass].counters.pixels[at] = seen_[pass][i].counters;
            }
        }
    }
};

#include <algorithm>

#include "renderer/gl/gl_tracer_impl.h"
#include "renderer/gl/ray_table.h"
#include "renderer/gl/state_guard.h"
#include "renderer/gl/target_reader.h"

namespace kd {

namespace {

constexpr int longest_row = 4096;
constexpr std::size_t largest_batch = std::size_t(longest_row) * 256;

/// Rows of rays as an image, drawn or computed.
class RayBatch {
  public:
    RayBatch(GlTracer::Impl& tracer, bool counters, std::size_t largest)
        : t_(tracer), gl_(tracer.gl), width_(int(std::min<std::size_t>(largest, longest_row))),
          height_(int((largest + std::size_t(width_) - 1) / std::size_t(width_))), counters_(counters),
          hit_(make_texture(gl_, GL_RGBA32UI, width_, height_, "ray hits")) {
        if (counters) {
            a_ = make_texture(gl_, GL_RGBA32UI, width_, height_, "ray counters a");
            b_ = make_texture(gl_, GL_RGBA32UI, width_, height_, "ray counters b");
        }
        framebuffer_ = make_framebuffer(gl_, {&a_, &b_, &hit_, nullptr, nullptr}, 0, "rays");
    }

    void trace(const ProgramSettings& settings, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
               std::span<RayCounters> counters) {
        const BufferTexture table = make_ray_table(gl_, rays);
        gl_blocks::FrameBlock block{};
        block.rays = {any_hit ? 1 : 0, int(rays.size()), width_, 0};
        block.tile = {0, 0, width_, height_};
        t_.frame_values = block;
        t_.frame_block.set(gl_, block);
        t_.frame_block.bind(gl_, frame_block);
        t_.scene().bind();
        table.bind(gl_, Unit::rays);
        if (t_.mode == GlMode::fragment)
            draw(settings);
        else
            compute(settings);

        const TargetReader reader(gl_, std::size_t(width_) * std::size_t(height_));
        reader.read_hits(hit_.id(), hits);
        if (counters_) reader.read_counters(a_.id(), b_.id(), counters);
        check_gl(gl_, "tracing rays");
    }

  private:
    void draw(const ProgramSettings& settings) {
        gl_.UseProgram(t_.program(Step::rays, settings));
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        gl_.Viewport(0, 0, width_, height_);
        t_.draw_quad();
    }

    void compute(const ProgramSettings& settings) {
        bind_images(gl_, {a_.id(), b_.id(), hit_.id(), 0, 0});
        if (t_.mode == GlMode::wavefront) return t_.run_wavefront(Step::rays, settings, {0, 0, width_, height_});
        gl_.UseProgram(t_.program(Step::rays, settings));
        t_.reset_counts();
        t_.dispatch(width_, height_);
    }

    GlTracer::Impl& t_;
    const GlApi& gl_;
    int width_, height_;
    bool counters_;
    GlTexture hit_, a_, b_;
    GlFramebuffer framebuffer_;
};

}  // namespace

void GlTracer::trace_rays(const TraceConfig& config, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
                          std::span<RayCounters> counters) {
    if (rays.empty()) return;
    const StateGuard guard(impl_->gl);
    TraceConfig own = config;
    own.counters = !counters.empty();
    own.shadows = false;  // one ray per invocation, whatever the lights
    if (impl_->mode == GlMode::wavefront) check_wavefront(own);
    impl_->scene().prepare(own, impl_->needs_of(own));

    const std::size_t fits = std::size_t(impl_->limits.buffer_texels) / texels_per_ray;
    const std::size_t batch_size = std::min({rays.size(), largest_batch, fits});
    RayBatch batch(*impl_, own.counters, batch_size);
    for (std::size_t first = 0; first < rays.size(); first += batch_size) {
        const std::size_t n = std::min(batch_size, rays.size() - first);
        batch.trace(impl_->settings_of(own), rays.subspan(first, n), any_hit, hits.subspan(first, n),
                    own.counters ? counters.subspan(first, n) : counters);
    }
}

}  // namespace kd

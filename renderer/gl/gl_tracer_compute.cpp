#include <algorithm>

#include "renderer/gl/frame_passes.h"

namespace kd {

namespace {

/// The passes as dispatches over the tile. What quads leave to depth, blending and cleared targets, the shaders do.
class ComputedPasses : public FramePasses {
  public:
    using FramePasses::FramePasses;

  private:
    void enter_tile() override { clear_tile(); }

    void prepare(Pass pass, int bounce) override {
        if (t_.mode == GlMode::wavefront)
            (void)t_.wavefront_programs(step_of(pass), settings_);
        else
            (void)t_.program(step_of(pass), settings_);
        const LayerTargets& layer = t_.targets.layer(pass);
        ImageSet images{layer.counters_a.id(), layer.counters_b.id(), layer.hit.id(), 0, 0};
        if (pass == Pass::rt_refl) {
            const PathTargets& path = t_.targets.path(bounce);
            images = {layer.counters_a.id(), layer.counters_b.id(), path.hit.id(), path.direction.id(),
                      path.weight.id()};
        } else if (pass != Pass::rt_prim) {
            images[static_cast<std::size_t>(Output::colour)] = t_.targets.colour();
        }
        bind_images(gl_, images);
    }

    void run(Pass pass) override {
        if (t_.mode == GlMode::wavefront) return t_.run_wavefront(step_of(pass), settings_, tile_);
        gl_.UseProgram(t_.program(step_of(pass), settings_));
        t_.dispatch(tile_.x1 - tile_.x0, tile_.y1 - tile_.y0);
    }
};

}  // namespace

void bind_images(const GlApi& gl, const ImageSet& images) {
    for (GLuint i = 0; i < output_count; ++i) {
        const bool words = i <= static_cast<GLuint>(Output::hit);
        gl.BindImageTexture(i, images[i], 0, GL_FALSE, 0, GL_READ_WRITE, words ? GL_RGBA32UI : GL_RGBA32F);
    }
}

void GlTracer::Impl::dispatch(int width, int height) const {
    // Over no pixel too: drivers finish compiling when a program first runs.
    const int columns = std::max(1, (width + compute.x - 1) / compute.x);
    const int rows = std::max(1, (height + compute.y - 1) / compute.y);
    if (compute.persistent > 0)
        gl.DispatchCompute(GLuint(std::min(compute.persistent, columns * rows)), 1, 1);
    else
        gl.DispatchCompute(GLuint(columns), GLuint(rows), 1);
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                     GL_FRAMEBUFFER_BARRIER_BIT | GL_ATOMIC_COUNTER_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

std::unique_ptr<FramePasses> computed_passes(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile,
                                             GlFrameReport& report) {
    return std::make_unique<ComputedPasses>(tracer, config, tile, report);
}

}  // namespace kd

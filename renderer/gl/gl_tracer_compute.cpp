#include <algorithm>

#include "renderer/gl/frame_passes.h"

namespace kd {

namespace {

void dispatch_blocks(const GlApi& gl, const ComputeSettings& compute, int width, int height) {
    // Over no pixel too: drivers finish compiling when a program first runs.
    const int columns = std::max(1, (width + compute.x - 1) / compute.x);
    const int rows = std::max(1, (height + compute.y - 1) / compute.y);
    if (compute.persistent > 0)
        gl.DispatchCompute(GLuint(std::min(compute.persistent, columns * rows)), 1, 1);
    else
        gl.DispatchCompute(GLuint(columns), GLuint(rows), 1);
}

/// What a dispatch has stored can then be read in any way.
void wait_for_stores(const GlApi& gl) {
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                     GL_FRAMEBUFFER_BARRIER_BIT | GL_ATOMIC_COUNTER_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                     GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

/// The passes as dispatches over the tile. What quads leave to depth, blending and cleared targets, the shaders do.
class ComputedPasses : public FramePasses {
  public:
    using FramePasses::FramePasses;

  private:
    void enter_tile() override { clear_tile(); }

    void prepare(Pass pass, int bounce) override {
        settings_.listed = t_.lists_pixels && (pass == Pass::rt_refl || pass == Pass::shade_refl);
        if (t_.mode == GlMode::wavefront)
            (void)t_.wavefront_programs(step_of(pass), settings_);
        else
            (void)t_.program(step_of(pass), settings_);
        if (makes_list(pass)) (void)t_.program(Step::list_reflections, settings_of_list());
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
        if (makes_list(pass)) list_pixels();
        gl_.UseProgram(t_.program(step_of(pass), settings_));
        if (!settings_.listed) return t_.dispatch(tile_.x1 - tile_.x0, tile_.y1 - tile_.y0);
        t_.pixels.dispatch(gl_);
        wait_for_stores(gl_);
    }

    /// ShadeRefl works at the pixels that RTRefl has worked at.
    [[nodiscard]] bool makes_list(Pass pass) const { return settings_.listed && pass == Pass::rt_refl; }

    /// Lists are made over the whole tile, each pixel by its own invocation.
    [[nodiscard]] ProgramSettings settings_of_list() const {
        ProgramSettings settings = settings_;
        settings.listed = false;
        settings.compute.persistent = 0;
        return settings;
    }

    void list_pixels() {
        t_.pixels.begin(gl_);
        gl_.UseProgram(t_.program(Step::list_reflections, settings_of_list()));
        dispatch_blocks(gl_, settings_of_list().compute, tile_.x1 - tile_.x0, tile_.y1 - tile_.y0);
        wait_for_stores(gl_);
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
    dispatch_blocks(gl, compute, width, height);
    wait_for_stores(gl);
}

std::unique_ptr<FramePasses> computed_passes(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile,
                                             GlFrameReport& report) {
    return std::make_unique<ComputedPasses>(tracer, config, tile, report);
}

}  // namespace kd

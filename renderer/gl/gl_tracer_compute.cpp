#include <algorithm>

#include "renderer/gl/frame_passes.h"

namespace kd {

namespace {

/// Rows of groups are dealt in whole turns (shaders/compute/dealt_groups.glsl); those past the tile have no pixel.
int rows_dealt(const ComputeSettings& compute, int rows) {
    constexpr int dealt_to = 8;
    return compute.dealt.value_or(false) ? (rows + dealt_to - 1) / dealt_to * dealt_to : rows;
}

void dispatch_blocks(const GlApi& gl, const ComputeSettings& compute, int width, int height) {
    // Over no pixel too: drivers finish compiling when a program first runs.
    const int columns = std::max(1, (width + compute.x - 1) / compute.x);
    const int rows = rows_dealt(compute, std::max(1, (height + compute.y - 1) / compute.y));
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
        settings_.listed = t_.lists_pixels && pass != Pass::rt_prim;
        if (makes_list(pass)) {
            (void)list_program(pass);
            if (pass == Pass::shade_prim) (void)program(step_of(pass), false);
            if (pass == Pass::rt_refl) (void)program(Step::list_reflections, false);
        }
        if (t_.mode == GlMode::wavefront)
            (void)t_.wavefront_programs(step_of(pass), settings_);
        else
            (void)t_.program(step_of(pass), settings_);
        const LayerTargets& layer = t_.targets.layer(pass);
        ImageSet images{layer.counters_a.id(), layer.counters_b.id(), layer.hit.id(), 0, 0};
        if (pass == Pass::rt_refl || pass == Pass::rt_indirect) {
            const PathTargets& path = pass == Pass::rt_refl ? t_.targets.path(bounce) : t_.targets.indirect_path();
            images = {layer.counters_a.id(), layer.counters_b.id(), path.hit.id(), path.direction.id(),
                      path.weight.id()};
        } else if (pass != Pass::rt_prim) {
            images[static_cast<std::size_t>(Output::colour)] = t_.targets.colour();
        }
        bind_images(gl_, images);
    }

    void run(Pass pass) override {
        if (t_.mode == GlMode::wavefront) return t_.run_wavefront(step_of(pass), settings_, tile_);
        settings_.listed = makes_list(pass) ? keeps_list(pass) : settings_.listed;
        gl_.UseProgram(t_.program(step_of(pass), settings_));
        run_over(settings_.listed);
    }

    void run_over(bool listed) const {
        if (listed)
            t_.pixels.dispatch(gl_);
        else
            dispatch_blocks(gl_, t_.compute, tile_.x1 - tile_.x0, tile_.y1 - tile_.y0);
        wait_for_stores(gl_);
    }

    /// ShadeRefl and ShadeIndirect work at the pixels that the pass before has worked at.
    [[nodiscard]] bool makes_list(Pass pass) const {
        return settings_.listed && (pass == Pass::shade_prim || !shades(pass));
    }

    /// Whether the pass works at a list, which is made where that has to be known. Reflections are too few to fill one.
    [[nodiscard]] bool keeps_list(Pass pass) {
        if (pass == Pass::shade_prim && !t_.hits_fill.asks_for_list(tile_, rows())) return false;
        list_pixels(pass);
        if (pass != Pass::shade_prim) return true;
        return t_.hits_fill.keeps_list(tile_, rows(), t_.pixels.filled(gl_, settings_.compute.y));
    }

    [[nodiscard]] int rows() const { return t_.targets.key().height; }

    /// Only what was hit can reflect, and only what has reflected can reflect again.
    [[nodiscard]] bool lists_out_of_list(Pass pass) const { return pass == Pass::rt_refl && has_list_; }

    [[nodiscard]] GLuint list_program(Pass pass) const {
        return program(pass == Pass::rt_refl ? Step::list_reflections : Step::list_hits, lists_out_of_list(pass));
    }

    /// Over a list or over all pixels, whatever this pass does.
    [[nodiscard]] GLuint program(Step step, bool listed) const {
        ProgramSettings settings = settings_;
        settings.listed = listed;
        return t_.program(step, settings);
    }

    void list_pixels(Pass pass) {
        t_.pixels.begin_next(gl_);
        gl_.UseProgram(list_program(pass));
        run_over(lists_out_of_list(pass));
        t_.pixels.take_next(gl_);
        has_list_ = true;
    }

    bool has_list_ = false;  // of the pass before, or of one before that
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

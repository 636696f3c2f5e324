#include "renderer/gl/gl_debug.h"
#include "renderer/gl/gl_tracer_impl.h"

namespace kd {

namespace {

/// One tile's way through the passes (paper, figure 8).
class TileDraw {
  public:
    TileDraw(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile, GlFrameReport& report)
        : t_(tracer), gl_(tracer.gl), config_(config), settings_(tracer.settings_of(config.trace)), tile_(tile),
          report_(report) {
        settings_.early_z = config.early_z;
        settings_.count_shaded = config.count_shaded;
    }

    void run() {
        const FrameTargets& targets = t_.targets;
        t_.timer.begin_frame();
        enter_tile();

        pass(Pass::rt_prim, targets.framebuffer(Pass::rt_prim));

        bind_texture(gl_, Unit::path_hit, targets.layer(Pass::rt_prim).hit);
        pass(Pass::shade_prim, targets.framebuffer(Pass::shade_prim));

        const int bounces = settings_.needs.bounces;
        for (int bounce = 0; bounce < bounces; ++bounce) reflect(bounce);
        t_.timer.end_frame(report_);
    }

  private:
    GlTracer::Impl& t_;
    const GlApi& gl_;
    const GlTraceConfig& config_;
    ProgramSettings settings_;
    Tile tile_;
    GlFrameReport& report_;

    void enter_tile() {
        const TargetKey& key = t_.targets.key();
        gl_.Viewport(0, 0, key.width, key.height);
        gl_.Enable(GL_SCISSOR_TEST);
        gl_.Scissor(tile_.x0, tile_.y0, tile_.x1 - tile_.x0, tile_.y1 - tile_.y0);
        const Vec3 background = t_.scene().scene().background;
        t_.targets.clear(gl_, {background.x, background.y, background.z, 1.0f});
        gl_.Enable(GL_DEPTH_TEST);
        t_.scene().bind();
        t_.frame_block.bind(gl_, frame_block);
    }

    void reflect(int bounce) {
        settings_.later_bounce = bounce > 0;
        if (bounce > 0) {
            bind_path(bounce - 1);
            if (config_.early_z == EarlyZ::working) mark();
            keep_earlier(Pass::rt_refl);
        }
        // The first bounce reads RTPrim's hit, bound already.
        pass(Pass::rt_refl, t_.targets.bounce_framebuffer(bounce));
        if (bounce == 0 && t_.targets.key().bounces > 1)
            copy(t_.targets.path(0).hit, t_.targets.layer(Pass::rt_refl).hit);

        bind_path(bounce);
        if (bounce > 0) keep_earlier(Pass::shade_refl);
        pass(Pass::shade_refl, t_.targets.framebuffer(Pass::shade_refl));
    }

    void bind_path(int bounce) {
        const PathTargets& path = t_.targets.path(bounce);
        bind_texture(gl_, Unit::path_hit, path.hit);
        bind_texture(gl_, Unit::path_direction, path.direction);
        bind_texture(gl_, Unit::path_weight, path.weight);
    }

    /// Raises the depth of paths that end.
    void mark() {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, t_.targets.framebuffer(Pass::rt_prim));
        gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        draw(Step::mark);
        gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }

    /// Copies a layer for a pass that goes on from it: a pass cannot read what it draws into.
    void keep_earlier(Pass pass) {
        if (pass == Pass::shade_refl && !t_.targets.key().shadows) return;
        const LayerTargets& layer = t_.targets.layer(pass);
        const LayerTargets& earlier = t_.targets.earlier();
        if (pass == Pass::shade_refl) {
            copy(layer.hit, earlier.hit);
            bind_texture(gl_, Unit::earlier_hit, earlier.hit);
        }
        if (!t_.targets.key().counters) return;
        copy(layer.counters_a, earlier.counters_a);
        copy(layer.counters_b, earlier.counters_b);
        bind_texture(gl_, Unit::earlier_counters_a, earlier.counters_a);
        bind_texture(gl_, Unit::earlier_counters_b, earlier.counters_b);
    }

    void copy(const GlTexture& from, const GlTexture& to) {
        if (tile_ == Tile{}) return;
        gl_.CopyImageSubData(from.id(), GL_TEXTURE_2D, 0, tile_.x0, tile_.y0, 0, to.id(), GL_TEXTURE_2D, 0, tile_.x0,
                             tile_.y0, 0, tile_.x1 - tile_.x0, tile_.y1 - tile_.y0, 1);
    }

    void draw(Step step) {
        const DepthRule rule = depth_rule(step, config_.early_z);
        gl_.DepthFunc(rule.function);
        gl_.DepthMask(rule.write ? GL_TRUE : GL_FALSE);
        gl_.UseProgram(t_.program(step, settings_));
        t_.draw_quad();
        gl_.DepthMask(GL_TRUE);
    }

    void pass(Pass pass, GLuint framebuffer) {
        const auto colour = static_cast<GLuint>(Output::colour);
        const bool adds = pass == Pass::shade_refl;
        const GlGroup group(gl_, pass_names[static_cast<std::size_t>(pass)]);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        if (adds) {
            gl_.Enablei(GL_BLEND, colour);
            gl_.BlendEquation(GL_FUNC_ADD);
            gl_.BlendFunci(colour, GL_ONE, GL_ONE);  // the shader's alpha is 0
        }
        if (config_.count_shaded) reset_shaded();
        // Compiled here where it was not prepared, outside of the pass's time.
        (void)t_.program(step_of(pass), settings_);
        t_.timer.begin(pass);
        draw(step_of(pass));
        t_.timer.end();
        if (config_.count_shaded) add_shaded(pass);
        if (adds) gl_.Disable(GL_BLEND);
    }

    static Step step_of(Pass pass) { return static_cast<Step>(pass); }

    void reset_shaded() {
        const GLuint zero = 0;
        gl_.BindBufferBase(GL_ATOMIC_COUNTER_BUFFER, shaded_counter, t_.shaded_counter.id());
        gl_.BufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof zero, &zero);
    }

    void add_shaded(Pass pass) {
        GLuint count = 0;
        gl_.GetBufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof count, &count);
        std::int64_t& sum = report_.shaded_pixels[static_cast<std::size_t>(pass)];
        sum = (sum < 0 ? 0 : sum) + count;
    }
};

static_assert(static_cast<int>(Step::shade_refl) == static_cast<int>(Pass::shade_refl));

gl_blocks::FrameBlock encode_block(const GlTraceConfig& config, const PinholeCamera& camera, const TargetKey& size,
                                   const EntryPoints& entries) {
    return {
        .eye = Vec4(camera.eye, 0.0f),
        .right = Vec4(camera.right, 0.0f),
        .up = Vec4(camera.up, 0.0f),
        .forward = Vec4(camera.forward, 0.0f),
        .image = {size.width, size.height, 0, 0},
        .rays = {0, 0, 1, entries.nodes.front()},
        .criteria = {config.trace.least_contribution, 0.0f, 0.0f, 0.0f},
        .entry = {entries.x0, entries.y0, entries.tile, entries.columns},
    };
}

}  // namespace

void GlTracer::Impl::draw_tile(const GlTraceConfig& config, const PinholeCamera& camera, Tile tile,
                               GlFrameReport& report) {
    const EntryPoints entries = scene().entries(
        config.trace, {camera, targets.key().width, targets.key().height, tile.x0, tile.y0, tile.x1, tile.y1});
    frame_block.set(gl, encode_block(config, camera, targets.key(), entries));
    BufferTexture table;
    if (enters_by_tile(config.trace)) {
        table = BufferTexture(gl, GL_R32I, entries.nodes, "entry points");
        table.bind(gl, Unit::entries);
    }
    TileDraw(*this, config, tile, report).run();
    check_gl(gl, "drawing the passes");
}

}  // namespace kd

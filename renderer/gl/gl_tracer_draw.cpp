#include "renderer/gl/frame_passes.h"

namespace kd {

namespace {

/// The passes as screen-aligned quads.
class DrawnPasses : public FramePasses {
  public:
    using FramePasses::FramePasses;

  private:
    void enter_tile() override {
        const TargetKey& key = t_.targets.key();
        gl_.Viewport(0, 0, key.width, key.height);
        clear_tile();
        gl_.Enable(GL_DEPTH_TEST);
    }

    void prepare(Pass pass, int bounce) override {
        if (bounce > 0) {
            if (pass == Pass::rt_refl && config_.early_z == EarlyZ::working) mark();
            keep_earlier(pass);
        }
        const bool traces_bounce = pass == Pass::rt_refl;
        gl_.BindFramebuffer(GL_FRAMEBUFFER,
                            traces_bounce ? t_.targets.bounce_framebuffer(bounce) : t_.targets.framebuffer(pass));
        if (adds_light(pass)) {
            gl_.Enablei(GL_BLEND, colour_buffer);
            gl_.BlendEquation(GL_FUNC_ADD);
            gl_.BlendFunci(colour_buffer, GL_ONE, GL_ONE);  // the shader's alpha is 0
        }
        (void)t_.program(step_of(pass), settings_);
    }

    void run(Pass pass) override { draw(step_of(pass)); }

    void finish(Pass pass) override {
        if (adds_light(pass)) gl_.Disable(GL_BLEND);
    }

    static bool adds_light(Pass pass) { return shades(pass) && pass != Pass::shade_prim; }

    static constexpr auto colour_buffer = static_cast<GLuint>(Output::colour);

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

    void draw(Step step) {
        const DepthRule rule = depth_rule(step, config_.early_z);
        gl_.DepthFunc(rule.function);
        gl_.DepthMask(rule.write ? GL_TRUE : GL_FALSE);
        gl_.UseProgram(t_.program(step, settings_));
        t_.draw_quad();
        gl_.DepthMask(GL_TRUE);
    }
};

}  // namespace

std::unique_ptr<FramePasses> drawn_passes(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile,
                                          GlFrameReport& report) {
    return std::make_unique<DrawnPasses>(tracer, config, tile, report);
}

}  // namespace kd

// One tile's way through the paper's passes, whatever kind of shaders runs them.
#pragma once

#include <memory>

#include "renderer/gl/gl_tracer_impl.h"

namespace kd {

/// The order of the passes (paper, figure 8), their times and what is counted. A kind of shaders says how one runs.
class FramePasses {
  public:
    FramePasses(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile, GlFrameReport& report);
    virtual ~FramePasses() = default;
    FramePasses(const FramePasses&) = delete;
    FramePasses& operator=(const FramePasses&) = delete;

    void run();

  protected:
    // NOLINTBEGIN: what the kinds of shaders work on
    GlTracer::Impl& t_;
    const GlApi& gl_;
    const GlTraceConfig& config_;
    ProgramSettings settings_;
    const Tile tile_;
    // NOLINTEND

    /// Before all passes.
    virtual void enter_tile() = 0;
    /// Compiles and binds what the pass of a bounce (0 first) runs on; not timed.
    virtual void prepare(Pass pass, int bounce) = 0;
    /// Timed.
    virtual void run(Pass pass) = 0;
    /// Not timed.
    virtual void finish(Pass /*pass*/) {}

    static Step step_of(Pass pass) { return static_cast<Step>(pass); }
    /// Sets the tile to untraced, and limits drawing to it.
    void clear_tile();
    /// Copies the tile.
    void copy(const GlTexture& from, const GlTexture& to);

  private:
    GlFrameReport& report_;

    void reflect(int bounce);
    void scatter();
    void bind_path(const PathTargets& path);
    void pass(Pass pass, int bounce);
    void add_shaded(Pass pass);
};

static_assert(static_cast<int>(Step::shade_indirect) == static_cast<int>(Pass::shade_indirect));

/// The passes as screen-aligned quads (gl_tracer_draw.cpp) and as dispatches (gl_tracer_compute.cpp).
[[nodiscard]] std::unique_ptr<FramePasses> drawn_passes(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile,
                                                        GlFrameReport& report);
[[nodiscard]] std::unique_ptr<FramePasses> computed_passes(GlTracer::Impl& tracer, const GlTraceConfig& config,
                                                           Tile tile, GlFrameReport& report);

}  // namespace kd

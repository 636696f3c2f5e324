#include "renderer/gl/gl_tracer.h"

#include <algorithm>
#include <utility>

#include "renderer/gl/gl_tracer_impl.h"
#include "renderer/gl/self_test.h"
#include "renderer/gl/state_guard.h"

namespace kd {

namespace {

GlLimits limits_of(const GlApi& gl) {
    GLint texels = 0;
    GLint size = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    return {texels, size};
}

/// Takes back at the end, also of a failure, that programs are being compiled.
class CompilingNote {
  public:
    explicit CompilingNote(GlTracer::Impl& tracer) : tracer_(tracer) {}
    ~CompilingNote() {
        if (std::exchange(tracer_.compiling, 0) > 0 && tracer_.told_compiling) tracer_.told_compiling(0);
    }
    CompilingNote(const CompilingNote&) = delete;
    CompilingNote& operator=(const CompilingNote&) = delete;

  private:
    GlTracer::Impl& tracer_;
};

}  // namespace

GlTracer::Impl::Impl(Context& context, GlMode how)
    : gl(context.gl()), mode(how), compute(compute_settings_in_force()), software(context.is_software()),
      // GLSL lets fma() round twice. NVIDIA's machines have it as one instruction; verify would show it elsewhere.
      fused(context.renderer().find("NVIDIA") != std::string::npos), limits(limits_of(gl)), programs(gl),
      timer(gl, software), no_vertices(gl), frame_block(gl), counts(gl) {
    if (!compute.lists) compute.lists = software;
    if (!compute.dealt) compute.dealt = software;
    if (mode != GlMode::fragment) {
        GLint64 bytes = 0;
        gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
        storage_bytes = bytes;
        if (compute.storage) limits.storage_bytes = bytes;
    }
    gl.BindBuffer(GL_ATOMIC_COUNTER_BUFFER, counts.id());
    gl.BufferData(GL_ATOMIC_COUNTER_BUFFER, sizeof(GLuint), nullptr, GL_DYNAMIC_READ);
    check_gl(gl, "making a tracer");
}

SceneUpload& GlTracer::Impl::scene() {
    if (!uploaded) throw GlError("OpenGL: no scene has been uploaded");
    return *uploaded;
}

SceneNeeds GlTracer::Impl::needs_of(const TraceConfig& config) { return scene_needs(scene().facts(), config); }

ProgramSettings GlTracer::Impl::settings_of(const TraceConfig& config) {
    ProgramSettings settings;
    settings.mode = mode;
    settings.compute = compute;
    settings.trace = config;
    settings.needs = needs_of(config);
    settings.limited_loops = software;
    settings.fused = fused;
    settings.corrected_rounding = corrected_rounding;
    return settings;
}

GLuint GlTracer::Impl::program(Step step, const ProgramSettings& settings) {
    return programs.get(program_key(step, settings)).id();
}

void GlTracer::Impl::reset_counts() const {
    constexpr GLuint none = 0;
    gl.BindBufferBase(GL_ATOMIC_COUNTER_BUFFER, counts_buffer, counts.id());
    gl.BufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof none, &none);
}

void GlTracer::Impl::draw_quad() const {
    gl.BindVertexArray(no_vertices.id());
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void GlTracer::Impl::make_ready(const TraceConfig& config, int width, int height) {
    check_image(width, height, limits);
    if (mode == GlMode::wavefront) check_wavefront(config);
    const SceneNeeds needs = needs_of(config);
    scene().prepare(config, needs);
    if (mode == GlMode::wavefront) {
        const auto lights = std::max<std::int64_t>(1, std::ssize(scene().scene().lights));
        queues.reserve(gl, lights * width * height, words_per_ray(config, needs), storage_bytes);
    }
    lists_pixels =
        mode == GlMode::compute && *compute.lists && pixels.reserve(gl, std::int64_t(width) * height, storage_bytes);
    const TargetKey key = target_key(needs, width, height);
    if (targets.key() == key) return;
    targets = FrameTargets();  // lets go of the old ones first
    targets = FrameTargets(gl, key);
}

void bind_texture(const GlApi& gl, Unit unit, const GlTexture& texture) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
}

GlTracer::GlTracer(Context& context, GlMode mode) : impl_(std::make_unique<Impl>(context, mode)) {
    self_test(*this, context.renderer());
    impl_->uploaded.reset();
}

GlTracer::~GlTracer() = default;

void GlTracer::upload(const FlatScene& scene, const KdTree& tree) {
    // The old upload goes when the new one is whole.
    SceneUpload next(impl_->gl, impl_->limits, scene, tree);
    impl_->uploaded.emplace(std::move(next));
    impl_->hits_fill = {};
}

void GlTracer::prepare(const GlTraceConfig& config, int width, int height) {
    if (width <= 0 || height <= 0) return;
    const StateGuard guard(impl_->gl);
    const CompilingNote note(*impl_);
    impl_->make_ready(config.trace, width, height);
    // Drivers finish compiling when a program is first drawn with, so every pass is drawn once over no pixel.
    GlFrameReport unused;
    impl_->draw_tile(config, PinholeCamera{}, Tile{}, unused);
    impl_->gl.Finish();
}

void GlTracer::tell_compiling(std::function<void(int)> told) {
    impl_->told_compiling = std::move(told);
    impl_->programs.tell_compiling([impl = impl_.get()] {
        ++impl->compiling;
        if (impl->told_compiling) impl->told_compiling(impl->compiling);
    });
}

GlFrameReport GlTracer::draw(const GlTraceConfig& config, const PinholeCamera& camera, int width, int height,
                             Tile tile) {
    GlFrameReport report;
    if (width <= 0 || height <= 0) return report;
    const StateGuard guard(impl_->gl);
    impl_->make_ready(config.trace, width, height);
    tile = {std::max(tile.x0, 0), std::max(tile.y0, 0), std::min(tile.x1, width), std::min(tile.y1, height)};
    if (tile.x0 >= tile.x1 || tile.y0 >= tile.y1) return report;
    impl_->draw_tile(config, camera, tile, report);
    return report;
}

void GlTracer::correct_rounding(bool on) { impl_->corrected_rounding = on; }

GlMemory GlTracer::memory() const {
    GlMemory memory;
    if (impl_->uploaded) impl_->uploaded->add_to(memory);
    memory.targets = impl_->targets.bytes();
    memory.rays = impl_->queues.bytes() + impl_->pixels.bytes();
    return memory;
}

}  // namespace kd

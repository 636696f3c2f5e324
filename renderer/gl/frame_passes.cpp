#include "renderer/gl/frame_passes.h"

#include "renderer/gl/gl_debug.h"

namespace kd {

namespace {

gl_blocks::FrameBlock encode_block(const GlTraceConfig& config, const PinholeCamera& camera, const TargetKey& size,
                                   const EntryPoints& entries, const Tile& tile) {
    return {
        .eye = Vec4(camera.eye, 0.0f),
        .right = Vec4(camera.right, 0.0f),
        .up = Vec4(camera.up, 0.0f),
        .forward = Vec4(camera.forward, 0.0f),
        .image = {size.width, size.height, 0, 0},
        .rays = {0, 0, 1, entries.nodes.front()},
        .criteria = {config.trace.least_contribution, 0.0f, 0.0f, 0.0f},
        .entry = {entries.x0, entries.y0, entries.tile, entries.columns},
        .tile = {tile.x0, tile.y0, tile.x1, tile.y1},
        .wave = {},
        .sampling = {config.trace.sampling.sample, int(config.trace.sampling.seed), 0, 0},
    };
}

std::unique_ptr<FramePasses> make_passes(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile,
                                         GlFrameReport& report) {
    return tracer.mode == GlMode::fragment ? drawn_passes(tracer, config, tile, report)
                                           : computed_passes(tracer, config, tile, report);
}

}  // namespace

FramePasses::FramePasses(GlTracer::Impl& tracer, const GlTraceConfig& config, Tile tile, GlFrameReport& report)
    : t_(tracer), gl_(tracer.gl), config_(config), settings_(tracer.settings_of(config.trace)), tile_(tile),
      report_(report) {
    settings_.early_z = config.early_z;
    settings_.count_shaded = config.count_shaded;
}

void FramePasses::run() {
    t_.timer.begin_frame();
    enter_tile();
    t_.scene().bind();
    t_.frame_block.bind(gl_, frame_block);

    pass(Pass::rt_prim, 0);
    bind_texture(gl_, Unit::path_hit, t_.targets.layer(Pass::rt_prim).hit);
    pass(Pass::shade_prim, 0);
    const int bounces = settings_.needs.bounces;
    for (int bounce = 0; bounce < bounces; ++bounce) reflect(bounce);
    if (settings_.needs.indirect) scatter();
    t_.timer.end_frame(report_);
}

void FramePasses::reflect(int bounce) {
    settings_.later_bounce = bounce > 0;
    // The first bounce reads RTPrim's hit, bound already.
    if (bounce > 0) bind_path(t_.targets.path(bounce - 1));
    pass(Pass::rt_refl, bounce);
    if (bounce == 0 && t_.targets.key().bounces > 1) copy(t_.targets.path(0).hit, t_.targets.layer(Pass::rt_refl).hit);
    bind_path(t_.targets.path(bounce));
    pass(Pass::shade_refl, bounce);
}

void FramePasses::scatter() {
    settings_.later_bounce = false;
    bind_texture(gl_, Unit::path_hit, t_.targets.layer(Pass::rt_prim).hit);
    pass(Pass::rt_indirect, 0);
    bind_path(t_.targets.indirect_path());
    pass(Pass::shade_indirect, 0);
}

void FramePasses::bind_path(const PathTargets& path) {
    bind_texture(gl_, Unit::path_hit, path.hit);
    bind_texture(gl_, Unit::path_direction, path.direction);
    bind_texture(gl_, Unit::path_weight, path.weight);
}

void FramePasses::clear_tile() {
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(tile_.x0, tile_.y0, tile_.x1 - tile_.x0, tile_.y1 - tile_.y0);
    const Vec3 background = t_.scene().scene().background;
    t_.targets.clear(gl_, {background.x, background.y, background.z, 1.0f});
}

void FramePasses::copy(const GlTexture& from, const GlTexture& to) {
    if (tile_ == Tile{}) return;
    gl_.CopyImageSubData(from.id(), GL_TEXTURE_2D, 0, tile_.x0, tile_.y0, 0, to.id(), GL_TEXTURE_2D, 0, tile_.x0,
                         tile_.y0, 0, tile_.x1 - tile_.x0, tile_.y1 - tile_.y0, 1);
}

void FramePasses::pass(Pass pass, int bounce) {
    const GlGroup group(gl_, pass_names[static_cast<std::size_t>(pass)]);
    prepare(pass, bounce);
    if (config_.count_shaded) t_.reset_counts();
    t_.timer.begin(pass);
    run(pass);
    t_.timer.end();
    if (config_.count_shaded) add_shaded(pass);
    finish(pass);
}

void FramePasses::add_shaded(Pass pass) {
    GLuint count = 0;
    gl_.GetBufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof count, &count);
    std::int64_t& sum = report_.shaded_pixels[static_cast<std::size_t>(pass)];
    sum = (sum < 0 ? 0 : sum) + count;
}

void GlTracer::Impl::draw_tile(const GlTraceConfig& config, const PinholeCamera& camera, Tile tile,
                               GlFrameReport& report) {
    const EntryPoints entries = scene().entries(
        config.trace, {camera, targets.key().width, targets.key().height, tile.x0, tile.y0, tile.x1, tile.y1});
    frame_values = encode_block(config, camera, targets.key(), entries, tile);
    frame_block.set(gl, frame_values);
    BufferTexture table;
    if (enters_by_tile(config.trace)) {
        table = BufferTexture(gl, GL_R32I, entries.nodes, "entry points");
        table.bind(gl, Unit::entries);
    }
    make_passes(*this, config, tile, report)->run();
    check_gl(gl, "drawing the passes");
}

}  // namespace kd

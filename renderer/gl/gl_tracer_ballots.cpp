#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "renderer/gl/gl_tracer_impl.h"
#include "renderer/gl/ray_table.h"
#include "renderer/gl/state_guard.h"
#include "renderer/gl/target_reader.h"

namespace kd {

namespace {

bool has_extension(const GlApi& gl, std::string_view wanted) {
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (name && wanted == name) return true;
    }
    return false;
}

/// Lanes are those of fragment shaders, whatever else the tracer runs.
ProgramKey ballot_key(ProgramSettings settings, const BallotSupport& support, Schedule loop) {
    settings.mode = GlMode::fragment;
    ProgramKey key = program_key(Step::rays, settings);
    key.fragment = "fragment/lockstep.frag";
    key.defines["KD_BALLOTS"] = support.kind == BallotSupport::Kind::arb ? "1" : "2";
    key.defines["KD_NV_THREAD_GROUP"] = support.multiprocessors ? "1" : "0";
    key.defines["KD_IF_IF"] = loop == Schedule::if_if ? "1" : "0";
    key.defines["KD_STEPS"] = steps_of(settings.trace.traversal);
    return key;
}

/// The targets of shaders/fragment/lockstep.frag, cleared.
struct BallotTargets {
    GlTexture counters_a, counters_b, hit, ballots, place;
    GlFramebuffer framebuffer;

    BallotTargets(const GlApi& gl, int width, int height) {
        for (GlTexture* texture : {&counters_a, &counters_b, &hit, &ballots, &place})
            *texture = make_texture(gl, GL_RGBA32UI, width, height, "ballots");
        framebuffer = make_framebuffer(gl, {&counters_a, &counters_b, &hit, &ballots, &place}, 0, "ballots");
        constexpr std::array<GLuint, 4> nothing{};
        for (GLint i = 0; i < GLint(output_count); ++i) gl.ClearBufferuiv(GL_COLOR, i, nothing.data());
    }

    [[nodiscard]] BallotLayer read(const GlApi& gl, int width, int height) const {
        BallotLayer layer{0, false, {width, height}, {width, height}, {width, height}};
        const TargetReader reader(gl, layer.hit.pixels.size());
        reader.read_hits(hit.id(), layer.hit.pixels);
        reader.read_counters(counters_a.id(), counters_b.id(), layer.counters.pixels);
        const auto counts = reader.words(ballots.id());
        const auto places = reader.words(place.id());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const glm::uvec4 &c = counts[i], &p = places[i];
            layer.lanes.pixels[i] = {{c.x, c.y}, {c.z, c.w}, p.x, p.y, p.z};
            layer.group_size = std::max(layer.group_size, int(p.w));
        }
        return layer;
    }
};

/// Covers the picture with one triangle that needs no clipping: half of a square four times its size. A strip's
/// diagonal cuts groups in two on llvmpipe. Where so large a viewport is not to be had, the strip it is.
void draw_without_seam(const GlApi& gl, const GlVertexArray& no_vertices, int width, int height) {
    std::array<GLint, 2> largest{};
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, largest.data());
    const bool fits = 2 * width <= largest[0] && 2 * height <= largest[1];
    gl.Viewport(0, 0, fits ? 2 * width : width, fits ? 2 * height : height);
    gl.BindVertexArray(no_vertices.id());
    gl.DrawArrays(fits ? GL_TRIANGLES : GL_TRIANGLE_STRIP, 0, fits ? 3 : 4);
}

void check_ballots(const BallotSupport& support, const TraceConfig& config, Schedule loop) {
    if (support.kind == BallotSupport::Kind::none)
        throw BallotError(
            "the driver has neither GL_ARB_shader_ballot nor GL_KHR_shader_subgroup, so its lanes cannot be counted");
    if (loop == Schedule::lockstep)
        throw BallotError("no machine runs the idealised lockstep; choose if-if or while-while");
    if (!has_ballot_loop(config))
        throw BallotError(
            fmt::format("no loop that counts lanes is written for {} under rules {}; choose a walk of the tree under "
                        "the robust rules",
                        info(config.traversal).name, info(config.rules).name));
}

}  // namespace

std::string BallotSupport::extensions() const {
    if (kind == Kind::none) return "";
    return std::string(kind == Kind::arb ? "GL_ARB_shader_ballot" : "GL_KHR_shader_subgroup") +
           (multiprocessors ? ", GL_NV_shader_thread_group" : "");
}

BallotSupport ballot_support(const GlApi& gl) {
    BallotSupport support;
    if (!has_extension(gl, "GL_ARB_ES3_1_compatibility")) return support;
    if (has_extension(gl, "GL_ARB_shader_ballot") && has_extension(gl, "GL_ARB_gpu_shader_int64"))
        support.kind = BallotSupport::Kind::arb;
    else if (has_extension(gl, "GL_KHR_shader_subgroup"))
        support.kind = BallotSupport::Kind::khr;
    support.multiprocessors = has_extension(gl, "GL_NV_shader_thread_group");
    return support;
}

bool has_ballot_loop(const TraceConfig& config) {
    return config.rules == Rules::robust && *steps_of(config.traversal) != '\0';
}

BallotLayer GlTracer::measure_ballots(const TraceConfig& config, Schedule loop, std::span<const Ray> rays, bool any_hit,
                                      int width, int height) {
    Impl& t = *impl_;
    const GlApi& gl = t.gl;
    const BallotSupport support = ballot_support(gl);
    check_ballots(support, config, loop);
    check_image(width, height, t.limits);
    const StateGuard guard(gl);
    TraceConfig own = config;
    own.counters = true;
    own.shadows = false;  // one ray per invocation, whatever the lights
    t.scene().prepare(own, t.needs_of(own));

    const BallotTargets targets(gl, width, height);
    const BufferTexture table = make_ray_table(gl, rays);
    gl_blocks::FrameBlock block{};
    block.rays = {any_hit ? 1 : 0, int(rays.size()), width, 0};
    t.frame_block.set(gl, block);
    t.frame_block.bind(gl, frame_block);
    t.scene().bind();
    table.bind(gl, Unit::rays);
    gl.BindFramebuffer(GL_FRAMEBUFFER, targets.framebuffer.id());
    gl.UseProgram(t.programs.get(ballot_key(t.settings_of(own), support, loop)).id());
    draw_without_seam(gl, t.no_vertices, width, height);
    BallotLayer layer = targets.read(gl, width, height);
    layer.tells_multiprocessors = support.multiprocessors;
    check_gl(gl, "counting lanes");
    return layer;
}

}  // namespace kd

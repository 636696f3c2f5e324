#include "renderer/gl/multiprocessors.h"

#include <algorithm>
#include <set>

#include "renderer/gl/ballots.h"
#include "renderer/gl/compute_settings.h"
#include "renderer/gl/frame_targets.h"
#include "renderer/gl/program.h"
#include "renderer/gl/state_guard.h"
#include "renderer/gl/target_reader.h"

namespace kd {

namespace {

void draw(const GlApi& gl, const GlTexture& places, int width, int height) {
    const GlProgram program(gl, {"fragment/quad.vert", "fragment/multiprocessors.frag", {{"KD_QUAD_DEPTH", "0.0"}}},
                            default_shader_reader());
    const GlFramebuffer framebuffer = make_framebuffer(gl, {nullptr, nullptr, &places, nullptr, nullptr}, 0, "places");
    const GlVertexArray no_vertices(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.Viewport(0, 0, width, height);
    gl.UseProgram(program.id());
    gl.BindVertexArray(no_vertices.id());
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.Finish();
}

void compute(const GlApi& gl, const GlTexture& places, int width, int height) {
    const ComputeSettings settings = compute_settings_in_force();
    ProgramKey key;
    key.compute = "compute/multiprocessors.comp";
    key.defines = {{"KD_GROUP_X", std::to_string(settings.x)}, {"KD_GROUP_Y", std::to_string(settings.y)}};
    const GlProgram program(gl, key, default_shader_reader());
    gl.BindImageTexture(GLuint(Output::hit), places.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
    gl.UseProgram(program.id());
    gl.DispatchCompute(GLuint((width + settings.x - 1) / settings.x), GLuint((height + settings.y - 1) / settings.y),
                       1);
    gl.MemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    gl.Finish();
}

}  // namespace

std::optional<Multiprocessors> multiprocessors_used(const GlApi& gl, GlMode mode, int width, int height) {
    if (!ballot_support(gl).multiprocessors) return std::nullopt;
    const StateGuard guard(gl);
    const GlTexture places = make_texture(gl, GL_RGBA32UI, width, height, "places");
    if (mode == GlMode::fragment)
        draw(gl, places, width, height);
    else
        compute(gl, places, width, height);
    std::set<unsigned> seen;
    Multiprocessors counted;
    for (const glm::uvec4& place : TargetReader(gl, std::size_t(width) * std::size_t(height)).words(places.id())) {
        seen.insert(place.x);
        counted.there = std::max(counted.there, int(place.y));
    }
    counted.used = int(seen.size());
    check_gl(gl, "counting multiprocessors");
    return counted;
}

}  // namespace kd

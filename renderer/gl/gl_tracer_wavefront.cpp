#include <algorithm>

#include "renderer/gl/gl_tracer_impl.h"
#include "renderer/scene/needs.h"

namespace kd {

namespace {

/// Rays that one pixel has in a step at most.
int rays_per_pixel(Step step, const FlatScene& scene) {
    const bool shading = step <= Step::shade_indirect && shades(static_cast<Pass>(step));
    return shading ? std::max(1, int(scene.lights.size())) : 1;
}

/// The largest part of a tile that leaves no more pixels than `most`.
Tile part_of(const Tile& tile, int most) {
    const int columns = std::min(tile.x1 - tile.x0, most);
    const int rows = std::min(tile.y1 - tile.y0, std::max(1, most / std::max(1, columns)));
    return {0, 0, columns, rows};
}

}  // namespace

WavefrontPrograms GlTracer::Impl::wavefront_programs(Step step, ProgramSettings settings) {
    WavefrontPrograms programs_of_step;
    programs_of_step.walks = step_walks(step, settings.needs);
    if (!programs_of_step.walks) {
        programs_of_step.answer = program(step, settings);
        return programs_of_step;
    }
    settings.phase = 1;
    programs_of_step.ask = program(step, settings);
    settings.phase = 2;
    programs_of_step.answer = program(step, settings);
    settings.phase = 0;
    settings.later_bounce = settings.count_shaded = false;
    for (const std::size_t queue : {0u, 1u}) {
        programs_of_step.plan[queue] = programs.get(plan_key(int(queue), settings)).id();
        programs_of_step.walk[queue] = program(queue == 0 ? Step::traverse : Step::intersect, settings);
    }
    return programs_of_step;
}

void GlTracer::Impl::run_wavefront(Step step, const ProgramSettings& settings, const Tile& tile) {
    const WavefrontPrograms with = wavefront_programs(step, settings);
    const auto dispatch_part = [&](GLuint program_of_phase, const Tile& part) {
        gl.UseProgram(program_of_phase);
        dispatch(part.x1 - part.x0, part.y1 - part.y0);
    };
    if (!with.walks) return dispatch_part(with.answer, tile);

    const int per_pixel = rays_per_pixel(step, scene().scene());
    const std::int64_t rays = std::int64_t(tile.x1 - tile.x0) * (tile.y1 - tile.y0) * per_pixel;
    const int slots = queues.reserve(gl, rays, words_per_ray(settings.trace, settings.needs), storage_bytes);
    const Tile part = part_of(tile, std::max(1, slots / per_pixel));
    for (int y = tile.y0; y < std::max(tile.y1, tile.y0 + 1); y += std::max(1, part.y1))
        for (int x = tile.x0; x < std::max(tile.x1, tile.x0 + 1); x += std::max(1, part.x1)) {
            const Tile now{x, y, std::min(x + part.x1, tile.x1), std::min(y + part.y1, tile.y1)};
            gl_blocks::FrameBlock block = frame_values;
            block.tile = {now.x0, now.y0, now.x1, now.y1};
            block.wave = {slots, per_pixel, 0, 0};
            frame_block.set(gl, block);
            queues.begin(gl);
            dispatch_part(with.ask, now);
            queues.run(gl, with.plan, with.walk);
            dispatch_part(with.answer, now);
        }
}

}  // namespace kd

// A driver that ends loops on its own must not yield a silent wrong answer.
#include "renderer/gl/blocks.h"
#include "renderer/gl/frame_targets.h"
#include "renderer/gl/program.h"
#include "renderer/gl/target_reader.h"
#include "renderer/gl/uniform_buffer.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

/// Runs an endless sort of loop as a traversal would, and says how far it came.
constexpr const char* looping_shader = R"(
#include "fragment/tracer.glsl"
#include "fragment/pixel_io.glsl"
void main()
{
    uint x = uint(gl_FragCoord.x);
    int n = 0;
    while (n < frame.rays.y) {
        ++n;
        x = x * 1664525u + 1013904223u;
        if (x == 7u) break;
    }
    out_hit = uvec4(uint(n), x, 0u, 0u);
    write_counters();
}
)";

class LoopLimitGl : public ContextTest {
  protected:
    struct Outcome {
        int rounds;
        uint exit_reason;
    };

    Outcome run(int rounds) {
        ProgramCache programs(gl(), [built_in = default_shader_reader()](const std::string& path) {
            return path == "loops.frag" ? std::optional<std::string>(looping_shader) : built_in(path);
        });
        const UniformBuffer<gl_blocks::SceneBlock> scene(gl());
        const UniformBuffer<gl_blocks::FrameBlock> frame(gl());
        gl_blocks::SceneBlock scene_data{};
        scene_data.limits = {60000, 4, 0, 0};
        gl_blocks::FrameBlock frame_data{};
        frame_data.rays.y = rounds;
        scene.set(gl(), scene_data);
        frame.set(gl(), frame_data);
        scene.bind(gl(), scene_block);
        frame.bind(gl(), frame_block);

        const GlTexture hit = make_texture(gl(), GL_RGBA32UI, 8, 8);
        const GlTexture a = make_texture(gl(), GL_RGBA32UI, 8, 8);
        const GlTexture b = make_texture(gl(), GL_RGBA32UI, 8, 8);
        const GlFramebuffer target = make_framebuffer(gl(), {&a, &b, &hit, nullptr, nullptr}, 0);
        const GlVertexArray none(gl());
        gl().BindVertexArray(none.id());
        gl().Viewport(0, 0, 8, 8);
        gl().UseProgram(programs.get({"fragment/quad.vert", "loops.frag", {{"KD_LOOP_LIMIT", "1"}}}).id());
        gl().DrawArrays(GL_TRIANGLE_STRIP, 0, 4);

        std::vector<Hit> hits(64);
        std::vector<RayCounters> counters(64);
        const TargetReader reader(gl(), 64);
        reader.read_hits(hit.id(), hits);
        reader.read_counters(a.id(), b.id(), counters);
        gl().UseProgram(0);
        return {hits[0].triangle, counters[0].exit_reason};
    }
};
KD_FOR_ALL_CONTEXTS(LoopLimitGl);

TEST_P(LoopLimitGl, AFullBudgetIsNoLimit) {
    const Outcome outcome = run(60000);
    EXPECT_EQ(outcome.rounds, 60000);
    EXPECT_EQ(outcome.exit_reason, uint(KD_EXIT_MISS));
}

TEST_P(LoopLimitGl, AnEndedLoopIsTold) {
    const Outcome outcome = run(100000);
    if (outcome.rounds == 100000) {
        EXPECT_EQ(outcome.exit_reason, uint(KD_EXIT_MISS));  // this driver lets loops run
    } else {
        EXPECT_LT(outcome.rounds, 100000);
        EXPECT_EQ(outcome.exit_reason, uint(KD_EXIT_STEP_CAP));
    }
}

}  // namespace
}  // namespace kd

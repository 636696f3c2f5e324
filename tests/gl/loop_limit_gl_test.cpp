// A driver that ends loops on its own must not yield a silent wrong answer.
#include "renderer/gl/frame_targets.h"
#include "renderer/gl/program.h"
#include "renderer/gl/scene_upload.h"
#include "renderer/gl/target_reader.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

/// Runs an endless sort of loop as a traversal would, and says how far it came.
constexpr const char* looping_shader = R"(
#include "fragment/tracer.glsl"
#include "fragment/hit_target.glsl"
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
    leave_counters(this_pixel());
}
)";

class LoopLimitGl : public ContextTest {
  protected:
    struct Outcome {
        int rounds;
        uint exit_reason;
    };

    static constexpr int endless = 200000;  // more than llvmpipe lets a loop run

    /// `guard` is KD_LOOP_LIMIT. The limits are those that tracing uploads.
    Outcome run(int rounds, const char* guard = "1") {
        ProgramCache programs(gl(), [built_in = default_shader_reader()](const std::string& path) {
            return path == "loops.frag" ? std::optional<std::string>(looping_shader) : built_in(path);
        });
        const FlatScene scene = test::scene_of(test::random_soup(3, 0.2f, 1));
        const KdTree tree = build_tree(scene.triangles, {});
        SceneUpload upload(gl(), GlLimits{}, scene, tree);
        upload.prepare({}, scene_needs(upload.facts(), {}));
        upload.bind();
        const UniformBuffer<gl_blocks::FrameBlock> frame(gl());
        gl_blocks::FrameBlock frame_data{};
        frame_data.rays.y = rounds;
        frame.set(gl(), frame_data);
        frame.bind(gl(), frame_block);

        const GlTexture hit = make_texture(gl(), GL_RGBA32UI, 8, 8, "hit");
        const GlTexture a = make_texture(gl(), GL_RGBA32UI, 8, 8, "a");
        const GlTexture b = make_texture(gl(), GL_RGBA32UI, 8, 8, "b");
        const GlFramebuffer target = make_framebuffer(gl(), {&a, &b, &hit, nullptr, nullptr}, 0, "loops");
        const GlVertexArray none(gl());
        gl().BindVertexArray(none.id());
        gl().Viewport(0, 0, 8, 8);
        gl().UseProgram(programs.get({"fragment/quad.vert", "loops.frag", {{"KD_LOOP_LIMIT", guard}}}).id());
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
    const Outcome outcome = run(gl_step_budget);
    EXPECT_EQ(outcome.rounds, gl_step_budget);
    EXPECT_EQ(outcome.exit_reason, uint(KD_EXIT_MISS));
}

TEST_P(LoopLimitGl, TheBudgetLeavesRoomForTheOtherLoopsOfARay) {
    // Loops over lights and the guard's own share the driver's limit with the walk.
    const int with_margin = gl_step_budget + gl_step_budget / 20;
    EXPECT_EQ(run(with_margin).rounds, with_margin);
}

TEST_P(LoopLimitGl, AnEndedLoopIsTold) {
    const Outcome outcome = run(endless);
    if (outcome.rounds == endless) {
        EXPECT_EQ(outcome.exit_reason, uint(KD_EXIT_MISS));
        EXPECT_EQ(context->renderer().find("llvmpipe"), std::string::npos) << "llvmpipe has a limit";
        GTEST_SKIP() << "this driver lets loops run: nothing to be told";
    }
    EXPECT_LT(outcome.rounds, endless);
    EXPECT_EQ(outcome.exit_reason, uint(KD_EXIT_STEP_CAP));
}

TEST_P(LoopLimitGl, OnlyTheGuardTells) {
    const Outcome outcome = run(endless, "0");
    EXPECT_EQ(outcome.exit_reason, uint(KD_EXIT_MISS)) << "what AnEndedLoopIsTold sees must come from check_loops()";
}

}  // namespace
}  // namespace kd

// A pipeline's frames are those of their times traced alone, on every tracer.
#include "renderer/measure/motion/frame_pipeline.h"

#include "renderer/measure/ray_machine.h"
#include "renderer/scene/moving_scene.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

constexpr int width = 48, height = 36, frames = 5;
constexpr double step = 0.37;

std::vector<std::unique_ptr<RayMachine>> machines() {
    std::vector<std::string> notes;
    return open_machines({.cpu = {CpuMode::scalar, CpuMode::wide, CpuMode::packet},
                          .gl = {GlMode::fragment, GlMode::compute, GlMode::wavefront},
                          .contexts = {ContextKind::osmesa},
                          .threads = 2},
                         "traced", notes);
}

Frame traced(RayMachine& machine, const FlatScene& scene, const KdTree& tree, const std::stop_token& stop = {}) {
    machine.load(scene, tree);
    return machine.frame({}, pinhole(scene.camera, width, height), width, height, stop);
}

void expect_same(const Frame& a, const Frame& b) {
    EXPECT_EQ(a.colour, b.colour);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        EXPECT_TRUE(std::ranges::equal(a.layers[pass].hit.pixels, b.layers[pass].hit.pixels, bit_equal)) << pass;
        EXPECT_TRUE(std::ranges::equal(a.layers[pass].counters.pixels, b.layers[pass].counters.pixels)) << pass;
    }
}

TEST(FramePipelineGl, FramesAreThoseOfTheirTimesTracedAlone) {
    const MovingScene scene(*make_procedural("sheet:600", 3));
    for (const auto& machine : machines()) {
        std::vector<Frame> alone;
        for (int n = 0; n < frames; ++n) {
            const FlatScene flat = scene.at(n * step);
            alone.push_back(traced(*machine, flat, build_tree(flat.triangles, {})));
        }
        EXPECT_NE(alone[0].colour, alone[1].colour) << "it moves";
        for (const FrameSchedule schedule :
             {FrameSchedule::serial, FrameSchedule::pipelined, FrameSchedule::on_demand}) {
            SCOPED_TRACE(machine->tracer() + ", " + std::string(frame_schedule_names[std::size_t(schedule)]));
            std::vector<Frame> found;
            const FrameStages stages{
                .update = [&](MotionFrame& f, const std::stop_token&) { f.scene = scene.at(f.seconds); },
                .build =
                    [&](MotionFrame& f, const std::stop_token& stop) {
                        f.tree = build_tree(f.scene.triangles, {}, nullptr, {}, stop, 1);
                    },
                .upload = [&](MotionFrame& f, const std::stop_token&) { machine->load(f.scene, f.tree); },
                .trace =
                    [&](MotionFrame& f, const std::stop_token& stop) {
                        found.push_back(
                            machine->frame({}, pinhole(f.scene.camera, width, height), width, height, stop));
                    }};
            const PipelinePlan plan{.schedule = schedule, .frames = frames, .step_seconds = step};
            ASSERT_TRUE(run_frames(plan, stages).complete);
            ASSERT_EQ(found.size(), alone.size());
            for (std::size_t n = 0; n < alone.size(); ++n) expect_same(found[n], alone[n]);
        }
    }
}

}  // namespace
}  // namespace kd

// Frames of a moving scene in a pipeline: which steps overlap, and how a run ends.
#include "renderer/measure/motion/frame_pipeline.h"

#include <atomic>
#include <condition_variable>
#include <gtest/gtest.h>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "renderer/measure/motion/pipeline_stats.h"

namespace kd {
namespace {

using enum FrameStep;

constexpr std::array all_schedules{FrameSchedule::serial, FrameSchedule::pipelined, FrameSchedule::on_demand};

void nothing(MotionFrame&, const std::stop_token&) {}

/// Numbers that go up, to be waited for.
class Latch {
  public:
    void raise(int to) {
        const std::scoped_lock lock(mutex_);
        at_ = std::max(at_, to);
        changed_.notify_all();
    }
    /// False where it has not come within a time that only a run without overlap takes.
    bool wait_for(int least) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, std::chrono::seconds(60), [&] { return at_ >= least; });
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int at_ = -1;
};

TEST(FramePipeline, ThePipelineBuildsTheNextFrameWhileOneIsTraced) {
    constexpr int frames = 6;
    Latch begun;
    const FrameStages stages{.update = nothing,
                             .build = [&](MotionFrame& f, const std::stop_token&) { begun.raise(f.number); },
                             .upload = nothing,
                             .trace =
                                 [&](MotionFrame& f, const std::stop_token&) {
                                     ASSERT_TRUE(f.number + 1 == frames || begun.wait_for(f.number + 1)) << f.number;
                                 }};
    const PipelineRun run = run_frames({.schedule = FrameSchedule::pipelined, .frames = frames}, stages);
    ASSERT_TRUE(run.complete);
    ASSERT_EQ(run.frames.size(), std::size_t(frames));
    for (std::size_t n = 0; n + 1 < run.frames.size(); ++n) {
        EXPECT_LT(run.frames[n + 1][build].begin, run.frames[n][trace].end) << n;
        // Not further ahead than one: there are two slots.
        if (n + 2 == run.frames.size()) break;
        EXPECT_GE(run.frames[n + 2][update].begin, run.frames[n][trace].end) << n;
    }
}

TEST(FramePipeline, TheOtherSchedulesTakeOneStepAfterTheOther) {
    for (const FrameSchedule schedule : {FrameSchedule::serial, FrameSchedule::on_demand}) {
        SCOPED_TRACE(frame_schedule_names[std::size_t(schedule)]);
        std::atomic<int> at_work = 0, most = 0;
        const auto step = [&](MotionFrame&, const std::stop_token&) {
            most = std::max(most.load(), ++at_work);
            std::this_thread::yield();
            --at_work;
        };
        const PipelineRun run = run_frames({.schedule = schedule, .frames = 200}, {step, step, step, step});
        ASSERT_TRUE(run.complete);
        EXPECT_EQ(most, 1);
        double last = 0;
        for (const FrameSteps& frame : run.frames)
            for (const StepInterval& interval : frame.of) {
                ASSERT_LE(last, interval.begin);
                ASSERT_LE(interval.begin, interval.end);
                last = interval.end;
            }
        EXPECT_EQ(pipeline_stats(run, 1).overlap, 0.0);
    }
}

TEST(FramePipeline, TracingStaysOnTheThreadThatCalls) {
    const std::thread::id caller = std::this_thread::get_id();
    for (const FrameSchedule schedule : all_schedules) {
        const auto here = [&](MotionFrame&, const std::stop_token&) { EXPECT_EQ(std::this_thread::get_id(), caller); };
        const auto builder = [&](MotionFrame&, const std::stop_token&) {
            EXPECT_EQ(std::this_thread::get_id() == caller, schedule == FrameSchedule::serial);
        };
        EXPECT_TRUE(run_frames({.schedule = schedule, .frames = 3}, {builder, builder, here, here}).complete);
    }
}

TEST(FramePipeline, FramesComeInOrderAtTheirTimesAndWithNothingOfTheLast) {
    for (const FrameSchedule schedule : all_schedules) {
        int told = 0;
        const auto update_scene = [](MotionFrame& f, const std::stop_token&) {
            EXPECT_TRUE(f.scene.triangles.empty());
            f.scene.triangles.resize(std::size_t(f.number) + 1);
        };
        const auto build_tree = [](MotionFrame& f, const std::stop_token&) { f.tree.references = {f.number}; };
        int expected = 0;
        const auto trace_frame = [&](MotionFrame& f, const std::stop_token&) {
            EXPECT_EQ(f.number, expected);
            EXPECT_EQ(f.seconds, 5.0 + 0.25 * expected);
            EXPECT_EQ(f.scene.triangles.size(), std::size_t(expected) + 1);
            EXPECT_EQ(f.tree.references, std::vector<std::int32_t>{expected});
            ++expected;
        };
        const PipelinePlan plan{.schedule = schedule, .frames = 40, .first_seconds = 5, .step_seconds = 0.25};
        const PipelineRun run = run_frames(plan, {update_scene, build_tree, nothing, trace_frame}, {},
                                           [&](int done) { EXPECT_EQ(done, ++told); });
        EXPECT_EQ(run.frames.size(), 40u);
        EXPECT_EQ(told, 40);
    }
}

TEST(FramePipeline, StoppingEndsItWithTheFramesThatWereFinished) {
    for (const FrameSchedule schedule : all_schedules)
        for (const FrameStep where : {update, build, upload, trace}) {
            SCOPED_TRACE(std::string(frame_schedule_names[std::size_t(schedule)]) + " in " +
                         std::string(frame_step_names[std::size_t(where)]));
            std::stop_source stop;
            const auto stage = [&](FrameStep step) -> FrameStages::Stage {
                return [&, step](MotionFrame& f, const std::stop_token& token) {
                    if (step != where || f.number != 3) return;
                    stop.request_stop();
                    EXPECT_TRUE(token.stop_requested());
                };
            };
            const PipelineRun run =
                run_frames({.schedule = schedule, .frames = 100000},
                           {stage(update), stage(build), stage(upload), stage(trace)}, stop.get_token());
            EXPECT_FALSE(run.complete);
            EXPECT_LE(run.frames.size(), 3u);
            for (const FrameSteps& frame : run.frames)
                EXPECT_EQ(frame[trace].end, frame[trace].end) << "all of it was done";
        }
    std::stop_source before;
    before.request_stop();
    for (const FrameSchedule schedule : all_schedules) {
        const auto never = [](MotionFrame&, const std::stop_token&) { FAIL(); };
        EXPECT_FALSE(
            run_frames({.schedule = schedule, .frames = 2}, {never, never, never, never}, before.get_token()).complete);
    }
}

TEST(FramePipeline, WhatEitherSideThrowsArrives) {
    for (const FrameSchedule schedule : all_schedules)
        for (const FrameStep where : {update, build, upload, trace}) {
            const auto stage = [&](FrameStep step) -> FrameStages::Stage {
                return [where, step](MotionFrame& f, const std::stop_token&) {
                    if (step == where && f.number == 2)
                        throw std::runtime_error("of step " + std::to_string(int(step)));
                };
            };
            try {
                (void)run_frames({.schedule = schedule, .frames = 100000},
                                 {stage(update), stage(build), stage(upload), stage(trace)});
                ADD_FAILURE() << "nothing thrown";
            } catch (const std::runtime_error& error) {
                EXPECT_EQ(error.what(), "of step " + std::to_string(int(where)));
            }
        }
}

TEST(PipelineStats, SharesAndTimesOfARunByHand) {
    // Frame n is built during [n, n + 0.5] but for the first, and traced during [n + 1, n + 1.75], in seconds.
    PipelineRun run;
    for (int n = 0; n < 5; ++n) {
        FrameSteps frame;
        frame[update] = {double(n), n + 0.125};
        frame[build] = {n + 0.125, n + 0.5};
        frame[upload] = {n + 1.0, n + 1.25};
        frame[trace] = {n + 1.25, n + 1.75};
        run.frames.push_back(frame);
    }
    PipelineStats stats = pipeline_stats(run, 2);
    EXPECT_EQ(stats.frame_ms, (std::vector<double>(3, 1000.0)));
    EXPECT_EQ(stats.latency_ms, (std::vector<double>(3, 1750.0)));
    EXPECT_EQ(stats.step_ms[std::size_t(build)], (std::vector<double>(3, 375.0)));
    // From 2.75 to 5.75: tracing 3 times 0.75; building from 3 and from 4 on, 0.5 each, all while one is traced.
    EXPECT_DOUBLE_EQ(stats.seconds, 3.0);
    EXPECT_DOUBLE_EQ(stats.tracer_idle, 1 - 2.25 / 3);
    EXPECT_DOUBLE_EQ(stats.builder_idle, 1 - 1.0 / 3);
    EXPECT_DOUBLE_EQ(stats.overlap, 1.0 / 3);
    stats.add(stats);
    EXPECT_EQ(stats.frame_ms.size(), 6u);
    EXPECT_DOUBLE_EQ(stats.overlap, 1.0 / 3);
    EXPECT_TRUE(pipeline_stats(run, 5).frame_ms.empty());
    // Of a run that goes on, to 4.75: frame 4 tells what was built until then.
    stats = pipeline_stats(run, 2, 1);
    EXPECT_EQ(stats.frame_ms, (std::vector<double>(2, 1000.0)));
    EXPECT_DOUBLE_EQ(stats.seconds, 2.0);
    EXPECT_DOUBLE_EQ(stats.builder_idle, 0.5);
    EXPECT_TRUE(pipeline_stats(run, 4, 1).frame_ms.empty());
}

}  // namespace
}  // namespace kd

#include "renderer/measure/motion/frame_pipeline.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "renderer/measure/timing.h"

namespace kd {

namespace {

/// How far either side is. Frame n stands in the slot n % 2, which is the building side's until the frame is ready and
/// the tracing side's from then on, until that asks for frame n + 2 or lets it be begun.
class Handover {
  public:
    explicit Handover(std::stop_token stop) : stop_(std::move(stop)) {}

    /// The building side waits until it may fill the frame's slot. False where stopped.
    bool may_begin(int frame) {
        std::unique_lock lock(mutex_);
        return changed_.wait(lock, stop_, [&] { return frame < allowed_; }) && !stop_.stop_requested();
    }
    void allow(int frames) { raise(allowed_, frames); }

    /// The tracing side waits until the frame is ready. False where stopped.
    bool take(int frame) {
        std::unique_lock lock(mutex_);
        return changed_.wait(lock, stop_, [&] { return frame < ready_; }) && !stop_.stop_requested();
    }
    void give(int frame) { raise(ready_, frame + 1); }

  private:
    void raise(int& count, int to) {
        {
            const std::scoped_lock lock(mutex_);
            count = std::max(count, to);
        }
        changed_.notify_all();
    }

    std::stop_token stop_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    int allowed_ = 0, ready_ = 0;  // frames that may be begun, and that have been built
};

class Run {
  public:
    Run(const PipelinePlan& plan, const FrameStages& stages, std::stop_token stop,
        const std::function<void(int)>& frame_done)
        : plan_(plan), stages_(stages), frame_done_(frame_done), handover_(stopped_.get_token()),
          chain_(std::move(stop), [this] { stopped_.request_stop(); }), steps_(std::size_t(plan.frames)) {}

    PipelineRun run() {
        if (plan_.schedule == FrameSchedule::serial)
            for (int frame = 0; frame < plan_.frames && build(frame) && trace(frame); ++frame) {
            }
        else
            run_both_sides();
        steps_.resize(std::size_t(done_));
        return {plan_.schedule, std::move(steps_), done_ == plan_.frames};
    }

  private:
    void run_both_sides() {
        std::exception_ptr failure;
        {
            const std::jthread builder([&] {
                try {
                    for (int frame = 0; frame < plan_.frames && handover_.may_begin(frame) && build(frame); ++frame)
                        handover_.give(frame);
                } catch (...) {
                    failure = std::current_exception();
                    stopped_.request_stop();
                }
            });
            try {
                const int ahead = plan_.schedule == FrameSchedule::pipelined ? 1 : 0;
                for (int frame = 0; frame < plan_.frames; ++frame) {
                    handover_.allow(frame + 1);
                    if (!handover_.take(frame)) break;
                    handover_.allow(frame + 1 + ahead);
                    if (!trace(frame)) break;
                }
            } catch (...) {
                stopped_.request_stop();  // the builder waits for nothing any more
                throw;
            }
        }
        if (failure) std::rethrow_exception(failure);
    }

    bool build(int number) {
        MotionFrame& frame = slot(number);
        // The old state goes before the new one comes, so that there are never three.
        frame = {number, plan_.first_seconds + number * plan_.step_seconds, {}, {}};
        return take_step(FrameStep::update, stages_.update, frame) && take_step(FrameStep::build, stages_.build, frame);
    }

    bool trace(int number) {
        MotionFrame& frame = slot(number);
        if (!take_step(FrameStep::upload, stages_.upload, frame) || !take_step(FrameStep::trace, stages_.trace, frame))
            return false;
        done_ = number + 1;
        if (frame_done_) frame_done_(done_);
        return true;
    }

    /// False where it was stopped.
    bool take_step(FrameStep step, const FrameStages::Stage& stage, MotionFrame& frame) {
        if (stopped_.stop_requested()) return false;
        StepInterval& interval = steps_[std::size_t(frame.number)][step];
        interval.begin = steady_seconds() - begun_;
        stage(frame, stopped_.get_token());
        interval.end = steady_seconds() - begun_;
        return !stopped_.stop_requested();
    }

    MotionFrame& slot(int number) { return slots_[std::size_t(number % 2)]; }

    const PipelinePlan& plan_;
    const FrameStages& stages_;
    const std::function<void(int)>& frame_done_;
    std::stop_source stopped_;  // from outside, or because either side failed
    Handover handover_;
    std::stop_callback<std::function<void()>> chain_;
    std::array<MotionFrame, 2> slots_;
    std::vector<FrameSteps> steps_;  // by frame; either side writes its own
    int done_ = 0;
    double begun_ = steady_seconds();
};

}  // namespace

PipelineRun run_frames(const PipelinePlan& plan, const FrameStages& stages, std::stop_token stop,
                       const std::function<void(int)>& frame_done) {
    return Run(plan, stages, std::move(stop), frame_done).run();
}

}  // namespace kd

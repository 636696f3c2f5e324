// Frames of a moving scene, one after another: the dual compute model that the paper proposes, in which one processor
// builds the tree of the next frame while another traces this one, and what it is held against.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <stop_token>
#include <string_view>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"

namespace kd {

enum class FrameSchedule {
    serial,     // one thread takes each step after the other
    pipelined,  // a second thread updates and builds frame n + 1 while frame n is traced
    on_demand,  // the second thread begins when the tracer asks for a frame: no overlap, no state older than needed
};
inline constexpr std::array<std::string_view, 3> frame_schedule_names{"serial", "pipelined", "on-demand"};

/// In the order in which a frame goes through them. The first two are the building side's, the others the tracing
/// side's.
enum class FrameStep { update, build, upload, trace };
inline constexpr std::array<std::string_view, 4> frame_step_names{"update", "build", "upload", "trace"};

/// Seconds since the run began.
struct StepInterval {
    double begin = std::numeric_limits<double>::quiet_NaN(), end = std::numeric_limits<double>::quiet_NaN();

    [[nodiscard]] double seconds() const { return end - begin; }
    bool operator==(const StepInterval&) const = default;
};

/// When a frame was in which step.
struct FrameSteps {
    std::array<StepInterval, frame_step_names.size()> of{};

    [[nodiscard]] const StepInterval& operator[](FrameStep step) const { return of[std::size_t(step)]; }
    [[nodiscard]] StepInterval& operator[](FrameStep step) { return of[std::size_t(step)]; }
};

/// One state of the scene with its tree.
struct MotionFrame {
    int number = 0;      // from 0
    double seconds = 0;  // of the motion
    FlatScene scene;
    KdTree tree;
};

/// What is done in each step. A step that is asked to stop may leave its frame unfinished, which then goes no further.
/// What a step throws ends the run.
struct FrameStages {
    using Stage = std::function<void(MotionFrame&, const std::stop_token&)>;

    Stage update;  // fills `scene` for `seconds`
    Stage build;   // fills `tree`
    Stage upload;  // hands both to the tracer, which may read them until the next one begins
    Stage trace;   // to the finished picture
};

struct PipelinePlan {
    FrameSchedule schedule = FrameSchedule::pipelined;
    int frames = 1;
    double first_seconds = 0, step_seconds = 1.0 / 30;  // frame n is of the time first + n * step
};

/// A whole run.
struct PipelineRun {
    FrameSchedule schedule = FrameSchedule::pipelined;
    std::vector<FrameSteps> frames;  // those that were finished
    bool complete = true;            // false where stopped
};

/// Upload and trace run on the thread that calls, where a context of OpenGL may be current; so do update and build of a
/// serial run, else they have a thread of their own. Two frames are held, in turn, so that memory does not depend on
/// how many there are. `frame_done` gets the number of frames finished, on the calling thread.
[[nodiscard]] PipelineRun run_frames(const PipelinePlan& plan, const FrameStages& stages, std::stop_token stop = {},
                                     const std::function<void(int)>& frame_done = {});

}  // namespace kd

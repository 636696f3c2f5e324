// A session carried out: scene, tree, frame, and the figure that shows them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/frame/frame_tracer.h"
#include "app/frame/sampled_frame.h"
#include "app/report/figure_text.h"
#include "renderer/kdtree/stats.h"
#include "renderer/measure/measured_on.h"
#include "renderer/scene/needs.h"
#include "renderer/trace/lockstep_layer.h"
#include "renderer/trace/node_visits.h"
#include "viz/text.h"

namespace kd {

struct Rendering {
    Session session;  // its camera is set
    FlatScene scene;
    KdTree tree;
    BuildReport build;
    TreeStats stats;
    SceneFacts facts;
    Frame frame;
    std::optional<JudgedLayer> judged;   // where the map shown asks for it
    std::optional<LockstepLayer> walks;  // likewise
    std::optional<NodeVisits> visits;    // where the colours of cells ask for them
    FrameTime time;
    std::optional<SampleCount> samples;  // where light is sampled
    std::string renderer, clock;
    bool software_gl = false;
    MeasuredOn on;
    std::vector<std::string> left_out;  // of what the tracer could do, what scene and settings do not need
};

/// Of a command: what only gl-fragment asks.
[[nodiscard]] GlChoices gl_choices(const CommonOptions& options, const Session& session);

/// Loads, builds, traces, and makes what the map asks for beside the frame, with progress on the context's terminal.
/// InputError, ContextError, Interrupted.
[[nodiscard]] Rendering render(const CommonOptions& options, Session session, CommandContext& context);

[[nodiscard]] inline BesideFrame beside(const Rendering& r) {
    return {r.judged ? &*r.judged : nullptr, r.walks ? &*r.walks : nullptr, r.visits ? &*r.visits : nullptr};
}

/// What its figures' captions tell.
[[nodiscard]] FigureFacts facts_of(const Rendering& rendering);

/// Writes what `view` shows: the bare picture, or with `legend` the figure with title, legend and caption. The settings
/// stand in the file's text. InputError.
void write_picture(const std::string& path, const Rendering& rendering, const ViewConfig& view, bool legend,
                   const Font& font);

}  // namespace kd

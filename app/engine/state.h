// What the engine knows at this moment. Panels read it; nothing in it changes while they do.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/engine/cell_costs.h"
#include "app/engine/convergence.h"
#include "app/engine/duel.h"
#include "app/engine/motion_state.h"
#include "app/engine/paper.h"
#include "app/engine/pixel.h"
#include "app/engine/plane_effect.h"
#include "app/engine/selection.h"
#include "app/engine/stability.h"
#include "app/engine/tree_view.h"
#include "app/engine/visits.h"
#include "app/engine/widths.h"
#include "app/engine/world.h"
#include "app/frame/frame_time.h"
#include "app/frame/sample_count.h"
#include "app/session.h"
#include "renderer/measure/needs_costs.h"
#include "renderer/measure/walk_recorder.h"
#include "renderer/scene/needs.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/judged_layer.h"
#include "viz/figure.h"
#include "viz/unfinished.h"

namespace kd {

/// A frame as it was traced: all that painting and reading it need.
struct TracedFrame {
    std::shared_ptr<const World> world;
    std::shared_ptr<const Frame> frame;
    std::shared_ptr<const JudgedLayer> judged;  // of some or all pixels, where a map asked for it; else null
    Camera camera;
    PinholeCamera lens;  // that its rays come from: a preview's is that of the whole picture, whatever its own shape
    TraceConfig config;
    TracerKind tracer = TracerKind::cpu;
    int scale = 1;                                    // 1 = every pixel of the picture, 8 = one of 8x8: a preview
    FrameTime time;                                   // of tracing alone
    std::string clock;                                // that the time was read from
    SceneNeeds needs;                                 // which passes and parts ran
    std::vector<std::string> left_out;                // a line for each part that this tracer did without
    std::uint64_t generation = 0;                     // EngineState::generation that it answers
    UnfinishedPixels unfinished;                      // of the frame's own pixels
    std::array<CounterTotals, pass_count> totals;     // of all pixels where `scale` is 1, else zeros
    std::shared_ptr<const LockstepLayer> walks = {};  // of all pixels, where a map asked for it; else null
    /// Of the nodes of `world` by the rays of this frame, or of one before it; null where none were counted.
    std::shared_ptr<const NodeVisits> visits = {};
    std::optional<SampleCount> samples = {};  // where light is sampled
    StepInterval upload = {}, trace = {};  // by the steady clock; the second to the frame's end, from the coarsest on
};

/// What walks the rays of a frame once more.
[[nodiscard]] inline WalkRequest walk_request(const TracedFrame& traced, Pass rays, int threads) {
    return {.scene = traced.world->scene(),
            .tree = traced.world->tree,
            .config = traced.config,
            .camera = traced.lens,
            .width = traced.frame->width,
            .height = traced.frame->height,
            .rays = rays,
            .threads = threads};
}

/// Whether `traced` holds what the map of `view` is made from beside the frame: of all pixels, or of those of a sketch
/// at least.
[[nodiscard]] inline bool is_complete_for(const TracedFrame& traced, const ViewConfig& view, bool all) {
    if (needs_walks(view)) return traced.walks && fits(*traced.walks, view.map);
    if (!needs_oracle(view)) return true;
    return traced.judged && traced.judged->rays == view.map.rays && (!all || traced.judged->step == 1);
}

/// What the colours of a map mean.
struct MapMeaning {
    ScalarMap labels;  // with the values of the frame that was painted
    MapSummary summary;
    std::vector<std::int64_t> category_pixels;  // of each of labels.categories
};

/// The same of cells, on their own scale.
struct CellMeaning {
    MapMeaning meaning;
    HeatmapConfig heat;
};

/// A finished picture in 8 bits, and what is in it.
struct Picture {
    Image<Rgba8> image;
    ViewConfig view;
    std::optional<MapMeaning> map;
    std::optional<CellMeaning> cells;  // what colours of cells mean, where that is not their depth
    TracedFrame traced;
    bool sketch = false;           // painted from some of the frame's pixels, because all of them take long
    std::uint64_t generation = 0;  // EngineState::generation that it answers
};

/// Work that goes on in the background.
struct Progress {
    bool active = false;
    float fraction = 0;  // 0..1
};

/// A remark for people: an error, or what was changed by the program itself.
struct Message {
    bool error = false;
    std::string text;
    double time = 0;     // Engine::now() when it came
    bool stays = false;  // until it is dismissed
};

/// A scene that was asked for and could not be had.
struct RefusedScene {
    std::string name, why;
};

/// The GPU side as it was found.
struct GlStatus {
    bool known = false;    // opened, or found to be missing
    std::string renderer;  // GL_RENDERER; empty where missing
    std::string version;
    bool software = false;
    std::string unavailable;  // why there is none, one line
    bool fails = false;       // there is one, but it cannot be relied on: its self-test, its shaders, its resets
    int losses = 0;           // contexts that were lost
    [[nodiscard]] bool available() const { return known && unavailable.empty(); }
};

/// What features save that are left out, measured when asked for.
struct NeedsTiming {
    bool active = false;
    float fraction = 0;  // 0..1
    std::vector<FeatureTime> times;
    std::shared_ptr<const World> world;  // of the frames timed
    Session of;
    std::string error;  // why nothing was measured
};

struct EngineState {
    Session session;                         // what was asked for, corrected where it could not be had
    std::uint64_t generation = 0;            // grows with every change of the session that changes the picture
    std::shared_ptr<const World> world;      // scene and tree in use; null until the first is ready
    Camera camera;                           // in use: the session's, or the scene's own
    std::shared_ptr<const Picture> picture;  // shown; null until the first is ready
    Progress loading, building, tracing;
    Progress judging;  // making what a map needs beside the frame: its hits judged, its walks in groups
    std::string loading_name;
    std::optional<RefusedScene> refused;  // the newest wish for a scene, where nothing came of it
    GlStatus gl;
    DuelState duel;
    NeedsTiming needs;
    MotionState motion;
    int compiling = 0;  // programs that the GPU is being given now
    int compiled = 0;   // since the start
    StabilityState stability;
    WidthState widths;
    VisitState visits;
    PaperState paper;
    ConvergenceState convergence;
    std::optional<PixelReading> hovered, pinned;
    /// Cells that the ray of the pinned or hovered pixel meets, while splits are shown; Session::width x height.
    std::vector<ScreenLine> ray_cells;
    std::optional<StepReading> step;        // along the pinned pixel's ray
    std::optional<NodeSelection> selected;  // of `world`
    std::optional<HitSelection> hit;        // of the pinned pixel's primary ray; nothing where it hit none
    CellState cell;                         // costs of the planes of a node selected
    PlaneEffect plane_effect;
    TreeViewState tree_view;
    std::vector<Message> messages;  // newest last
    double last_build_ms = 0;

    /// The picture is not yet (all of) what the session asks for.
    [[nodiscard]] bool stale() const {
        return !picture || picture->generation != generation || picture->traced.scale != 1 || picture->sketch;
    }
    [[nodiscard]] bool working() const {
        return loading.active || building.active || tracing.active || judging.active || motion.posing;
    }
    /// Seconds of its motion at which the scene in use is shown, and until it begins again: 0 where nothing moves.
    [[nodiscard]] double time_shown() const { return world ? world->scene().time : 0; }
    [[nodiscard]] double duration() const { return world ? world->scene().duration : 0; }
    /// What features save was measured of another picture, scene or machine.
    [[nodiscard]] bool needs_outdated() const {
        Session now = session;
        now.trace.forced = needs.of.trace.forced;  // each was timed alone, whatever else was put back
        now.view = needs.of.view;
        return needs.world != world || now != needs.of;
    }
    /// What the oracle says of every pixel of the picture shown; null where it does not, or not yet.
    [[nodiscard]] const JudgedLayer* judged() const {
        const JudgedLayer* found = picture ? picture->traced.judged.get() : nullptr;
        return found != nullptr && found->step == 1 && picture->traced.scale == 1 ? found : nullptr;
    }
};

}  // namespace kd

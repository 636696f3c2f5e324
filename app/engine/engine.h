// The work behind the window: loads, builds, traces and paints in the background, one way, newest wishes first.
//
//   set_session() -> what changed -> scene -> tree -> frame -> picture
//
// Maps that compare with the oracle, or look at walks in groups, have a stage more, between frame and picture.
//
// Each arrow is a background thread; a change redoes the work from where it enters, and until its result is there the
// previous one stays. All member functions are called on one thread, the owner's.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "app/engine/duel_book.h"
#include "app/engine/judging.h"
#include "app/engine/mailbox.h"
#include "app/engine/paint.h"
#include "app/engine/posing.h"
#include "app/engine/state.h"
#include "app/engine/tracing.h"
#include "app/engine/worker.h"

namespace kd {

/// Of a session from a file, until its scene is there.
struct OpenedSession {
    std::optional<Camera> camera;    // in scene units, which only the scene tells
    std::vector<HandSplit> by_hand;  // the same
    Session before;                  // to go back to
    std::string file;
};

struct EngineOptions {
    OpenGl open_gl;              // called on the tracing thread; empty: no GPU
    std::function<void()> wake;  // called on any thread when poll() has something to fetch
    bool duel = true;            // time CPU and GPU while idle
    bool widths = false;         // measure efficiency against width while idle
    bool visits = false;         // count visits of nodes while idle, though no cell is coloured by them
};

class Engine {
  public:
    Engine(const Session& start, EngineOptions options);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Takes over what can be had of `next`: a camera that no picture can be made with, or an empty picture, is left as
    /// it was. What turns out to be impossible later (a missing file, say) comes back in state().session and a message.
    void set_session(const Session& next);
    /// Takes over the session of a file, but for the picture's size. Where it cannot be read, or later its scene cannot
    /// be had, everything stays or becomes as it was, with a message.
    void open_session(const std::string& file);
    /// Pixels to read out; `pinned` also chooses the ray whose cells are shown, before `hovered`. `step`, from 0: the
    /// leaf to read of those that the pinned pixel's primary ray visits; the last one where there are not so many.
    void set_probes(std::optional<PixelPosition> hovered, std::optional<PixelPosition> pinned,
                    std::optional<int> step = std::nullopt);
    /// The node that is selected, by its path. `costs`: those of the planes in its cell are reckoned.
    void select_node(const std::optional<std::string>& path, bool costs);
    /// A triangle that is selected by its number; the pinned pixel's hit where none is. None the scene does not have.
    void select_triangle(std::optional<int> triangle);
    /// How the tree is shown beside the picture; columns 0: not at all.
    void show_tree(const TreeViewWish& wish) { tree_wish_ = wish; }
    /// Ends a build that runs; the tree before it stays, or the unfinished one where there is none before.
    void cancel_build();
    /// Runs a case of the stability suite in the background, by all traversals or the session's, under the session's
    /// rules; what ran before is dropped.
    void run_case(const std::string& id, bool all_traversals);
    /// The same with its sweep, by the session's traversal.
    void run_sweep(const std::string& id);
    /// Times what is left out, each feature alone; any change of the picture ends it.
    void measure_needs();
    void cancel_needs();
    void cancel_stability() { stability_.cancel(); }
    /// Makes the paper's experiments in the background; while they run nothing else is timed.
    void run_paper(bool quick);
    void cancel_paper() { paper_.cancel(); }
    /// Samples the resting picture on and on, in place of timing it, until stopped or ConvergenceState::most_samples.
    void sample_picture(Sampler sampler);
    void stop_sampling() { convergence_.stop(); }
    /// Plays the scene's motion, or not, and how poses get their trees. Session::time goes along: a pose is asked for
    /// by the wall clock and shown before the next one is, so that none is left out and none waits. Nothing where the
    /// scene does not move.
    void play(const MotionWish& wish);
    /// A person did something: no duel for a while.
    void note_input();
    /// `scale` of the frames that are timed: 1 = every pixel, 2 = half of the picture along each side; 0 = the
    /// program's choice.
    void allow_duel(bool allowed, int scale = 0);
    /// Measures efficiency against width of the rays shown, whenever the picture stays.
    void keep_widths(bool wanted);
    /// Counts how often the rays shown visit each node, whenever the picture stays.
    void keep_visits(bool wanted);
    void dismiss_messages() { state_.messages.clear(); }
    void say(bool error, std::string text);

    /// Fetches results and starts what follows from them. Call it often; true where the state changed.
    bool poll();
    /// Polls until the picture answers the session, at least as a preview, or `seconds` have passed.
    void wait_for_picture(double seconds);
    [[nodiscard]] const EngineState& state() const { return state_; }

    /// Seconds since the engine was made.
    [[nodiscard]] double now() const;

  private:
    void start_load();
    void finish_load(std::shared_ptr<const LoadedScene> loaded);
    void fail_load(const std::string& reason);
    void forget_refused();
    [[nodiscard]] std::optional<Camera> usable_camera(const FlatScene& scene, const std::optional<Camera>& asked);
    void take_opened_lengths(const FlatScene& scene);
    void start_build();
    void finish_build(std::shared_ptr<const World> world);
    void finish_meantime(std::shared_ptr<const World> world);
    void use(std::shared_ptr<const World> world);
    void begin_playing();
    void end_playing();
    void follow_motion();
    void start_pose();
    void finish_pose(const Posed& posed);
    void take_pose();
    void drop_pose();
    [[nodiscard]] bool moves() const;
    [[nodiscard]] bool drags() const;
    [[nodiscard]] bool shows_pose() const;
    [[nodiscard]] double time_to_pose();
    void note_played(const TracedFrame& traced);
    void start_trace();
    void note_gl(const GlStatus& gl);
    void receive(TracedFrame traced);
    void start_judging();
    void receive_judged(const TracedFrame& judged);
    void start_paint();
    void paint_now(const TracedFrame& traced);
    void paint_and_show(std::uint64_t ticket, const ViewConfig& view, const std::function<Picture()>& work);
    void show(std::shared_ptr<const Picture> picture, std::uint64_t ticket);
    void fail_paint(const std::string& why, const ViewConfig& view);
    void start_duel();
    void receive(const DuelReply& reply);
    void stop_duel();
    void start_widths();
    void start_visits();
    [[nodiscard]] bool rests() const;
    void start_sample();
    void receive(const SampleReply& reply);
    void note_frame(const TracedFrame& traced);
    void note_rounds();
    void note_planes(const TracedFrame& traced);
    [[nodiscard]] Session configuration_shown() const;
    void read_probes();
    void read_step(const PixelReading& probe);
    void read_hit();
    void read_hit_ray(const PixelReading& probe, HitSelection& hit);
    void read_selection();
    void walk_pinned(const PixelReading& probe);
    [[nodiscard]] PictureView picture_view() const;
    void start_cell();
    [[nodiscard]] TraceRequest trace_request() const;
    [[nodiscard]] Camera camera_in_use() const;

    EngineOptions options_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    EngineState state_;
    std::shared_ptr<const LoadedScene> scene_;           // newest loaded; its tree may not be ready yet
    std::optional<Camera> camera_before_load_;           // of the scene that a refused one gives way to
    std::vector<HandSplit> planes_before_load_;          // of the same
    std::shared_ptr<const LoadedScene> building_scene_;  // of the build that runs
    std::uint64_t building_generation_ = 0;              // that it answers
    std::uint64_t meantime_generation_ = 0;  // that a tree answers which is shown until the newest is built; else 0
    bool build_waits_ = false;               // for that one, whose result is soon there
    std::optional<OpenedSession> opened_;    // whose scene is being loaded
    TracedFrame traced_;                     // newest frame
    std::optional<PixelPosition> hovered_, pinned_;
    std::optional<int> step_;
    std::optional<int> selected_triangle_;
    std::optional<std::string> selected_path_;
    std::weak_ptr<const World> selected_in_;  // the tree that state().selected is of
    bool wants_costs_ = false;
    TreeViewWish tree_wish_;
    MotionWish motion_wish_;
    double last_view_ = -1e9;                   // when camera, traversal or machine changed last
    double sampled_time_ = 0, sampled_at_ = 0;  // of the motion and of now(), when a pose was asked for last
    std::shared_ptr<const World> next_pose_;    // ready, until the one before it is shown
    std::uint64_t pose_generation_ = 0;         // that it answers, or the one that is being made
    Session recorded_;                          // what state().motion is of
    std::vector<int> walked_leaves_;            // by the ray of this pixel of this frame
    int walked_hit_leaf_ = -1;                  // in which it ended
    std::shared_ptr<const Frame> walked_frame_;
    PixelPosition walked_pixel_;
    bool walked_in_steps_ = false;        // by the frame's own traversal, not by a stack
    std::uint64_t trace_generation_ = 0;  // the last one that asked for another frame
    std::atomic<double> paint_ms_ = 0;    // of the last whole picture; written by the painting thread
    bool samples_wait_ = false;           // traced_ is painted when the picture before it is
    std::uint64_t paint_ticket_ = 0;      // of the painting asked for last
    std::uint64_t shown_ticket_ = 0;      // of the picture shown
    std::uint64_t trace_ticket_ = 0;      // of the trace started last
    std::uint64_t judge_ticket_ = 0;      // of the comparison started last
    std::shared_ptr<const Frame> judging_frame_;
    MapConfig judging_map_;  // that needs something beside it
    std::atomic<float> build_fraction_ = 0, trace_fraction_ = 0, judge_fraction_ = 0,
                       needs_fraction_ = 0;  // written by the threads at work
    TraceRequest duel_failed_;               // its world and configuration cannot be timed
    double last_input_ = 0, duel_ended_ = 0, duel_took_ = 0;
    int duel_scale_ = 0;  // see allow_duel()
    bool duelling_ = false;

    Mailbox mailbox_;
    DuelBook duels_{state_.duel};
    StabilityBench stability_{mailbox_, state_.stability};
    FrameBench widths_{mailbox_, state_.widths};
    FrameBench visits_{mailbox_, state_.visits};
    PaperBench paper_{mailbox_, state_.paper};
    CellBench cell_{mailbox_, state_.cell};
    TreeViewBench tree_view_{mailbox_, state_.tree_view};
    PlaneBook planes_{state_.plane_effect};
    Convergence convergence_{state_.convergence};
    Posing posing_{mailbox_};
    std::unique_ptr<Tracing> tracing_;                                // lives and dies on tracer_'s thread
    Judging judging_;                                                 // judger_'s alone
    Worker loader_, builder_, painter_, sketcher_, tracer_, judger_;  // last: joined before what their jobs use goes
};

}  // namespace kd

#include "app/paper/paper_run.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>

#include "app/choices.h"
#include "app/cli/command.h"
#include "app/frame/counted_frame.h"
#include "app/frame/frame_tracer.h"
#include "app/paper/paper_counts.h"
#include "app/paper/paper_node_sizes.h"
#include "app/report/machine_info.h"
#include "renderer/geometry/input_error.h"
#include "renderer/measure/paper/paper_claims.h"
#include "renderer/measure/paper/walk_costs.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

namespace {

constexpr std::array<int, 5> loop_budgets{64, 128, 255, 512, 1024};
constexpr std::array<const char*, 6> limited_scenes{"ball:1000", "ball:2000",    "ball:4000",
                                                    "ball:9000", "scatter:2000", "scatter:10000"};
constexpr std::array<const char*, 3> pictured_scenes{"ball:2000", "ball:9000", "scatter:10000"};
constexpr std::array<const char*, 2> node_size_scenes{"ball:9000", "scatter:10000"};

/// What the rows name themselves.
constexpr std::initializer_list<const char*> varied{"scene", "tracer", "traversal"};

/// Tracers of one scene, and the method each of its contestants stands for.
struct Stage {
    std::unique_ptr<PaperWorld> world;  // before the tracers that read it
    std::unique_ptr<FrameTracer> cpu, gpu;
};

class PaperRun {
  public:
    PaperRun(const PaperConfig& config, const PaperProgress& progress, const std::stop_token& stop)
        : config_(config), progress_(progress), stop_(stop) {
        results_.width = config.base.width;
        results_.height = config.base.height;
        results_.quick = config.quick;
        results_.rules = config.base.trace.rules;
        results_.on = measured_on(config.base, varied);
    }

    PaperResults run() {
        count_scenes();
        compare_seeds();
        limit_loops();
        compare_nodes();
        compare_triangle_tests();
        time_all();
        results_.complete = !stop_.stop_requested();
        return std::move(results_);
    }

  private:
    [[nodiscard]] bool stopped() const { return stop_.stop_requested(); }
    void tell(float fraction, const std::string& what) {
        if (progress_) progress_(fraction, what, results_);
    }

    void count_scenes() {
        for (const PaperSceneInfo& info : paper_scenes()) {
            if (stopped()) return;
            const std::string name(info.name);
            tell(0.04f * float(results_.scenes.size()) / float(paper_scenes().size()), "counting in " + name);
            Stage stage;
            stage.world = open_world(config_, name, config_.base.seed, stop_);
            if (!stage.world) return;
            results_.scenes.push_back(count_scene(config_, name, *stage.world, stop_));
            stages_[name] = std::move(stage);
        }
    }

    /// Other scenes of the same make tell how far a ratio is the scene's own: seeds after that of the scene.
    void compare_seeds() {
        const unsigned seeds = config_.quick ? 6 : 8;
        for (PaperScene& scene : results_.scenes) {
            if (scene.name != "scatter:10000" && scene.name != "sheet:10000") continue;
            for (unsigned i = 1; i <= seeds && !stopped(); ++i) {
                const unsigned seed = config_.base.seed + i;
                tell(0.05f + 0.04f * float(i) / float(seeds), fmt::format("nodes of {}, seed {}", scene.name, seed));
                scene.seed_node_ratios.push_back(seed_node_ratio(config_, scene.name, seed, stop_));
            }
        }
        if (stopped())
            for (PaperScene& scene : results_.scenes) scene.seed_node_ratios.clear();
    }

    void limit_loops() {
        for (const char* name : limited_scenes) {
            if (stopped()) return;
            tell(0.1f, fmt::format("loops with a ceiling in {}", name));
            const auto known = stages_.find(name);
            const std::unique_ptr<PaperWorld> own =
                known == stages_.end() ? open_world(config_, name, config_.base.seed, stop_) : nullptr;
            const PaperWorld* world = known == stages_.end() ? own.get() : known->second.world.get();
            if (!world) return;
            for (const int budget : loop_budgets) {
                PaperPicture picture;
                const bool pictured =
                    std::ranges::find(pictured_scenes, std::string_view(name)) != pictured_scenes.end() &&
                    (budget == 255 || budget == 128 || budget == 1024);
                const PaperBudget row =
                    limited_loop(config_, name, *world, budget, pictured ? &picture : nullptr, stop_);
                if (stopped()) return;
                results_.budgets.push_back(row);
                if (pictured) results_.pictures.push_back(std::move(picture));
            }
        }
    }

    void compare_nodes() {
        for (const char* name : node_size_scenes) {
            const auto stage = stages_.find(name);
            if (stopped() || stage == stages_.end()) return;
            const auto compare = [&](TracerKind tracer) {
                tell(0.12f, fmt::format("nodes of 16 and 8 bytes in {} on {}", name, name_of(tracer)));
                PaperNodeSizes sizes = compare_node_sizes(config_, name, *stage->second.world, tracer, stop_);
                if (!stopped()) results_.node_sizes.push_back(std::move(sizes));
            };
            compare(TracerKind::cpu);
            use_gpu([&] { compare(TracerKind::gl_fragment); });
        }
    }

    void compare_triangle_tests() {
        for (const PaperScene& scene : results_.scenes) {
            if (stopped()) return;
            tell(0.13f, fmt::format("triangle tests and traversal in {}", scene.name));
            const PaperWorld& w = *stages_.at(scene.name).world;
            PaperTriangleTests tests = compare_tests(w.scene, w.tree, w.camera, results_.width, results_.height,
                                                     config_.quick ? 9 : 15, stop_);
            tests.scene = scene.name;
            if (!stopped()) results_.triangle_tests.push_back(std::move(tests));
        }
    }

    /// Does what needs OpenGL where there is some; else there is a note.
    template <class Work>
    void use_gpu(const Work& work) {
        if (!config_.gpu || stopped()) return;
        try {
            work();
        } catch (const ContextError& error) {
            if (config_.context != ContextKind::automatic) throw;
            note_once(fmt::format("GPURT left out: {}", error.what()));
        } catch (const InputError& error) {
            note_once(fmt::format("GPURT left out: {}", error.what()));
        }
    }

    void open_gpu(Stage& stage) {
        use_gpu([&] {
            const GlChoices choices{.context = config_.context, .early_z = config_.base.early_z};
            stage.gpu = make_frame_tracer(TracerKind::gl_fragment, stage.world->scene, stage.world->tree, 0, choices);
        });
    }

    /// Of a frame: what is affordable in turn with the others.
    [[nodiscard]] double naive_limit_ms() const { return std::max(200.0, 10 * config_.budget_s); }

    void note_once(const std::string& note) {
        if (std::ranges::find(results_.notes, note) == results_.notes.end()) results_.notes.push_back(note);
    }

    /// Whether a frame by every triangle is affordable, from an eighth of it along each side.
    bool affordable(Stage& stage, TraceConfig config) {
        const int width = std::max(1, results_.width / 8), height = std::max(1, results_.height / 8);
        const PinholeCamera camera = pinhole(stage.world->scene.camera, width, height);
        const double small = stage.cpu->trace(config, camera, width, height, stop_).total_ms;
        return 64 * small <= naive_limit_ms();
    }

    void add_contestants(PaperScene& scene, Stage& stage) {
        stage.cpu = make_frame_tracer(TracerKind::cpu, stage.world->scene, stage.world->tree, config_.base.threads, {});
        open_gpu(stage);
        for (const PaperMethodInfo& method : paper_methods()) {
            if (stopped()) return;
            FrameTracer* tracer = method.gpu ? stage.gpu.get() : stage.cpu.get();
            if (!tracer) continue;
            TraceConfig trace = config_.base.trace;
            trace.traversal = method.traversal;
            trace.counters = false;
            if (method.id == PaperMethod::naive && !affordable(stage, trace)) {
                note_once(fmt::format("CPU naive is left out where a frame of it would take longer than {:.0f} ms",
                                      naive_limit_ms()));
                continue;
            }
            prepare(scene, stage, method, *tracer, trace);
        }
    }

    void prepare(PaperScene& scene, Stage& stage, const PaperMethodInfo& method, FrameTracer& tracer,
                 const TraceConfig& trace) {
        const std::string name = fmt::format("{} on {}", method.name, scene.name);
        const PinholeCamera& camera = stage.world->camera;
        if (const auto frame = trace_counted(tracer, trace, camera, results_.width, results_.height, stop_))
            note_unfinished(*frame, name, results_.notes);
        tracer.prepare(trace, results_.width, results_.height);
        // The first draw ends what the compiler began.
        tracer.trace(trace, camera, results_.width, results_.height, stop_);
        PaperTimes times;
        times.method = method.id;
        times.clock = tracer.clock();
        times.upload_ms = tracer.setup().upload_ms;
        times.compile_ms = tracer.setup().compile_ms;
        scene.times.push_back(times);
        contestants_.push_back({name, [this, &camera, &tracer, trace] {
                                    if (stopped()) throw Interrupted();
                                    const FrameTime time =
                                        tracer.trace(trace, camera, results_.width, results_.height, stop_);
                                    if (!time.complete) throw Interrupted();
                                    return time.sample();
                                }});
    }

    /// Hands the rounds to the scenes in the order in which the contestants were made.
    void take_over(std::span<const TimedRounds> timed) {
        std::size_t i = 0;
        for (PaperScene& scene : results_.scenes)
            for (PaperTimes& times : scene.times) times.timed = timed[i++];
        results_.rounds = timed.empty() ? 0 : int(timed.front().rounds.size());
    }

    void time_all() {
        for (PaperScene& scene : results_.scenes) {
            if (stopped()) return;
            tell(0.15f, "preparing tracers of " + scene.name);
            add_contestants(scene, stages_.at(scene.name));
        }
        for (const auto& [name, stage] : stages_)
            if (stage.gpu) results_.on = measured_on(config_.base, varied, stage.gpu.get());
        tell(0.2f, "warming up");
        const TimingPlan plan = timing_plan();
        const auto show = [this, &plan, from_s = spent_s()](int rounds, std::span<const TimedRounds> so_far) {
            take_over(so_far);
            tell_round(plan, from_s, rounds);
        };
        try {
            (void)time_in_turn(contestants_, plan, show);
        } catch (const Interrupted&) {
            // What the rounds before gave is kept.
        }
    }

    [[nodiscard]] double spent_s() const { return steady_seconds() - begin_s_; }

    /// Its clock is that of the whole run: what was counted and prepared before the rounds took time, too.
    [[nodiscard]] TimingPlan timing_plan() {
        return {.warmup = config_.warmup,
                .rounds = config_.most_rounds,
                .budget_s = config_.budget_s,
                .least_rounds = MedianInterval::least_samples,
                .is_open = [this] { return is_open(); },
                .ends_at_s = config_.longest_s.value_or(spent_s() + config_.budget_s),
                .clock = [this] { return spent_s(); }};
    }

    bool is_open() {
        const bool open = wants_rounds(results_);
        if (open && !open_since_s_) open_since_s_ = spent_s();
        return open;
    }

    void tell_round(const TimingPlan& plan, double from_s, int rounds) {
        const auto part = [this](double from, double to) {
            return to > from ? std::min(1.0, (spent_s() - from) / (to - from)) : 1.0;
        };
        if (open_since_s_) {
            tell(0.9f + 0.1f * float(part(*open_since_s_, plan.ends_at_s)),
                 fmt::format("round {}, a claim is open yet", rounds));
            return;
        }
        const double by_time = std::min(part(from_s, from_s + plan.budget_s), double(rounds) / plan.least_rounds);
        tell(0.2f + 0.7f * float(std::min(1.0, std::max(double(rounds) / plan.rounds, by_time))),
             fmt::format("round {} of all tracers in turn", rounds));
    }

    const PaperConfig& config_;
    const PaperProgress& progress_;
    const std::stop_token& stop_;
    PaperResults results_;
    std::map<std::string, Stage, std::less<>> stages_;
    std::vector<Contestant> contestants_;
    double begin_s_ = steady_seconds();
    std::optional<double> open_since_s_;
};

}  // namespace

PaperConfig paper_config(bool quick) {
    PaperConfig config;
    config.base.threads = 1;
    config.quick = quick;
    if (!quick) return config;
    config.base.width = config.base.height = 128;
    config.budget_s = 20;
    config.longest_s.reset();
    return config;
}

PaperResults run_paper(const PaperConfig& config, const PaperProgress& progress, const std::stop_token& stop) {
    return PaperRun(config, progress, stop).run();
}

}  // namespace kd

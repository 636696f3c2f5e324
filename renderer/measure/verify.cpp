#include "renderer/measure/verify.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/kdtree/validate.h"
#include "renderer/measure/compare.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/measure/timing.h"
#include "renderer/trace/walk_choices.h"

namespace kd {

namespace {

struct Stopped {};

/// What is traced, by name.
struct Mode {
    Traversal traversal;
    LeafLists lists;
    Rules rules = Rules::robust;
    NodeEncoding nodes = NodeEncoding::float4;
    TraceConfig walk = {};  // what else is chosen about the walk
    [[nodiscard]] TraceConfig config() const {
        TraceConfig trace;
        trace.short_stack = walk.short_stack;
        trace.optimised_ropes = walk.optimised_ropes;
        trace.traversal = traversal;
        trace.leaf_lists = lists;
        trace.rules = rules;
        trace.nodes = nodes;
        trace.packet_size = walk.packet_size;
        return trace;
    }
};

class Verification {
  public:
    Verification(const FlatScene& scene, const BuildConfig& build, const VerifyConfig& config,
                 const std::function<void(float, const std::string&)>& progress, std::stop_token stop)
        : scene_(scene), build_(build), config_(config), progress_(progress), stop_(std::move(stop)),
          cpu_(cpu_machine(config.threads)) {
        report_.scene = scene.name;
        report_.triangles = std::int64_t(scene.triangles.size());
    }

    VerifyReport run() {
        try {
            choose_modes();
            open_others();
            make_pixel_rays();
            for (std::size_t i = 0; i < config_.builders.size(); ++i) check_builder(i);
        } catch (const Stopped&) {
            report_.complete = false;
        }
        return std::move(report_);
    }

  private:
    void check_stop() const {
        if (stop_.stop_requested()) throw Stopped{};
    }

    void tell(const std::string& what) {
        if (progress_) progress_(float(done_) / float(std::max<std::size_t>(steps_, 1)), what);
        check_stop();
    }

    void choose_modes() {
        if (config_.builders.empty())
            for (const Builder& builder : builders()) config_.builders.emplace_back(builder.name);
        for (const TraversalInfo& traversal : traversals()) {
            const auto& wanted = config_.traversals;
            if (!wanted.empty() && std::ranges::find(wanted, traversal.name) == wanted.end()) continue;
            if (traversal.id == Traversal::naive)
                naive_ = true;
            else if (config_.rules == Rules::robust || traversal.has_published_form())
                modes_.push_back({traversal.id, LeafLists::references, config_.rules,
                                  config_.nodes.value_or(NodeEncoding::float4), config_.walk});
        }
        for (Mode& mode : modes_) mode.nodes = nodes_in_force(mode.config());
        // One traversal shows what the other layout of the leaves does.
        if (!modes_.empty())
            modes_.insert(modes_.begin() + 1, {modes_.front().traversal, LeafLists::duplicated, config_.rules,
                                               modes_.front().nodes, config_.walk});
    }

    /// What is traced in the tree of a builder, by its place among them. The other nodes make no other walk, so they
    /// are not multiplied with the rest: as a diagonal, counted round, each builder and each traversal meets them.
    [[nodiscard]] std::vector<Mode> modes_of(std::size_t builder) const {
        const auto can_change = [](const Mode& mode) {
            return mode.lists == LeafLists::references && why_idle(WalkChoice::nodes, mode.config()).empty();
        };
        std::vector<Mode> modes;
        for (const Mode& mode : modes_) {
            modes.push_back(mode);
            if (config_.nodes || !can_change(mode) || !on_diagonal(mode, builder, can_change)) continue;
            modes.push_back(mode);
            modes.back().nodes = NodeEncoding::packed;
        }
        return modes;
    }

    /// Of the walks that `counts` and the builders, both counted round.
    [[nodiscard]] bool on_diagonal(const Mode& mode, std::size_t builder,
                                   const std::function<bool(const Mode&)>& counts) const {
        std::size_t walks = 0, walk = 0;
        for (const Mode& other : modes_) {
            if (other.lists != LeafLists::references || !counts(other)) continue;
            if (other.traversal == mode.traversal) walk = walks;
            ++walks;
        }
        return walk % config_.builders.size() == builder || builder % walks == walk;
    }

    /// Whether a machine beside the reference takes part.
    [[nodiscard]] bool checks(const RayMachine& machine, const Mode& mode, std::size_t builder) const {
        const auto has_walk = [&](const Mode& other) { return machine.has_walk(other.config()); };
        // The CPU's other tracers have blocks of their own for lists.
        if (!has_walk(mode) || (machine.on_cpu() && mode.lists == LeafLists::duplicated)) return false;
        const bool first = machine.on_cpu() ? config_.cpu.size() == 1 : is_first_gl(machine);
        return first || on_diagonal(mode, builder, has_walk);
    }

    [[nodiscard]] bool is_first_gl(const RayMachine& machine) const {
        return machine.tracer() == tracer_name(config_.gl.front());
    }

    /// The mode as this machine runs it: packets of every size.
    [[nodiscard]] static std::vector<Mode> variants(const RayMachine& machine, const Mode& mode) {
        if (machine.tracer() != tracer_name(CpuMode::packet)) return {mode};
        std::vector<Mode> sizes;
        for (const int size : {4, 8, 16}) {
            sizes.push_back(mode);
            sizes.back().walk.packet_size = size;
        }
        return sizes;
    }

    /// All but the reference, which walks first.
    void open_others() {
        MachineChoice choice = config_;
        shows_reference_ = std::erase(choice.cpu, CpuMode::scalar) > 0;
        others_ = open_machines(choice, "checked", report_.not_checked);
        steps_ = 4;
        for (const auto& machine : others_) steps_ += naive_ && !machine->on_cpu() ? 1 : 0;
        for (std::size_t i = 0; i < config_.builders.size(); ++i) {
            steps_ += 2;
            for (const Mode& mode : modes_of(i)) {
                steps_ += shows_reference_ ? 1 : 0;
                for (const auto& machine : others_)
                    if (checks(*machine, mode, i)) steps_ += variants(*machine, mode).size();
            }
        }
    }

    void make_pixel_rays() {
        tell("brute force over pixel rays");
        const PinholeCamera camera = pinhole(scene_.camera, config_.width, config_.height);
        const bool every_pixel = report_.triangles <= config_.every_pixel_limit;
        pixels_.rays = every_pixel ? pixel_rays(camera, config_.width, config_.height)
                                   : stratified_pixel_rays(camera, config_.width, config_.height,
                                                           config_.stratified_rays, config_.seed);
        if (!every_pixel)
            report_.notes.push_back(fmt::format("{} pixel rays instead of {}: brute force over {} triangles is long",
                                                pixels_.rays.size(), config_.width * config_.height,
                                                report_.triangles));
        pixels_.expected = expected_of(pixels_.rays);
        done_ += 4;
    }

    std::vector<Hit> expected_of(const std::vector<Ray>& rays) const {
        std::vector<Hit> hits = brute_force(scene_, rays, config_.threads, stop_);
        check_stop();
        return hits;
    }

    /// Nearest hits, their counters, and any-hit answers.
    RayAnswers ask(RayMachine& machine, Mode mode, const std::vector<Ray>& rays) const {
        RayAnswers found(rays.size());
        (void)machine.trace(mode.config(), rays, false, found.nearest, found.counters, stop_);
        (void)machine.trace(mode.config(), rays, true, found.any, {}, stop_);
        check_stop();
        return found;
    }

    /// What a machine answers to pixel and to adversarial rays.
    using Answers = std::array<RayAnswers, 2>;

    Answers ask(RayMachine& machine, Mode mode, const ReferenceRays& pixels, const ReferenceRays& hard,
                double& seconds) const {
        Answers found{RayAnswers(0), RayAnswers(0)};
        seconds = 1e-3 * wall_ms([&] { found = {ask(machine, mode, pixels.rays), ask(machine, mode, hard.rays)}; });
        return found;
    }

    void check_builder(std::size_t place) {
        const std::string& builder = config_.builders[place];
        tell(builder + ": building");
        BuildConfig build = build_;
        build.builder = builder;
        BuildReport built;
        const KdTree tree = build_tree(scene_.triangles, build, &built, {}, stop_, config_.threads);
        check_stop();
        for (const std::string& note : build_notes(built))
            report_.notes.push_back(fmt::format("{}: {}", builder, note));
        for (const Violation& violation : validate(tree, scene_.triangles))
            report_.violations.push_back(fmt::format("{}: node {}: {}", builder, violation.node, violation.message));
        ++done_;

        tell(builder + ": brute force over adversarial rays");
        ReferenceRays hard;
        hard.rays = adversarial_rays(scene_, tree, config_.adversarial_rays, config_.seed);
        hard.expected = expected_of(hard.rays);
        ++done_;

        cpu_->load(scene_, tree);
        std::vector<RayMachine*> loaded;
        for (const auto& machine : others_)
            if (load(*machine, tree, builder)) loaded.push_back(machine.get());
        if (place == 0 && naive_)
            for (RayMachine* machine : loaded)
                if (!machine->on_cpu() && machine->has_walk({.traversal = Traversal::naive}))
                    check_naive(*machine, hard);
        std::optional<Answers> wide;  // by the CPU, of the mode before: the same one where nodes of 8 bytes follow
        for (const Mode& mode : modes_of(place)) check_mode(mode, place, hard, loaded, wide);
    }

    bool load(RayMachine& machine, const KdTree& tree, const std::string& builder) {
        try {
            machine.load(scene_, tree);
            return true;
        } catch (const InputError& error) {
            report_.not_checked.push_back(fmt::format("{}: {} on {} not checked: {}", builder, machine.tracer(),
                                                      machine.context(), error.what()));
            return false;
        }
    }

    void check_mode(const Mode& mode, std::size_t place, const ReferenceRays& hard,
                    const std::vector<RayMachine*>& loaded, std::optional<Answers>& wide) {
        const std::string& builder = config_.builders[place];
        VerifyRow row = row_for(mode, builder, *cpu_);
        tell(row.builder + ", " + row.traversal + " on the CPU");
        Answers by_cpu = ask(*cpu_, mode, pixels_, hard, row.seconds);
        compare(row, pixels_, hard, by_cpu);
        const bool follows = mode.nodes == NodeEncoding::packed && !config_.nodes;
        if (follows) compare_all_counters(row, hard, *wide, by_cpu);
        if (shows_reference_) {
            report_.rows.push_back(std::move(row));
            ++done_;
        }
        for (RayMachine* machine : loaded)
            if (checks(*machine, mode, place))
                for (const Mode& variant : variants(*machine, mode))
                    check_other(*machine, variant, row_for(variant, builder, *machine), pixels_, hard, &by_cpu);
        if (!follows) wide = std::move(by_cpu);
    }

    void compare_all_counters(VerifyRow& row, const ReferenceRays& hard, const Answers& expected,
                              const Answers& found) const {
        compare_counters(scene_, pixels_, expected[0], found[0], row);
        compare_counters(scene_, hard, expected[1], found[1], row);
    }

    void check_other(RayMachine& machine, const Mode& mode, VerifyRow row, const ReferenceRays& pixels,
                     const ReferenceRays& hard, const Answers* by_cpu) {
        const std::string by = machine.on_cpu() ? row.tracer : fmt::format("{} on {}", row.tracer, row.context);
        tell(fmt::format("{}, {} by {}", row.builder, row.traversal, by));
        try {
            const Answers found = ask(machine, mode, pixels, hard, row.seconds);
            compare(row, pixels, hard, found);
            if (by_cpu) compare_all_counters(row, hard, *by_cpu, found);
            report_.rows.push_back(std::move(row));
        } catch (const InputError& error) {
            report_.not_checked.push_back(
                fmt::format("{} with {} by {} not checked: {}", row.traversal, row.leaf_lists, by, error.what()));
        }
        ++done_;
    }

    /// The naive traversal reads no tree, so once is enough, and as many rays as its cost allows.
    void check_naive(RayMachine& machine, const ReferenceRays& hard) {
        const std::int64_t rays = std::int64_t(pixels_.rays.size() + hard.rays.size());
        const auto step = std::size_t(1 + rays * report_.triangles / std::max<std::int64_t>(config_.gl_naive_tests, 1));
        if (step > 1)
            report_.notes.push_back(
                fmt::format("naive on {}: one ray in {} only, as each takes all triangles", machine.context(), step));
        const Mode mode{Traversal::naive, LeafLists::references};
        check_other(machine, mode, row_for(mode, "-", machine), pixels_.every(step), hard.every(step), nullptr);
    }

    static VerifyRow row_for(const Mode& mode, const std::string& builder, const RayMachine& machine) {
        VerifyRow row;
        row.builder = builder;
        row.traversal = info(mode.traversal).name;
        row.leaf_lists = mode.lists == LeafLists::duplicated ? "duplicated" : "references";
        row.node_bytes = mode.traversal == Traversal::naive ? 0 : bytes_of(mode.nodes);
        row.tracer = machine.tracer();
        row.packet = row.tracer == tracer_name(CpuMode::packet) ? mode.walk.packet_size : 0;
        row.context = machine.context();
        return row;
    }

    void compare(VerifyRow& row, const ReferenceRays& pixels, const ReferenceRays& hard, const Answers& found) const {
        row.pixel_rays = std::int64_t(pixels.rays.size());
        row.adversarial_rays = std::int64_t(hard.rays.size());
        compare_hits(scene_, pixels, found[0], row);
        compare_hits(scene_, hard, found[1], row);
    }

    const FlatScene& scene_;
    BuildConfig build_;
    VerifyConfig config_;
    const std::function<void(float, const std::string&)>& progress_;
    std::stop_token stop_;
    VerifyReport report_;
    std::vector<Mode> modes_;
    bool naive_ = false;
    std::unique_ptr<RayMachine> cpu_;  // the reference
    bool shows_reference_ = true;      // in rows of its own
    std::vector<std::unique_ptr<RayMachine>> others_;
    ReferenceRays pixels_;
    std::size_t done_ = 0, steps_ = 1;
};

}  // namespace

bool VerifyReport::passed() const {
    return complete && violations.empty() && !rows.empty() && std::ranges::all_of(rows, &VerifyRow::good);
}

VerifyReport verify(const FlatScene& scene, const BuildConfig& build, const VerifyConfig& config,
                    const std::function<void(float, const std::string&)>& progress, std::stop_token stop) {
    return Verification(scene, build, config, progress, std::move(stop)).run();
}

}  // namespace kd

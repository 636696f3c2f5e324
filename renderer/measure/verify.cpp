#include "renderer/measure/verify.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/geometry/input_error.h"
#include "renderer/kdtree/validate.h"
#include "renderer/measure/compare.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

// Between looks at the stop request: rays, and ray-triangle products of brute force.
constexpr std::size_t rays_per_step = 16384;
constexpr std::int64_t products_per_step = 500'000'000;

struct Stopped {};

/// A GL context with its tracer.
struct Machine {
    explicit Machine(ContextKind kind) : context(Context::create(kind)), tracer(std::make_unique<GlTracer>(*context)) {}
    ~Machine() {
        // The tracer's objects live in its own context.
        if (context) context->make_current();
    }
    Machine(Machine&&) = default;

    std::unique_ptr<Context> context;
    std::unique_ptr<GlTracer> tracer;
    bool refused = false;  // the tree at hand is not on it
};

/// What is traced, by name.
struct Mode {
    Traversal traversal;
    LeafLists lists;
    [[nodiscard]] TraceConfig config() const {
        TraceConfig trace;
        trace.traversal = traversal;
        trace.leaf_lists = lists;
        return trace;
    }
};

class Verification {
  public:
    Verification(const FlatScene& scene, const BuildConfig& build, const VerifyConfig& config,
                 const std::function<void(float, const std::string&)>& progress, std::stop_token stop)
        : scene_(scene), build_(build), config_(config), progress_(progress), stop_(std::move(stop)) {
        report_.scene = scene.name;
        report_.triangles = std::int64_t(scene.triangles.size());
    }

    VerifyReport run() {
        try {
            choose_modes();
            open_contexts();
            make_pixel_rays();
            for (std::size_t i = 0; i < config_.builders.size(); ++i) check_builder(config_.builders[i], i == 0);
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
            else
                modes_.push_back({traversal.id, LeafLists::references});
        }
        // One traversal shows what the other layout of the leaves does.
        if (!modes_.empty()) modes_.insert(modes_.begin() + 1, {modes_.front().traversal, LeafLists::duplicated});
    }

    void open_contexts() {
        for (const ContextKind kind : config_.contexts) {
            try {
                machines_.emplace_back(kind);
            } catch (const ContextError& error) {
                report_.notes.push_back(fmt::format("gl-fragment on {} not checked: {}", name_of(kind), error.what()));
            }
        }
        const std::size_t runs = modes_.size() * ((config_.cpu ? 1 : 0) + machines_.size());
        steps_ = 4 + config_.builders.size() * (2 + runs) + (naive_ ? machines_.size() : 0);
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
        pixels_.expected = brute_force(pixels_.rays);
        done_ += 4;
    }

    std::vector<Hit> brute_force(const std::vector<Ray>& rays) const {
        static const KdTree no_tree;
        CpuTracer tracer(scene_, no_tree);
        return cpu_answers(tracer, Mode{Traversal::naive, LeafLists::references}, rays, false).nearest;
    }

    RayAnswers cpu_answers(CpuTracer& tracer, Mode mode, const std::vector<Ray>& rays, bool all) const {
        return answers(rays, mode, all, [&](std::span<const Ray> part, bool any, auto hits, auto counters) {
            tracer.trace_rays(mode.config(), part, any, hits, counters, config_.threads);
        });
    }

    RayAnswers gl_answers(GlTracer& tracer, Mode mode, const std::vector<Ray>& rays) const {
        return answers(rays, mode, true, [&](std::span<const Ray> part, bool any, auto hits, auto counters) {
            tracer.trace_rays(mode.config(), part, any, hits, counters);
        });
    }

    std::size_t step_for(Mode mode) const {
        if (mode.traversal != Traversal::naive) return rays_per_step;
        // The CPU tracer gives its threads 1024 rays at a time.
        const auto fewest = 1024 * std::size_t(config_.threads > 0 ? config_.threads : default_threads());
        return std::max(fewest, std::size_t(products_per_step / std::max<std::int64_t>(report_.triangles, 1)));
    }

    /// Nearest hits, and with `all` also counters and any-hit answers.
    template <class Trace>
    RayAnswers answers(const std::vector<Ray>& rays, Mode mode, bool all, const Trace& trace) const {
        RayAnswers found(rays.size());
        const std::size_t step = step_for(mode);
        for (std::size_t first = 0; first < rays.size(); first += step) {
            check_stop();
            const std::size_t n = std::min(step, rays.size() - first);
            const std::span part = std::span(rays).subspan(first, n);
            const auto counters = all ? std::span(found.counters).subspan(first, n) : std::span<RayCounters>();
            trace(part, false, std::span(found.nearest).subspan(first, n), counters);
            if (all) trace(part, true, std::span(found.any).subspan(first, n), std::span<RayCounters>());
        }
        return found;
    }

    void check_builder(const std::string& builder, bool first) {
        tell(builder + ": building");
        BuildConfig build = build_;
        build.builder = builder;
        BuildReport built;
        const KdTree tree = build_tree(scene_.triangles, build, &built, {}, stop_);
        check_stop();
        if (built.reference_cap_hit) report_.notes.push_back(builder + ": the build stopped at the reference cap");
        for (const Violation& violation : validate(tree, scene_.triangles))
            report_.violations.push_back(fmt::format("{}: node {}: {}", builder, violation.node, violation.message));
        ++done_;

        tell(builder + ": brute force over adversarial rays");
        ReferenceRays hard;
        hard.rays = adversarial_rays(scene_, tree, config_.adversarial_rays, config_.seed);
        hard.expected = brute_force(hard.rays);
        ++done_;

        for (Machine& machine : machines_) upload(machine, tree, builder);
        if (first && naive_)
            for (Machine& machine : machines_) check_naive(machine, hard);
        CpuTracer cpu(scene_, tree);
        for (const Mode& mode : modes_) check_mode(cpu, mode, builder, hard);
    }

    void upload(Machine& machine, const KdTree& tree, const std::string& builder) {
        machine.context->make_current();
        machine.refused = false;
        try {
            machine.tracer->upload(scene_, tree);
        } catch (const InputError& error) {
            machine.refused = true;
            report_.notes.push_back(fmt::format("{}: gl-fragment on {} not checked: {}", builder,
                                                name_of(machine.context->kind()), error.what()));
        }
    }

    void check_mode(CpuTracer& cpu, const Mode& mode, const std::string& builder, const ReferenceRays& hard) {
        VerifyRow row = row_for(mode, builder);
        row.tracer = "cpu";
        tell(row.builder + ", " + row.traversal + " on the CPU");
        std::array<RayAnswers, 2> by_cpu{RayAnswers(0), RayAnswers(0)};
        row.seconds = 1e-3 * wall_ms([&] {
                          by_cpu[0] = cpu_answers(cpu, mode, pixels_.rays, true);
                          by_cpu[1] = cpu_answers(cpu, mode, hard.rays, true);
                      });
        compare(row, pixels_, hard, by_cpu);
        if (config_.cpu) {
            report_.rows.push_back(std::move(row));
            ++done_;
        }
        for (Machine& machine : machines_)
            if (!machine.refused) check_gl(machine, mode, row_for(mode, builder), pixels_, hard, &by_cpu);
    }

    void check_gl(Machine& machine, const Mode& mode, VerifyRow row, const ReferenceRays& pixels,
                  const ReferenceRays& hard, const std::array<RayAnswers, 2>* by_cpu) {
        row.tracer = "gl-fragment";
        row.context = name_of(machine.context->kind());
        tell(row.builder + ", " + row.traversal + " on " + row.context);
        machine.context->make_current();
        try {
            std::array<RayAnswers, 2> by_gl{RayAnswers(0), RayAnswers(0)};
            row.seconds = 1e-3 * wall_ms([&] {
                              by_gl[0] = gl_answers(*machine.tracer, mode, pixels.rays);
                              by_gl[1] = gl_answers(*machine.tracer, mode, hard.rays);
                          });
            compare(row, pixels, hard, by_gl);
            if (by_cpu) {
                compare_counters(pixels, (*by_cpu)[0], by_gl[0], row);
                compare_counters(hard, (*by_cpu)[1], by_gl[1], row);
            }
            report_.rows.push_back(std::move(row));
        } catch (const InputError& error) {
            report_.notes.push_back(fmt::format("{} with {} on {} not checked: {}", row.traversal, row.leaf_lists,
                                                row.context, error.what()));
        }
        ++done_;
    }

    /// The naive traversal reads no tree, so once is enough, and as many rays as its cost allows.
    void check_naive(Machine& machine, const ReferenceRays& hard) {
        if (machine.refused) return;
        const std::int64_t rays = std::int64_t(pixels_.rays.size() + hard.rays.size());
        const auto step = std::size_t(1 + rays * report_.triangles / std::max<std::int64_t>(config_.gl_naive_tests, 1));
        if (step > 1)
            report_.notes.push_back(fmt::format("naive on {}: one ray in {} only, as each takes all triangles",
                                                name_of(machine.context->kind()), step));
        const Mode mode{Traversal::naive, LeafLists::references};
        check_gl(machine, mode, row_for(mode, "-"), pixels_.every(step), hard.every(step), nullptr);
    }

    static VerifyRow row_for(const Mode& mode, const std::string& builder) {
        VerifyRow row;
        row.builder = builder;
        row.traversal = info(mode.traversal).name;
        row.leaf_lists = mode.lists == LeafLists::duplicated ? "duplicated" : "references";
        row.context = "-";
        return row;
    }

    static void compare(VerifyRow& row, const ReferenceRays& pixels, const ReferenceRays& hard,
                        const std::array<RayAnswers, 2>& found) {
        row.pixel_rays = std::int64_t(pixels.rays.size());
        row.adversarial_rays = std::int64_t(hard.rays.size());
        compare_hits(pixels, found[0], row);
        compare_hits(hard, found[1], row);
    }

    const FlatScene& scene_;
    BuildConfig build_;
    VerifyConfig config_;
    const std::function<void(float, const std::string&)>& progress_;
    std::stop_token stop_;
    VerifyReport report_;
    std::vector<Mode> modes_;
    bool naive_ = false;
    std::vector<Machine> machines_;
    ReferenceRays pixels_;
    std::size_t done_ = 0, steps_ = 1;
};

}  // namespace

bool VerifyReport::passed() const {
    const auto good = [](const VerifyRow& row) { return row.mismatches == 0 && row.counter_mismatches == 0; };
    return complete && violations.empty() && !rows.empty() && std::ranges::all_of(rows, good);
}

VerifyReport verify(const FlatScene& scene, const BuildConfig& build, const VerifyConfig& config,
                    const std::function<void(float, const std::string&)>& progress, std::stop_token stop) {
    return Verification(scene, build, config, progress, std::move(stop)).run();
}

}  // namespace kd

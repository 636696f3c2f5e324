#include "renderer/measure/ray_machine.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/gl/object.h"
#include "renderer/trace/walk_choices.h"

namespace kd {

namespace {

// Between looks at the stop request.
constexpr std::size_t rays_per_draw = 65536;

class CpuMachine : public RayMachine {
  public:
    CpuMachine(int threads, CpuMode mode) : threads_(threads), mode_(mode) {}

    [[nodiscard]] std::string tracer() const override { return std::string(tracer_name(mode_)); }
    [[nodiscard]] std::string context() const override { return "-"; }
    [[nodiscard]] bool has_walk(const TraceConfig& config) const override {
        return mode_ != CpuMode::packet || why_idle(WalkChoice::packet, config).empty();
    }
    void load(const FlatScene& scene, const KdTree& tree) override {
        tracer_ = std::make_unique<CpuTracer>(scene, tree, mode_);
    }
    bool trace(const TraceConfig& config, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
               std::span<RayCounters> counters, std::stop_token stop) override {
        return tracer_->trace_rays(config, rays, any_hit, hits, counters, threads_, std::move(stop));
    }
    Frame frame(const TraceConfig& config, const PinholeCamera& camera, int width, int height,
                std::stop_token stop) override {
        Frame traced(width, height);
        tracer_->trace_frame(config, camera, traced, threads_, std::move(stop));
        return traced;
    }

  private:
    int threads_;
    CpuMode mode_;
    std::unique_ptr<CpuTracer> tracer_;
};

class GlMachine : public RayMachine {
  public:
    GlMachine(ContextKind kind, GlMode mode)
        : mode_(mode), context_(Context::create(kind)), tracer_(std::make_unique<GlTracer>(*context_, mode)) {}
    // The tracer's objects live in its own context.
    ~GlMachine() override { context_->make_current(); }

    [[nodiscard]] std::string tracer() const override { return std::string(tracer_name(mode_)); }
    [[nodiscard]] std::string context() const override { return std::string(name_of(context_->kind())); }
    [[nodiscard]] bool has_walk(const TraceConfig& config) const override { return kd::has_walk(mode_, config); }
    void load(const FlatScene& scene, const KdTree& tree) override {
        context_->make_current();
        tracer_->upload(scene, tree);
    }
    bool trace(const TraceConfig& config, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
               std::span<RayCounters> counters, std::stop_token stop) override {
        context_->make_current();
        for (std::size_t first = 0; first < rays.size(); first += rays_per_draw) {
            if (stop.stop_requested()) return false;
            const std::size_t n = std::min(rays_per_draw, rays.size() - first);
            tracer_->trace_rays(config, rays.subspan(first, n), any_hit, hits.subspan(first, n),
                                counters.empty() ? counters : counters.subspan(first, n));
        }
        return true;
    }
    Frame frame(const TraceConfig& config, const PinholeCamera& camera, int width, int height,
                std::stop_token) override {
        context_->make_current();
        GlTraceConfig gl;
        gl.trace = config;
        tracer_->draw(gl, camera, width, height, {0, 0, width, height});
        return tracer_->read_frame(config);
    }
    int live_objects() override {
        context_->make_current();
        const auto counts = count_objects(context_->gl());
        return std::accumulate(counts.begin(), counts.end(), 0);
    }

  private:
    GlMode mode_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<GlTracer> tracer_;
};

}  // namespace

std::unique_ptr<RayMachine> cpu_machine(int threads, CpuMode mode) {
    return std::make_unique<CpuMachine>(threads, mode);
}

std::unique_ptr<RayMachine> gl_machine(ContextKind kind, GlMode mode) {
    return std::make_unique<GlMachine>(kind, mode);
}

std::vector<std::unique_ptr<RayMachine>> open_machines(const MachineChoice& choice, std::string_view undone,
                                                       std::vector<std::string>& notes) {
    std::vector<std::unique_ptr<RayMachine>> machines;
    for (const CpuMode mode : choice.cpu) machines.push_back(cpu_machine(choice.threads, mode));
    for (const ContextKind kind : choice.contexts)
        for (const GlMode mode : choice.gl) {
            try {
                machines.push_back(gl_machine(kind, mode));
            } catch (const ContextError& error) {
                notes.push_back(
                    fmt::format("{} on {} not {}: {}", tracer_name(mode), name_of(kind), undone, error.what()));
            }
        }
    return machines;
}

std::vector<Hit> brute_force(const FlatScene& scene, std::span<const Ray> rays, int threads, std::stop_token stop) {
    const KdTree no_tree;
    CpuTracer tracer(scene, no_tree);
    TraceConfig config;
    config.traversal = Traversal::naive;
    std::vector<Hit> hits(rays.size());
    tracer.trace_rays(config, rays, false, hits, {}, threads, std::move(stop));
    return hits;
}

}  // namespace kd

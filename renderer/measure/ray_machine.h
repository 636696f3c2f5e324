// What traces lists of rays: the CPU in one of its ways, or one kind of shaders on an OpenGL context.
#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/cpu/cpu_mode.h"
#include "renderer/gl/context.h"
#include "renderer/gl/gl_mode.h"
#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/trace_config.h"

namespace kd {

class RayMachine {
  public:
    virtual ~RayMachine() = default;

    [[nodiscard]] virtual std::string tracer() const = 0;   // "cpu-wide", "gl-fragment"
    [[nodiscard]] virtual std::string context() const = 0;  // "osmesa", "egl"; "-" on the CPU
    [[nodiscard]] bool on_cpu() const { return context() == "-"; }
    /// The tracer that the others are held against: one ray and one triangle at a time on the CPU.
    [[nodiscard]] bool is_reference() const { return tracer() == tracer_name(CpuMode::scalar); }
    /// False for walks that it refuses or leaves to another tracer: packets walk by the stack under robust rules, other
    /// rays singly as those of "cpu-wide" do; "gl-wavefront" has robust rules and walks in steps alone.
    [[nodiscard]] virtual bool has_walk(const TraceConfig&) const { return true; }
    /// Takes scene and tree, which must outlive their use. InputError where they do not fit on it.
    virtual void load(const FlatScene& scene, const KdTree& tree) = 0;
    /// `counters` may be empty: nothing is counted then. False where stopped. InputError for what it cannot trace.
    virtual bool trace(const TraceConfig& config, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
                       std::span<RayCounters> counters, std::stop_token stop) = 0;
    /// A whole frame, all passes. Incomplete where stopped.
    virtual Frame frame(const TraceConfig& config, const PinholeCamera& camera, int width, int height,
                        std::stop_token stop) = 0;
    /// OpenGL objects that its context holds, of all kinds; 0 on the CPU.
    [[nodiscard]] virtual int live_objects() { return 0; }
};

/// `threads` 0 = all.
[[nodiscard]] std::unique_ptr<RayMachine> cpu_machine(int threads, CpuMode mode = CpuMode::scalar);

/// ContextError where there is no such context.
[[nodiscard]] std::unique_ptr<RayMachine> gl_machine(ContextKind kind, GlMode mode = GlMode::fragment);

/// What a check or a measurement runs on.
struct MachineChoice {
    std::vector<CpuMode> cpu{CpuMode::scalar};
    std::vector<GlMode> gl{GlMode::fragment};  // each on each of the contexts
    std::vector<ContextKind> contexts;         // besides the CPU; empty = none
    int threads = 0;                           // of the CPU; 0 = all
};

/// The CPU's, then those of OpenGL that there are; of each other a note: "gl-fragment on egl not checked: why", with
/// `undone` for "checked".
[[nodiscard]] std::vector<std::unique_ptr<RayMachine>>
open_machines(const MachineChoice& choice, std::string_view undone, std::vector<std::string>& notes);

/// The answers of the naive traversal on the CPU: the reference of every other. Incomplete where stopped.
[[nodiscard]] std::vector<Hit> brute_force(const FlatScene& scene, std::span<const Ray> rays, int threads = 0,
                                           std::stop_token stop = {});

}  // namespace kd

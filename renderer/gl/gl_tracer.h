// Traces on OpenGL: GPURT, the paper's four passes over a kd-tree (section 3.2) and two of indirect light, by one of
// three kinds of shaders.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "renderer/gl/ballots.h"
#include "renderer/gl/context.h"
#include "renderer/gl/gl_error.h"
#include "renderer/gl/gl_mode.h"
#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/schedule.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// How pixels that a pass need not shade are culled (paper, section 3.2.1).
enum class EarlyZ {
    working,  // RTPrim writes 0 reflective hit, 0.25 other hit, 1 miss; later quads lie between, depth test GREATER
    as_published,  // RTPrim writes 0 hit, 1 miss; quad at 0 with LEQUAL: culls nothing
};

struct GlTraceConfig {
    TraceConfig trace;
    EarlyZ early_z = EarlyZ::working;
    bool count_shaded = false;  // counts the pixels each pass shades, exactly (an atomic with early fragment tests)

    bool operator==(const GlTraceConfig&) const = default;
};

/// Per pass: time in ms, and shaded pixels where counted (-1 where not, or where the pass did not run).
struct GlFrameReport {
    std::array<double, pass_count> pass_ms{};
    std::array<std::int64_t, pass_count> shaded_pixels = for_each_pass<std::int64_t>(-1);
    double total_ms = 0;
    double wall_ms = 0;  // the same by the steady clock; 0 where the clock is that one
    std::string clock;   // "timer query" on hardware, "finish + steady clock" on software
};

/// Memory that an upload takes, in bytes.
struct GlMemory {
    std::int64_t nodes = 0, boxes = 0, references = 0, triangles = 0, attributes = 0, textures = 0, targets = 0,
                 rays = 0;  // states and queues of GlMode::wavefront, lists of pixels of GlMode::compute

    [[nodiscard]] std::int64_t total() const {
        return nodes + boxes + references + triangles + attributes + textures + targets + rays;
    }
    bool operator==(const GlMemory&) const = default;
};

/// All calls need the context current. GL errors and shader errors are thrown as GlError with file and line.
class GlTracer {
  public:
    /// SelfTestError where the context computes wrongly (renderer/gl/self_test.h).
    explicit GlTracer(Context& context, GlMode mode = GlMode::fragment);
    ~GlTracer();

    /// Uploads what every configuration reads of scene and tree; both must outlive the next upload. InputError with the
    /// numbers where they do not fit the context; the previous upload stays usable then.
    void upload(const FlatScene& scene, const KdTree& tree);

    /// Compiles the programs and makes the tables and targets that a configuration needs, outside of any timing.
    /// InputError where GlMode::wavefront has no steps for the walk, and
    /// with the numbers where a limit of the nodes' encoding, of textures or of the loop budget is passed.
    void prepare(const GlTraceConfig& config, int width, int height);

    /// Draws the passes for `tile` of a width x height frame into the tracer's own targets.
    GlFrameReport draw(const GlTraceConfig& config, const PinholeCamera& camera, int width, int height, Tile tile);

    /// The targets of the last draws as a Frame (reads back).
    [[nodiscard]] Frame read_frame(const TraceConfig& config);

    /// Traces arbitrary rays with the RTPrim program fed from a texture. `counters` as in CpuTracer::trace_rays.
    void trace_rays(const TraceConfig& config, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
                    std::span<RayCounters> counters);

    /// Walks the rays of a width x height picture, one per pixel in rows, by a loop that counts its own lanes.
    /// BallotError where the driver has no ballots or `config` no such loop.
    [[nodiscard]] BallotLayer measure_ballots(const TraceConfig& config, Schedule loop, std::span<const Ray> rays,
                                              bool any_hit, int width, int height);

    /// Whether quotients and roots are corrected to the nearest number (shaders/shared/rounding.glsl): on hardware they
    /// are unless told otherwise, and hits and counters then equal the CPU's.
    void correct_rounding(bool on);

    [[nodiscard]] GlMemory memory() const;

    /// `told` gets the number of programs that are being compiled in a prepare(), growing one by one, and 0 when all
    /// are ready. Nothing is told where all are there already.
    void tell_compiling(std::function<void(int)> told);

    struct Impl;  // renderer/gl/gl_tracer_impl.h

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace kd

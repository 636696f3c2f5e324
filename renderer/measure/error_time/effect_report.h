// Report P6: how far a picture of sampled light is from the converged one, against the seconds it takes.
#pragma once

#include <array>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/measure/error_time/fit.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/triangle_boxes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// Effects of sampled light that are measured together; the others are off.
struct LightEffect {
    std::string name;  // "soft shadows", "all effects"
    Sampling sampling;
};

/// Each of soft shadows, gloss and indirect light that `scene` has under `config`, then all of them where there are
/// several.
[[nodiscard]] std::vector<LightEffect> light_effects(const FlatScene& scene, TraceConfig config);

/// Where the points of a pixel's samples come from. `sequence`: kdscope's own, of low discrepancy (docs/light.md), in
/// its order; `independent`: points of that sequence drawn at random, so that each lies anywhere; `adaptive`: the
/// sequence, without the tiles that have converged to a standard error.
enum class LightPoints { sequence, independent, adaptive };
inline constexpr std::array<std::string_view, 3> light_point_names{"sequence", "independent", "adaptive"};
[[nodiscard]] inline std::string_view name_of(LightPoints points) { return light_point_names[std::size_t(points)]; }

/// A picture of samples that was gathered until its tiles had converged.
struct GatheredImage {
    Image<Vec4> colour;
    double ms = 0;               // of tracing, by the method's clock
    double average_samples = 0;  // of a pixel
    bool paused = false;         // a tile had converged before the last sample
};

/// One way of tracing frames of the plan's size through effect_camera().
struct EffectMethod {
    std::string machine, clock;
    /// One frame of samples.
    std::function<TimeSample(const TraceConfig&, Image<Vec4>&)> trace;
    /// Up to `samples` of each pixel, less where its tile's standard error is at most `error`.
    std::function<GatheredImage(const TraceConfig&, int samples, double error)> gather;
};

struct EffectPlan {
    int width = 128, height = 128;
    int most_samples = 256;        // a power of two: 1, 2, 4, ... are measured
    int reference_samples = 2048;  // in double precision, of other seeds than any that is measured
    int sets = 4;                  // of samples, each of a seed, whose spread gives the intervals
    double predicted_seconds = 0;
};

/// Wall clock of a frame of one effect, in ms: by each method, and in double precision.
struct EffectCost {
    std::vector<double> method_ms;
    double reference_ms = 0;
};

/// The best plan that is predicted to end within `seconds`, from frames of `probe_pixels` pixels; the cheapest where
/// none fits. The last of `costs` is the one that is sampled adaptively as well.
[[nodiscard]] EffectPlan plan_effects(double seconds, const std::vector<EffectCost>& costs, int probe_pixels);

struct EffectPoint {
    int samples = 0;             // of a pixel at most
    double average_samples = 0;  // of a pixel; over sets
    double asked_error = 0;      // adaptive: the standard error, of white 1, at which tiles paused
    double seconds = 0;
    Interval quartiles;       // of seconds
    double relative_mse = 0;  // relative_mean_square_error(), mean over sets
    Interval relative_mse_interval;
    double rmse = 0;        // root of the mean square over sets
    bool on_front = false;  // no other of the effect's points is both quicker and nearer to the reference
};

struct EffectCurve {
    LightPoints light_points = LightPoints::sequence;
    std::string machine, clock;
    TimeSummary frame;  // ms, of a whole frame of one sample
    std::vector<EffectPoint> points;
    PowerFit fit;    // of the relMSE over samples; not of adaptive ones
    double gap = 0;  // largest difference of the first set's RMSE from the first machine's
};

struct MeasuredEffect {
    LightEffect effect;
    double reference_rmse = 0, reference_relative_mse = 0;  // what the reference itself may be off by
    std::vector<EffectCurve> curves;
};

struct EffectReport {
    EffectPlan plan;
    std::vector<MeasuredEffect> effects;
    bool complete = false;
};

struct EffectTask {
    const FlatScene& scene;
    const TriangleBoxes& boxes;
    TraceConfig config;  // but for its sampling
    EffectPlan plan;
    std::vector<LightEffect> effects;   // the last is sampled adaptively as well
    std::vector<EffectMethod> methods;  // the first traces the further sets as well: let it be the quickest
    int threads = 0;
    unsigned seed = 1;
    double frame_seconds =
        5;  // of timing frames, for each effect, all methods in turn; at least six rounds all the same
};

/// The scene's camera, off by a part of a pixel: the middles of pixels lie on edges of scenes as regular as a room, and
/// there rounding decides what is hit, however many samples of light are drawn.
[[nodiscard]] PinholeCamera effect_camera(const FlatScene& scene, int width, int height);

/// Standard errors at which tiles pause, one after another.
inline constexpr std::array adaptive_errors{0.04, 0.02, 0.01, 0.005};

/// `progress` gets the fraction done and what runs. Incomplete where stopped.
[[nodiscard]] EffectReport report_effects(const EffectTask& task,
                                          const std::function<void(float, const std::string&)>& progress = {},
                                          const std::stop_token& stop = {});

}  // namespace kd

// Report P1: how far an image of n samples per pixel is from the converged one, against the seconds it takes.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/measure/error_time/fit.h"
#include "renderer/measure/error_time/reference_image.h"
#include "renderer/measure/error_time/sampling.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/measure/triangle_boxes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// One way of tracing frames.
struct ImageMethod {
    std::string machine, traversal;  // "cpu", "stack"
    std::string clock;
    /// Traces a frame of the plan's size.
    std::function<TimeSample(const PinholeCamera&, Image<Vec4>&)> trace;
};

struct ImagePlan {
    int width = 128, height = 128;
    int most_samples = 64;        // a power of two: 1, 2, 4, ... are measured
    int reference_samples = 512;  // in double precision, stratified, of other offsets than any that is measured
    int sets = 8;                 // of samples at random, whose spread gives the intervals
    double predicted_seconds = 0;
};

/// The best plan that is predicted to end within `seconds`: its frames' times by the methods and by double precision
/// are given in ms for `probe_pixels` pixels. The cheapest plan where none fits.
[[nodiscard]] ImagePlan plan_images(double seconds, const std::vector<double>& method_ms, double reference_ms,
                                    int probe_pixels);

/// One number of samples by one method.
struct ImagePoint {
    int samples = 0;
    double seconds = 0;      // samples times a frame's median
    Interval quartiles;      // the same of its quartiles
    double rmse = 0;         // root of the mean square over the sets; the first set is the method's own
    Interval rmse_interval;  // over the sets; a point where the sampler leaves nothing to chance
    double own_rmse = 0;     // of the first set alone, as this method traced it
    double flip = 0;         // mean FLIP of the same images, over pixels and sets
    Interval flip_interval;  // over the sets, as that of rmse
    bool on_front = false;   // no other method and number of samples is both quicker and nearer to the reference
};

struct ImageCurve {
    Sampler sampler = Sampler::regular;
    std::string machine, traversal, clock;
    TimeSummary frame;             // ms
    double clock_discrepancy = 0;  // of the frames, as TimedRounds has it
    MedianInterval of_first;       // a frame's time over that of the first method's, round by round
    std::vector<ImagePoint> points;
    PowerFit fit;          // of rmse over samples
    double worst_gap = 0;  // largest difference of own_rmse from the first method's
    double own_gap = 0;    // the same from the first method's on the curve's own machine: rounding, or a fault
};

struct ImageReport {
    /// Traversals on one machine compute colours alike from the same hits: up to this their RMSE may differ.
    static constexpr double most_own_gap = 1e-7;

    ImagePlan plan;
    std::vector<ImageCurve> curves;
    double reference_rmse = 0;  // what the reference itself may be off by, from its two halves
    bool complete = false;

    /// Names, in the order of the curves.
    [[nodiscard]] std::vector<std::string> machines() const;
    /// The largest own_gap of its curves.
    [[nodiscard]] double own_gap(const std::string& machine) const;
    /// Whether no traversal changes the image, on any machine.
    [[nodiscard]] bool same_images() const;
};

struct ImageTask {
    const FlatScene& scene;
    const TriangleBoxes& boxes;
    TraceConfig config;  // shadows, bounces
    ImagePlan plan;
    std::vector<ImageMethod> methods;  // the first traces the further sets as well: let it be the quickest
    int threads = 0;
    unsigned seed = 1;
    double frame_seconds = 5;  // of timing frames, all methods in turn; at least six rounds all the same
};

/// `progress` gets the fraction done and what runs. Incomplete where stopped.
[[nodiscard]] ImageReport report_images(const ImageTask& task,
                                        const std::function<void(float, const std::string&)>& progress = {},
                                        std::stop_token stop = {});

/// The plan's samples per pixel, stratified, in double precision. No image where stopped.
[[nodiscard]] ReferenceImage reference_image(const ImageTask& task, const std::function<void(float)>& progress,
                                             const std::stop_token& stop);

}  // namespace kd

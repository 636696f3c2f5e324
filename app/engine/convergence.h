// Error against time behind the window: the resting picture, sampled on and on, and the configurations tried so far.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session.h"
#include "renderer/measure/error_time/image_error.h"
#include "renderer/measure/error_time/sampling.h"
#include "renderer/measure/timing.h"

namespace kd {

/// One way of sampling the resting picture, as far as it has come.
struct ConvergenceCurve {
    Session session;  // that was traced
    Sampler sampler = Sampler::independent;
    struct Point {
        int samples = 0;     // a power of two
        double seconds = 0;  // that their frames took, by the tracer's clock
        double rmse = 0;     // estimated from two half-buffers
    };
    std::vector<Point> points;

    /// "independent, restart, cpu"
    [[nodiscard]] std::string name() const;
};

/// A configuration whose whole frame was traced in this sitting.
struct TriedConfiguration {
    Session session;
    double steps_per_pixel = 0;  // nodes and leaves visited by all rays of a pixel, on average
    TimeSummary time;            // ms per frame
    bool counted = true;         // the time is of one frame with counters, not of rounds without

    /// "ball:9000, paper, restart, cpu"
    [[nodiscard]] std::string name() const;
};

struct ConvergenceState {
    static constexpr int most_samples = 512;

    bool active = false;
    Sampler sampler = Sampler::independent;  // of the samples that are taken
    int samples = 0;                         // of the curve that grows
    double seconds = 0;
    std::vector<ConvergenceCurve> curves;   // of one picture, newest last
    std::vector<TriedConfiguration> tried;  // oldest first

    /// Keeps what a frame of `session` cost; one entry for a configuration, whatever camera and view.
    void note_tried(const Session& session, double steps_per_pixel, const TimeSummary& time, bool counted);
    static constexpr std::size_t most_tried = 200;
};

/// Where sampling goes on. Samples go to two buffers by turns; half the root mean square difference of their means
/// estimates the error of the mean of both (exactly so on average where the buffers are independent).
class Convergence {
  public:
    explicit Convergence(ConvergenceState& state) : state_(state) {}

    void start(Sampler sampler);
    void stop() { state_.active = false; }
    /// The pictures of `now` differ from those of the curves: forgets them. A change of traversal, rules, tracer or
    /// tree begins another curve.
    void follow(const Session& now);
    [[nodiscard]] bool wants_sample() const;
    /// follow(), a curve where none grows, and the camera's offset for the next sample, in pixels.
    [[nodiscard]] glm::dvec2 begin_or_go_on(const Session& session);
    void add(const Image<Vec4>& colour, double ms);
    /// The mean of all samples, which are a power of two.
    [[nodiscard]] Image<glm::dvec3> mean() const;
    [[nodiscard]] bool at_power_of_two() const {
        return state_.samples > 1 && (state_.samples & (state_.samples - 1)) == 0;
    }

  private:
    void begin_curve(const Session& session);
    [[nodiscard]] glm::dvec2 next_offset();

    ConvergenceState& state_;
    std::vector<SampleMean> halves_;
    std::vector<glm::dvec2> offsets_[2];  // of each half, still to be used
    std::uint64_t sets_ = 0;              // of offsets made for the curve that grows
};

}  // namespace kd

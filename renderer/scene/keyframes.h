// Values over time by key frames, as glTF 2.0 has them (appendix C).
#pragma once

#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <vector>

namespace kd {

enum class Interpolation { step, linear, cubic_spline };

/// `width` numbers at each of some ascending, finite times in seconds. Before the first and after the last the nearest
/// key holds.
struct Keyframes {
    Interpolation interpolation = Interpolation::linear;
    std::size_t width = 1;
    std::vector<float> times;   // at least one
    std::vector<float> values;  // width for each time; cubic: in-tangent, value and out-tangent, width each

    /// `width` numbers at a time.
    [[nodiscard]] std::vector<double> at(double seconds) const;

    /// Of unit quaternions (x, y, z, w), `width` 4: linear ones turn at an even speed along the shorter arc. Unit
    /// length; no turn where the keys give none.
    [[nodiscard]] glm::dquat rotation_at(double seconds) const;

  private:
    /// Between which keys a time lies, and what part of the way it has gone.
    struct Place {
        std::size_t before, after;
        double part, interval;  // 0 to 1; seconds
    };
    [[nodiscard]] Place place_of(double seconds) const;
    [[nodiscard]] double value(std::size_t key, std::size_t component) const;
    [[nodiscard]] double spline(const Place& place, std::size_t component) const;
};

}  // namespace kd

#include "renderer/scene/keyframes.h"

#include <algorithm>
#include <cmath>

namespace kd {

namespace {

glm::dquat unit_or_none(const glm::dquat& q) {
    const double length = glm::length(q);
    return length > 0.0 && std::isfinite(length) ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

}  // namespace

Keyframes::Place Keyframes::place_of(double seconds) const {
    const auto later = std::ranges::upper_bound(times, seconds, {}, [](float time) { return double(time); });
    if (later == times.begin()) return {0, 0, 0.0, 0.0};
    const auto after = std::size_t(later - times.begin());
    if (after == times.size()) return {after - 1, after - 1, 0.0, 0.0};
    const double start = double(times[after - 1]), interval = double(times[after]) - start;
    return {after - 1, after, (seconds - start) / interval, interval};
}

double Keyframes::value(std::size_t key, std::size_t component) const {
    const bool cubic = interpolation == Interpolation::cubic_spline;
    return double(values[(cubic ? 3 * key + 1 : key) * width + component]);
}

/// The cubic Hermite spline of glTF 2.0, appendix C.5: tangents are per second.
double Keyframes::spline(const Place& place, std::size_t component) const {
    const double t = place.part, t2 = t * t, t3 = t2 * t;
    const double out_tangent = double(values[(3 * place.before + 2) * width + component]);
    const double in_tangent = double(values[3 * place.after * width + component]);
    return (2 * t3 - 3 * t2 + 1) * value(place.before, component) + place.interval * (t3 - 2 * t2 + t) * out_tangent +
           (-2 * t3 + 3 * t2) * value(place.after, component) + place.interval * (t3 - t2) * in_tangent;
}

std::vector<double> Keyframes::at(double seconds) const {
    const Place place = place_of(seconds);
    std::vector<double> found(width);
    for (std::size_t i = 0; i < width; ++i) {
        if (place.part == 0.0 || interpolation == Interpolation::step)
            found[i] = value(place.before, i);
        else if (interpolation == Interpolation::linear)
            found[i] = (1.0 - place.part) * value(place.before, i) + place.part * value(place.after, i);
        else
            found[i] = spline(place, i);
    }
    return found;
}

glm::dquat Keyframes::rotation_at(double seconds) const {
    const auto key = [&](std::size_t i) {
        return unit_or_none(glm::dquat(value(i, 3), value(i, 0), value(i, 1), value(i, 2)));
    };
    const Place place = place_of(seconds);
    if (place.part == 0.0 || interpolation == Interpolation::step) return key(place.before);
    // GLM's slerp() takes the shorter arc, as appendix C.4 asks.
    if (interpolation == Interpolation::linear)
        return unit_or_none(glm::slerp(key(place.before), key(place.after), place.part));
    const std::vector<double> q = at(seconds);
    return unit_or_none(glm::dquat(q[3], q[0], q[1], q[2]));
}

}  // namespace kd

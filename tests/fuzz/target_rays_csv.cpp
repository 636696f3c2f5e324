#include <bit>
#include <cmath>
#include <cstdint>

#include "renderer/geometry/input_error.h"
#include "renderer/io/tables.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/targets.h"

namespace kd::fuzz {

namespace {

/// Bit for bit, but for what a NaN carries beside being one.
bool same(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool same(Vec3 a, Vec3 b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

bool same(const Ray& a, const Ray& b) {
    return same(a.origin, b.origin) && same(a.direction, b.direction) && same(a.t_min, b.t_min) &&
           same(a.t_max, b.t_max);
}

}  // namespace

void rays_csv(std::string_view bytes) {
    std::vector<Ray> rays;
    try {
        rays = parse_rays_csv(bytes, "rays.csv");
    } catch (const InputError& error) {
        promise_one_line(error.what());
        promise(std::string_view(error.what()).starts_with("rays.csv:"), "errors name the file");
        return;
    }
    const std::vector<Ray> again = parse_rays_csv(kd::rays_csv(rays), "again.csv");
    promise(again.size() == rays.size(), "every ray comes back");
    for (std::size_t i = 0; i < rays.size(); ++i) promise(same(rays[i], again[i]), "rays come back bit for bit");
}

}  // namespace kd::fuzz

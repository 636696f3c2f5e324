// Tables of numbers in and out: rays, counters, raw maps.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/trace/frame.h"

namespace kd {

inline constexpr std::size_t largest_ray_count = 10'000'000;

/// Rays from CSV text with header ox,oy,oz,dx,dy,dz[,tmin,tmax], columns in any order; numbers decimal or hexadecimal
/// floats, independent of locale. tmin is 0 and tmax KD_T_LIMIT where the column is absent, and an infinite tmax is
/// KD_T_LIMIT. Blank lines are passed over. Whether a ray can be traced is for the tracer to say (valid_ray).
/// InputError: "rays.csv:12: column dx: 'abc' is not a number", also for more than largest_ray_count rays.
[[nodiscard]] std::vector<Ray> read_rays_csv(const std::filesystem::path& path);
/// As read_rays_csv, from text at hand. `file` names it in errors.
[[nodiscard]] std::vector<Ray> parse_rays_csv(std::string_view text, const std::string& file);

/// What read_rays_csv reads back bit for bit: all eight columns, hexadecimal floats. `source` is not kept.
[[nodiscard]] std::string rays_csv(std::span<const Ray> rays);

/// C notation, exact: 1.5 is "0x1.8p+0".
[[nodiscard]] std::string hex_float(float value);

/// `value`, and 0 for -0: a barycentric coordinate of -0 means nothing else than 0 and reads like a mistake.
[[nodiscard]] inline float plain_zero(float value) { return value + 0.0f; }

/// One row per pixel, row by row from the top: x, y, then for every pass that ran triangle, t, u, v, every counter and
/// exit_reason, as primary_triangle, ..., reflection_shadow_exit_reason. The primary rays always count as run, the
/// other passes where some pixel traced something. t is in scene units. Floats are the shortest decimals that give the
/// same float back, but for -0, which is 0. `progress` gets the fraction done.
[[nodiscard]] std::string frame_csv(const Frame& frame, const std::function<void(float)>& progress = {});

/// EXR with one 32-bit float channel per counter of the primary rays (exact up to 2^24), exit_reason, and t in scene
/// units (KD_T_LIMIT where nothing was hit). InputError naming path and reason.
void write_frame_exr(const std::filesystem::path& path, const Frame& frame);

}  // namespace kd

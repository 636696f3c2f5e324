// Tables of numbers in and out: rays, counters, raw maps.
#pragma once

#include <filesystem>
#include <vector>

#include "renderer/trace/frame.h"

namespace kd {

/// Rays from CSV text with header ox,oy,oz,dx,dy,dz[,tmin,tmax]; numbers decimal or hexadecimal floats, independent of
/// locale. InputError: file, line, column, reason.
[[nodiscard]] std::vector<Ray> read_rays_csv(const std::filesystem::path& path);

/// One row per pixel: x, y, triangle, t, u, v and every counter of every pass that ran.
[[nodiscard]] std::string frame_csv(const Frame& frame);

/// EXR with one float channel per counter of the primary rays, and t.
void write_frame_exr(const std::filesystem::path& path, const Frame& frame);

} // namespace kd

// The builders themselves, one file each; build.cpp lists them.
#pragma once

#include "renderer/kdtree/build.h"

namespace kd {

[[nodiscard]] KdTree build_paper(const BuildTask& task);
[[nodiscard]] KdTree build_spatial_median(const BuildTask& task);

}  // namespace kd

// The list of builders. A new one is a file of its own, build_NAME.cpp, that defines kd::NAME_builder(), and one line
// here.
#pragma once

#include "renderer/kdtree/build.h"

#define KD_BUILDERS(BUILDER)                                                                                           \
    BUILDER(paper)                                                                                                     \
    BUILDER(paper_cycle)                                                                                               \
    BUILDER(exact)                                                                                                     \
    BUILDER(binned)                                                                                                    \
    BUILDER(spatial_median)                                                                                            \
    BUILDER(object_median)

namespace kd {

#define KD_DECLARE_BUILDER(name) Builder name##_builder();
KD_BUILDERS(KD_DECLARE_BUILDER)
#undef KD_DECLARE_BUILDER

}  // namespace kd

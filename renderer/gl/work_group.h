// How the pixels of a tile are dealt out to the work groups of a compute shader.
#pragma once

#include <string_view>

namespace kd {

struct WorkGroup {
    int x = 8, y = 8;     // pixels; GPUs run 32 neighbours in a row of them side by side
    bool morton = false;  // in Morton order, so that those 32 are a block however wide the group is
    int persistent = 0;   // groups that fetch pixels until none is left (Aila and Laine 2009); 0: a group a block

    bool operator==(const WorkGroup&) const = default;
};

/// "16x8", "16x16,morton", "8x4,persistent:1056". InputError with one line where it is none of these, where a group has
/// more than 1024 pixels (what OpenGL 4.3 promises), or where Morton order does not fill it.
[[nodiscard]] WorkGroup parse_work_group(std::string_view text);

/// What the environment variable KDSCOPE_GROUP says, the default where it is not set.
[[nodiscard]] WorkGroup work_group_in_force();

}  // namespace kd

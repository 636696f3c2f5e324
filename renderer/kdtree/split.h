// A way to split one node.
#pragma once

namespace kd {

/// Bits that say on which sides of a split a triangle stands.
inline constexpr unsigned side_below = 1;
inline constexpr unsigned side_above = 2;

struct Split {
    int axis = 0;
    float position = 0.0f;
    bool planar_below = true;  // triangles lying in the plane go below, else above
    int below = 0;             // triangles below
    int above = 0;             // triangles above
    bool bad = false;          // costs more than it saves; BuildConfig::bad_refines limits these

    /// Counts a triangle whose side bits are given.
    void add(unsigned sides) {
        below += int(sides & side_below);
        above += int(sides >> 1);
    }
};

}  // namespace kd

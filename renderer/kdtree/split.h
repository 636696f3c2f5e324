// A way to split one node.
#pragma once

namespace kd {

struct Split {
    int axis = 0;
    float position = 0.0f;
    bool planar_below = true;  // triangles lying in the plane go below, else above
    int below = 0;             // triangles below
    int above = 0;             // triangles above
    bool bad = false;          // costs more than it saves; BuildConfig::bad_refines limits these
};

}  // namespace kd

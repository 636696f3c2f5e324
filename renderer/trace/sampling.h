// Whether light is sampled, and which samples a frame draws.
#pragma once

namespace kd {

/// Light by one sample of each pixel a frame rather than the paper's one ray towards each light: docs/light.md.
struct Sampling {
    int sample = -1;    // the number of the frame's samples, from 0; -1: none is drawn
    unsigned seed = 0;  // of all that is drawn
    bool soft_shadows = true, gloss = true, indirect = true;  // what is sampled, where the scene has it

    bool operator==(const Sampling&) const = default;
};

}  // namespace kd

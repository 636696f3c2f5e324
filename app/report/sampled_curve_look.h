// How a curve of sampled pictures looks, in the window as on the page of errortime: its colour says the sampler, its
// stroke the traversal, its marks the machine.
#pragma once

#include "renderer/measure/error_time/sampling.h"
#include "renderer/trace/traversal.h"
#include "viz/chart.h"

namespace kd {

[[nodiscard]] inline Ink ink_of(Sampler sampler) {
    switch (sampler) {
        case Sampler::regular: return Ink::green;
        case Sampler::independent: return Ink::red;
        case Sampler::stratified: break;
    }
    return Ink::purple;
}

[[nodiscard]] inline Stroke stroke_of(Traversal traversal) {
    switch (traversal) {
        case Traversal::restart:
        case Traversal::push_down: return Stroke::dashed;
        case Traversal::backtrack:
        case Traversal::ropes: return Stroke::dotted;
        default: return Stroke::solid;
    }
}

[[nodiscard]] inline Marker marker_of_machine(bool cpu) { return cpu ? Marker::circle : Marker::square; }

}  // namespace kd

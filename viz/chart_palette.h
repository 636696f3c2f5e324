// The colours of charts: one for each ink, the same in the window and in files.
#pragma once

#include "renderer/geometry/image.h"
#include "viz/chart.h"

namespace kd {

/// What a chart is drawn on.
enum class Ground { white, dark };

/// Okabe and Ito's colours and a grey, which people with any colour vision tell apart. `reference` is the ink of texts,
/// so it depends on the ground.
[[nodiscard]] constexpr Rgba8 colour_of(Ink ink, Ground ground) {
    switch (ink) {
        case Ink::cpu: return {86, 180, 233};
        case Ink::gpu: return {230, 159, 0};
        case Ink::green: return {0, 158, 115};
        case Ink::red: return {213, 94, 0};
        case Ink::purple: return {204, 121, 167};
        case Ink::blue: return {0, 114, 178};
        case Ink::grey: return {110, 110, 110};
        case Ink::reference: break;
    }
    return ground == Ground::white ? Rgba8{34, 34, 34} : Rgba8{232, 232, 234};
}

}  // namespace kd

#include "app/error_time/error_time_chart_parts.h"

#include <algorithm>

#include "app/choices.h"
#include "app/report/sampled_curve_look.h"
#include "renderer/measure/error_time/ranking.h"

namespace kd {

Stroke stroke_of(const std::string& traversal) {
    const auto found = std::ranges::find(traversals(), traversal, &TraversalInfo::name);
    return found == traversals().end() ? Stroke::solid : stroke_of(found->id);
}

bool is_cpu(const std::string& machine) { return machine.starts_with(name_of(TracerKind::cpu)); }

void mark_front(Chart& chart) {
    mark_front(
        chart.curves,
        [](const ChartPoint& point) {
            return TimeAndError{point.x, point.y};
        },
        &ChartPoint::marked);
}

}  // namespace kd

#include "renderer/measure/compare.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

#include "renderer/trace/counters.h"

namespace kd {

namespace {

bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

void fail(VerifyRow& row, const std::string& text) {
    if (row.first_failure.empty()) row.first_failure = text;
}

std::string counters_text(const RayCounters& c) {
    std::string text;
    for (const CounterInfo& counter : counter_table()) text += fmt::format("{} {}, ", counter.name, c.*counter.field);
    return text + fmt::format("exit {}", exit_reason_name(c.exit_reason));
}

template <class AnyHit>
std::string exact_text_of(const AnyHit& hit) {
    if (hit.triangle < 0) return "no hit";
    return fmt::format("triangle {} t {:a} u {:a} v {:a}", hit.triangle, hit.t, hit.u, hit.v);
}

}  // namespace

ReferenceRays ReferenceRays::every(std::size_t step) const {
    ReferenceRays picked;
    for (std::size_t i = 0; i < rays.size(); i += step) {
        picked.rays.push_back(rays[i]);
        picked.expected.push_back(expected[i]);
    }
    return picked;
}

void compare_hits(const FlatScene& scene, const ReferenceRays& reference, const RayAnswers& found, VerifyRow& row) {
    for (std::size_t i = 0; i < reference.rays.size(); ++i) {
        const Hit& expected = reference.expected[i];
        const Hit& hit = found.nearest[i];
        const bool same_t = same_bits(expected.t, hit.t);
        const bool same_hit = (expected.triangle >= 0) == (hit.triangle >= 0);
        if (same_hit && same_t && expected.triangle != hit.triangle)
            ++row.ties;
        else if (!bit_equal(expected, hit)) {
            ++row.mismatches;
            fail(row, fmt::format("ray {}: expected {}; found {}", exact_text(scene, reference.rays[i]),
                                  exact_text(scene, expected), exact_text(scene, hit)));
        } else if ((expected.triangle >= 0) != (found.any[i].triangle >= 0)) {
            ++row.mismatches;
            fail(row, fmt::format("ray {}: nearest hit {}; any hit found {}", exact_text(scene, reference.rays[i]),
                                  exact_text(scene, expected), exact_text(scene, found.any[i])));
        }
    }
}

void compare_counters(const FlatScene& scene, const ReferenceRays& reference, const RayAnswers& expected,
                      const RayAnswers& found, VerifyRow& row) {
    std::int64_t& mismatches = row.counter_mismatches.emplace(row.counter_mismatches.value_or(0));
    for (std::size_t i = 0; i < reference.rays.size(); ++i) {
        if (expected.counters[i] == found.counters[i]) continue;
        ++mismatches;
        fail(row, fmt::format("ray {}: cpu counts {}; {} counts {}", exact_text(scene, reference.rays[i]),
                              counters_text(expected.counters[i]), row.tracer, counters_text(found.counters[i])));
    }
}

std::string exact_text(const Ray& ray) {
    const auto& [o, d, t_min, t_max, source] = ray;
    return fmt::format("{:a},{:a},{:a},{:a},{:a},{:a},{:a},{:a}", o.x, o.y, o.z, d.x, d.y, d.z, t_min, t_max) +
           (source >= 0 ? fmt::format(" (source {})", source) : "");
}

std::string exact_text(const Hit& hit) { return exact_text_of(hit); }

std::string exact_text(const f64::Hit& hit) { return exact_text_of(hit); }

}  // namespace kd

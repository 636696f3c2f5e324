#include "renderer/measure/walk_table.h"

#include <fmt/format.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/ray_count.h"

namespace kd {

std::vector<WalkVariant> walk_variants(const TraceConfig& base) {
    std::vector<WalkVariant> variants;
    const auto add = [&](std::string name, Traversal traversal, std::string published) -> TraceConfig& {
        variants.push_back({std::move(name), base, std::move(published)});
        variants.back().config.entry_tile = 0;
        variants.back().config.eye_leaf = false;
        variants.back().config.traversal = traversal;
        return variants.back().config;
    };
    add("stack", Traversal::stack, "");
    add("stack, entry points of 8x8 tiles", Traversal::stack, "").entry_tile = 8;
    add("kd-restart", Traversal::restart, "1.77 - 3.33 (Popov), 4 - 5 (the paper)");
    add("push-down", Traversal::push_down, "");
    for (const int entries : {1, 2, 4, max_short_stack})
        add(fmt::format("short stack, {} entr{}", entries, entries == 1 ? "y" : "ies"), Traversal::short_stack,
            entries == 4 ? "below 1.03 (Horn)" : "")
            .short_stack = entries;
    add("kd-backtrack", Traversal::backtrack, "");
    add("ropes, plain", Traversal::ropes, "1.00 - 1.01 (Popov)").optimised_ropes = false;
    add("ropes, optimised", Traversal::ropes, "").optimised_ropes = true;
    TraceConfig& plain = add("ropes, plain, from the eye's leaf", Traversal::ropes, "0.66 - 1.01 (Popov)");
    plain.optimised_ropes = false;
    plain.eye_leaf = true;
    TraceConfig& best = add("ropes, optimised, from the eye's leaf", Traversal::ropes, "0.36 - 0.86 (Popov)");
    best.optimised_ropes = best.eye_leaf = true;
    return variants;
}

std::uint64_t WalkRow::interior(Pass rays) const {
    const CounterTotals& t = totals[std::size_t(rays)];
    return t.interior_first + t.interior_again;
}

double WalkRow::of(const WalkRow& stack, Pass rays) const {
    return stack.interior(rays) > 0 ? double(interior(rays)) / double(stack.interior(rays)) : 0;
}

std::vector<WalkRow> walk_table(const WalkTableTask& task, std::stop_token stop) {
    std::vector<WalkRow> rows;
    CpuTracer tracer(task.scene, task.tree);
    Frame frame(task.width, task.height);
    for (WalkVariant& variant : walk_variants(task.config)) {
        variant.config.counters = true;
        tracer.trace_frame(variant.config, task.camera, frame, task.threads, stop);
        if (stop.stop_requested()) break;
        rows.push_back({std::move(variant), pass_totals(frame)});
    }
    return rows;
}

}  // namespace kd

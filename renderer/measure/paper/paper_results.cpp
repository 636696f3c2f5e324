#include "renderer/measure/paper/paper_results.h"

#include <algorithm>

namespace kd {

std::span<const PaperMethodInfo> paper_methods() {
    static constexpr std::array<PaperMethodInfo, paper_method_count> table{{
        {PaperMethod::cpurt, "CPURT", "CPU, stack", Traversal::stack, false, true},
        {PaperMethod::cpu_restart, "CPU Kd-restart", "CPU, kd-restart", Traversal::restart, false, true},
        {PaperMethod::gpurt, "GPURT", "GPU, kd-restart, four passes", Traversal::restart, true, true},
        {PaperMethod::cpu_backtrack, "CPU Kd-backtrack", "CPU, kd-backtrack", Traversal::backtrack, false, false},
        {PaperMethod::gpu_stack, "GPU stack", "GPU, stack, four passes", Traversal::stack, true, false},
        {PaperMethod::naive, "CPU naive", "CPU, every triangle", Traversal::naive, false, false},
    }};
    return table;
}

const PaperMethodInfo& info(PaperMethod method) { return paper_methods()[static_cast<std::size_t>(method)]; }

std::span<const PaperSceneInfo> paper_scenes() {
    static constexpr std::array<PaperSceneInfo, 7> table{{
        {"ball:1000", "4.1", "open box and a ball of 1000 triangles", true},
        {"ball:4000", "4.1", "the same with 4000", true},
        {"ball:9000", "4.1", "the same with 9000", true},
        {"ball:81000", "4.1", "the same with 81 000, beyond the paper's sizes", false},
        {"rooms", "4.2", "25 rooms with a box each, of which one is seen", true},
        {"scatter:10000", "4.3", "small triangles scattered in a box", true},
        {"sheet:10000", "4.3", "a wavy sheet of small triangles", true},
    }};
    return table;
}

const PaperCounts* PaperScene::counts_of(Traversal traversal) const {
    const auto found = std::ranges::find(counts, traversal, &PaperCounts::traversal);
    return found == counts.end() ? nullptr : &*found;
}

const PaperTimes* PaperScene::times_of(PaperMethod method) const {
    const auto found = std::ranges::find(times, method, &PaperTimes::method);
    return found == times.end() ? nullptr : &*found;
}

std::vector<double> PaperScene::ms(PaperMethod method) const {
    const PaperTimes* found = times_of(method);
    return found ? found->timed.ms() : std::vector<double>{};
}

double PaperScene::node_ratio(Traversal traversal) const {
    const PaperCounts* own = counts_of(traversal);
    const PaperCounts* stack = counts_of(Traversal::stack);
    return own && stack && stack->interior() > 0 ? double(own->interior()) / double(stack->interior()) : 0;
}

const PaperScene* PaperResults::scene(std::string_view name) const {
    const auto found = std::ranges::find(scenes, name, &PaperScene::name);
    return found == scenes.end() ? nullptr : &*found;
}

bool PaperResults::has_gpu_times() const {
    return std::ranges::any_of(scenes, [](const PaperScene& s) { return s.times_of(PaperMethod::gpurt) != nullptr; });
}

std::vector<double> PaperTriangleTests::traversal_shares() const {
    std::vector<double> shares;
    for (std::size_t i = 0; i < std::min(once.rounds.size(), twice.rounds.size()); ++i)
        if (once.rounds[i].ms > 0) shares.push_back(2 - twice.rounds[i].ms / once.rounds[i].ms);
    return shares;
}

}  // namespace kd

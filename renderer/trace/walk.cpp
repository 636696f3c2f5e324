#include "renderer/trace/walk.h"

namespace kd {

void Walk::add(StepKind kind, std::uint32_t address) {
    if (!runs_.empty() && runs_.back().kind == kind && runs_.back().address + runs_.back().count == address)
        ++runs_.back().count;
    else
        runs_.push_back({address, 1, kind});
}

void Walk::append(const Walk& next) { runs_.insert(runs_.end(), next.runs_.begin(), next.runs_.end()); }

std::uint64_t Walk::steps() const {
    std::uint64_t sum = 0;
    for (const StepRun& run : runs_) sum += run.count;
    return sum;
}

std::uint64_t Walk::interior_steps() const {
    std::uint64_t sum = 0;
    for (const StepRun& run : runs_) sum += run.kind == StepKind::interior ? run.count : 0;
    return sum;
}

std::vector<int> Walk::leaves() const {
    std::vector<int> nodes;
    for (const StepRun& run : runs_)
        for (std::uint32_t i = 0; i < run.count && run.kind == StepKind::leaf; ++i)
            nodes.push_back(int(run.address + i));
    return nodes;
}

std::vector<std::uint32_t> Walk::phases() const {
    std::vector<std::uint32_t> lengths;
    for (const StepRun& run : runs_) {
        const bool interior = run.kind == StepKind::interior;
        // Phases at even places are interior ones.
        if (lengths.empty() || (lengths.size() % 2 == 1) != interior) {
            if (lengths.empty() && !interior) lengths.push_back(0);
            lengths.push_back(0);
        }
        lengths.back() += run.count;
    }
    return lengths;
}

std::uint64_t PixelWalks::steps() const {
    std::uint64_t sum = 0;
    for (const RayWalk& ray : rays) sum += ray.walk.steps();
    return sum;
}

std::uint64_t PixelWalks::interior_steps() const {
    std::uint64_t sum = 0;
    for (const RayWalk& ray : rays) sum += ray.walk.interior_steps();
    return sum;
}

}  // namespace kd

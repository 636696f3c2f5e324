#include "renderer/measure/needs_check.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

bool same_bits(const Vec4& a, const Vec4& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// A feature to put back, or all of them.
struct Trial {
    std::string name;
    FeatureSet forced;
};

std::vector<Trial> trials(const SceneFacts& facts, const TraceConfig& config, bool on_cpu) {
    std::vector<Trial> list;
    Trial all{"all", {}};
    for (const Feature feature : removable(facts, config, on_cpu)) {
        list.push_back({std::string(info(feature).name), feature});
        all.forced.set(feature, true);
    }
    if (list.size() > 1) list.push_back(all);
    return list;
}

class Check {
  public:
    Check(const FlatScene& scene, const KdTree& tree, const NeedsCheckConfig& config,
          const std::function<void(float, const std::string&)>& progress, std::stop_token stop)
        : scene_(scene), tree_(tree), config_(config), facts_(scene_facts(scene, tree)), progress_(progress),
          stop_(std::move(stop)) {}

    NeedsCheckReport run() {
        const auto machines = open_machines(config_, "checked", report_.notes);
        parts_ = machines.size() * config_.traversals.size();
        for (const auto& machine : machines)
            for (const Traversal traversal : config_.traversals) {
                check(*machine, traversal);
                ++done_;
            }
        report_.complete = !stop_.stop_requested();
        return std::move(report_);
    }

  private:
    void check(RayMachine& machine, Traversal traversal) {
        const std::string walk(info(traversal).name);
        TraceConfig trace = config_.trace;
        trace.traversal = traversal;
        trace.counters = true;
        trace.forced = {};
        const PinholeCamera camera = pinhole(scene_.camera, config_.width, config_.height);
        const auto frame = [&](FeatureSet forced) {
            trace.forced = forced;
            return machine.frame(trace, camera, config_.width, config_.height, stop_);
        };
        try {
            machine.load(scene_, tree_);
            const Frame without = frame({});
            const std::vector<Trial> list = trials(facts_, trace, machine.on_cpu());
            for (std::size_t i = 0; i < list.size() && !stop_.stop_requested(); ++i) {
                tell(float(i) / float(list.size()), fmt::format("{} on {}, {}", walk, machine.tracer(), list[i].name));
                NeedsCheckRow row = compare_frames(without, frame(list[i].forced));
                row.tracer = machine.tracer();
                row.context = machine.context();
                row.traversal = walk;
                row.feature = list[i].name;
                if (!stop_.stop_requested()) report_.rows.push_back(std::move(row));
            }
        } catch (const InputError& error) {
            report_.notes.push_back(
                fmt::format("{} on {} {} not checked: {}", walk, machine.tracer(), machine.context(), error.what()));
        }
    }

    void tell(float part, const std::string& what) const {
        if (progress_) progress_((float(done_) + part) / float(parts_), what);
    }

    const FlatScene& scene_;
    const KdTree& tree_;
    const NeedsCheckConfig& config_;
    SceneFacts facts_;
    const std::function<void(float, const std::string&)>& progress_;
    std::stop_token stop_;
    NeedsCheckReport report_;
    std::size_t done_ = 0, parts_ = 1;
};

}  // namespace

bool NeedsCheckReport::passed() const {
    return complete && !rows.empty() && std::ranges::all_of(rows, &NeedsCheckRow::good);
}

NeedsCheckRow compare_frames(const Frame& without, const Frame& with) {
    NeedsCheckRow row;
    row.pixels = std::int64_t(without.colour.pixels.size());
    const auto differ = [&](std::size_t pass, std::size_t i) {
        const RayLayer& a = without.layers[pass];
        const RayLayer& b = with.layers[pass];
        if (!without.holds(Pass(pass)) || !with.holds(Pass(pass))) return std::pair(false, false);
        return std::pair(!bit_equal(a.hit.pixels[i], b.hit.pixels[i]), !(a.counters.pixels[i] == b.counters.pixels[i]));
    };
    for (std::size_t i = 0; i < without.colour.pixels.size(); ++i) {
        row.colours += !same_bits(without.colour.pixels[i], with.colour.pixels[i]);
        const auto [hit, counters] = differ(0, i);
        row.hits += hit;
        row.counters += counters;
        for (std::size_t pass = 1; pass < pass_count; ++pass) {
            const auto [other_hit, other_counters] = differ(pass, i);
            row.others[pass] += other_hit || other_counters;
        }
    }
    return row;
}

NeedsCheckReport check_needs(const FlatScene& scene, const KdTree& tree, const NeedsCheckConfig& config,
                             const std::function<void(float, const std::string&)>& progress, std::stop_token stop) {
    return Check(scene, tree, config, progress, std::move(stop)).run();
}

}  // namespace kd

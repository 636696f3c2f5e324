#include "app/report/peers_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "renderer/cpu/cpu_tracer.h"

namespace kd {

namespace {

Json json_of(const PeersScene& peers, const RayBenchRow& row) {
    const TimeSummary time = row.timed.total();
    const bool own = !row.is_peer();
    const PeersTree tree = own ? peers.trees.at(row.tree) : PeersTree{};
    Json speeds = Json::object();
    for (const SpeedOfPeer& of : speeds_of_peers(peers.result, row)) speeds[of.peer] = kd::json_of(of.speed);
    Json json{{"scene", peers.session.scene},
              {"tracer", row.tracer},
              {"ray_type", ray_type_names[std::size_t(row.type)]},
              {"traversal", own ? Json(info(Traversal::stack).name) : Json(nullptr)},
              {"packet", row.packet},
              {"tree", own ? Json(row.tree) : Json(nullptr)},
              {"nodes", own ? Json(bytes_of(tree.nodes)) : Json(nullptr)},
              {"build", own ? kd::json_of(tree.build) : Json(nullptr)},
              {"build_ms", own ? Json(tree.build_ms) : Json(nullptr)},
              {"threads", row.threads},
              {"width", peers.session.width},
              {"height", peers.session.height},
              {"rays", row.rays},
              {"hits", row.hits},
              {"differ", row.spin ? Json(nullptr) : Json(row.differ)},
              {"ms_median", time.median_ms},
              {"ms_p25", time.p25_ms},
              {"ms_p75", time.p75_ms},
              {"rounds", time.samples},
              {"mrays_per_s", row.spin ? Json(nullptr) : Json(row.mrays_per_s())},
              {"speed_of", speeds},
              {"gain", row.gain ? kd::json_of(*row.gain) : Json(nullptr)},
              {"gain_of_spin", row.gain_of_spin ? kd::json_of(*row.gain_of_spin) : Json(nullptr)},
              {"clock", "steady clock"},
              {"instructions", own ? Json(cpu_target_name()) : Json(nullptr)},
              {"peers", peers.peers},
              {"measured_on", kd::json_of(peers.on)}};
    return json;
}

/// The speed over the robust or the default peer, with its interval; empty for that peer itself.
std::string speed_text(const std::vector<SpeedOfPeer>& speeds, bool robust) {
    const auto found =
        std::ranges::find(speeds, robust, [](const SpeedOfPeer& of) { return of.peer.ends_with("-robust"); });
    return found == speeds.end() ? "" : interval_text(found->speed);
}

/// "1.91 (1.90 – 1.93), 0.96 of a spin loop's".
std::string gain_text(const RayBenchRow& row) {
    if (!row.gain || !row.gain_of_spin) return "";
    return fmt::format("{}, {} of a spin loop's", interval_text(*row.gain), short_number(row.gain_of_spin->median));
}

void print_table(std::ostream& out, const PeersScene& peers, RayType type) {
    using enum TextTable::Align;
    const bool threads = !peers.result.spins.empty();
    std::vector<TextTable::Column> columns{{"tracer", left}, {"tree", left}, {"ms"},    {"p25"},
                                           {"p75"},          {"Mray/s"},     {"differ"}};
    columns.push_back({"of robust", left});
    columns.push_back({"of default", left});
    if (threads) {
        columns.insert(columns.begin() + 2, {"threads"});
        columns.push_back({"gain", left, true});
    }
    TextTable table(std::move(columns));
    for (const RayBenchRow& row : peers.result.rows) {
        if (row.type != type) continue;
        const TimeSummary time = row.timed.total();
        const std::vector<SpeedOfPeer> of = speeds_of_peers(peers.result, row);
        const bool own = !row.is_peer();
        std::vector<std::string> cells{own && row.packet > 1 ? fmt::format("{} {}", row.tracer, row.packet)
                                                             : row.tracer,
                                       own ? row.tree == row.tracer ? "suited" : row.tree : "",
                                       short_number(time.median_ms),
                                       short_number(time.p25_ms),
                                       short_number(time.p75_ms),
                                       short_number(row.mrays_per_s()),
                                       fmt::format("{}", row.differ),
                                       speed_text(of, true),
                                       speed_text(of, false)};
        if (threads) {
            cells.insert(cells.begin() + 2, fmt::format("{}", row.threads));
            cells.push_back(gain_text(row));
        }
        table.add_row(std::move(cells));
    }
    table.print(out, terminal_width());
}

/// One line, with the constants that times hang on.
std::string tree_text(const std::string& name, const PeersTree& tree) {
    const BuildConfig& build = tree.build;
    return fmt::format(
        "tree {}: {}, t_t {}, t_i {}, empty bonus {} from {} on, empty cut {}, leaf {}, blocks of {}, bad refines {}, "
        "nodes of {} bytes, {:.1f} ms\n",
        name, build.builder, build.traversal_cost, build.intersection_cost, build.empty_bonus, build.empty_bonus_gate,
        build.empty_cut, build.leaf_size, build.leaf_block, build.bad_refines, bytes_of(tree.nodes), tree.build_ms);
}

}  // namespace

std::vector<SpeedOfPeer> speeds_of_peers(const RayBench& bench, const RayBenchRow& row) {
    std::vector<SpeedOfPeer> speeds;
    if (row.spin) return speeds;
    const std::string rival = row.packet > 1 ? "embree-16" : "embree-1";
    for (const std::string& name : {rival + "-robust", rival})
        if (const RayBenchRow* peer = bench.find(row, name); peer && peer != &row)
            speeds.push_back({name, ratio_interval(peer->timed.ms(), row.timed.ms())});
    return speeds;
}

Json peers_json(const PeersScene& peers) {
    Json rows = Json::array();
    for (const auto* list : {&peers.result.rows, &peers.result.spins})
        for (const RayBenchRow& row : *list) rows.push_back(json_of(peers, row));
    return rows;
}

void print(std::ostream& out, const PeersScene& peers, int warmup) {
    const Session& s = peers.session;
    out << fmt::format("{}: {}, {}, {}, {}\n", s.scene, counted(peers.scene.triangles.size(), "triangle"), peers.on.cpu,
                       cpu_target_name(), peers.peers);
    for (const auto& [name, tree] : peers.trees) out << tree_text(name, tree);
    std::size_t rounds = 0;
    for (std::size_t type = 0; type < ray_type_names.size(); ++type) {
        const auto row = std::ranges::find(peers.result.rows, RayType(type), &RayBenchRow::type);
        if (row == peers.result.rows.end()) continue;
        rounds = row->timed.rounds.size();
        out << fmt::format("\n{} rays: {}, {}, {} hit\n", ray_type_names[type], row->rays,
                           RayType(type) == RayType::shadow ? "any hit" : "nearest hit", row->hits);
        print_table(out, peers, RayType(type));
    }
    for (const RayBenchRow& spin : peers.result.spins)
        out << fmt::format("a spin loop gains {} from {} threads beside {} rays\n", ratio_text(*spin.gain),
                           spin.threads, ray_type_names[std::size_t(spin.type)]);
    out << fmt::format(
        "\n{} in turn after {} warm-up. ms: median; p25 to p75: their middle half; differ: rays that are\n"
        "answered otherwise than by {}; of robust, of default: speed over the peer's, with\n"
        "single rays or with packets of 16, and in brackets {}.\n",
        counted(rounds, "round"), warmup, reference_peer,
        rounds < MedianInterval::least_samples
            ? fmt::format("its range, as a 95 % interval takes {}", counted(MedianInterval::least_samples, "round"))
            : "its 95 % interval");
}

}  // namespace kd

// What bench --peers found: a table for people, rows of JSON for scripts.
#pragma once

#include <iosfwd>
#include <map>
#include <string>

#include "app/report/json_values.h"
#include "app/session.h"
#include "renderer/measure/measured_on.h"
#include "renderer/measure/ray_bench.h"

namespace kd {

/// One of kdscope's trees, and how its nodes are kept.
struct PeersTree {
    BuildConfig build;
    NodeEncoding nodes = NodeEncoding::float4;
    double build_ms = 0;
};

struct PeersScene {
    Session session;
    FlatScene scene;
    std::string peers;                       // "Embree 3.13.5"
    std::map<std::string, PeersTree> trees;  // by name: "asked", and those that suit a tracer, by its name
    RayBench result;
    MeasuredOn on;
};

/// A row's speed over that of a peer with rays like its own: single or in packets.
struct SpeedOfPeer {
    std::string peer;
    MedianInterval speed;
};

/// Over the robust peer and the default one; none of peers that were not measured.
[[nodiscard]] std::vector<SpeedOfPeer> speeds_of_peers(const RayBench& bench, const RayBenchRow& row);

/// An array; what a spin loop gains from threads is in rows of a tracer "spin".
[[nodiscard]] Json peers_json(const PeersScene& peers);

void print(std::ostream& out, const PeersScene& peers, int warmup);

}  // namespace kd

// bench --peers: kdscope's CPU tracers against other ray tracers, on the same rays.
#pragma once

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/report/json_values.h"
#include "renderer/measure/timing.h"

namespace kd {

struct PeerBenchOptions {
    TimingPlan timing;
    int threads = 1;
    bool json = false;
};

/// InputError where this program was built without peers, or a tracer of OpenGL is asked for.
void check_peers(const CommonOptions& options);

/// Times one scene and prints the table, or adds its rows to `json`. False where kdscope's tracers do not agree.
[[nodiscard]] bool bench_peers(const CommonOptions& options, const PeerBenchOptions& how, const std::string& scene,
                               Json& json, CommandContext& context);

}  // namespace kd

// bench --dynamic: frames of a moving scene by schedule and by way to rebuild the tree.
#pragma once

#include <optional>
#include <string>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "renderer/measure/motion/frame_pipeline.h"

namespace kd {

struct DynamicBenchOptions {
    int frames = 60, rounds = 6, warmup = 3;
    double step_seconds = 1.0 / 30;
    std::optional<FrameSchedule> schedule;  // all where absent
    std::optional<std::string> way;         // to rebuild; all where absent
    std::optional<int> build_threads;       // as --threads where absent
    std::string svg;
    bool json = false;
};

void add_dynamic_options(CLI::App& app, DynamicBenchOptions& options);

/// Times each scene and prints it. exit_check_failed where the first frame does not repeat.
[[nodiscard]] int bench_dynamic(const CLI::App& app, const CommonOptions& options, const DynamicBenchOptions& how,
                                CommandContext& context);

}  // namespace kd

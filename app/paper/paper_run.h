// The paper's experiments, made again: scenes, counts, limited loops, node sizes, and times in turn.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "app/session.h"
#include "renderer/gl/context.h"
#include "renderer/measure/paper/paper_results.h"

namespace kd {

struct PaperConfig {
    Session base;  // size, seed, tree, rules, threads and early z of every measurement; its scene is not used
    ContextKind context = ContextKind::automatic;
    bool gpu = true;
    bool quick = false;
    double budget_s = 300;  // of the timed rounds
    /// Of the whole run, from the first count to the last of the rounds that follow while a claim that must be decided
    /// is open; none: these end with the budget.
    std::optional<double> longest_s = 480;
    int warmup = 1;
    int most_rounds = 31;
};

/// 512x512, one CPU thread as in 2006, five minutes of rounds, or 31, and more up to eight minutes in all where these
/// do not decide; `quick`: 128x128 and twenty seconds.
[[nodiscard]] PaperConfig paper_config(bool quick);

/// 0..1, what is being done, and all that was found so far.
using PaperProgress = std::function<void(float, const std::string&, const PaperResults&)>;

/// Ends early, incomplete, where stopped. InputError, ContextError (only where `context` names one that is not there).
[[nodiscard]] PaperResults run_paper(const PaperConfig& config, const PaperProgress& progress,
                                     const std::stop_token& stop = {});

}  // namespace kd

// The paper's figures redrawn from our measurements, with what it claims beside them. Page and window draw the same.
#pragma once

#include <string>
#include <vector>

#include "renderer/measure/paper/paper_results.h"
#include "viz/chart.h"

namespace kd {

struct PaperFigure {
    std::string name;   // of its files: "figure-9"
    std::string title;  // short, for lists
    std::string shows;  // one or two sentences: what to look for
    Chart chart;
    std::vector<std::string> scenes;  // that the places on its x axis stand for, from 0; empty where they are none
};

/// Those that have something to show so far, in the paper's order, then what it takes to understand them.
[[nodiscard]] std::vector<PaperFigure> paper_figures(const PaperResults& results);

}  // namespace kd

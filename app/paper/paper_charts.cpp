#include "app/paper/paper_charts.h"

#include "app/paper/paper_chart_parts.h"

namespace kd {

std::vector<PaperFigure> paper_figures(const PaperResults& results) {
    using namespace paper;
    std::vector<PaperFigure> figures;
    if (results.scenes.empty()) return figures;
    if (results.rounds > 0)
        for (const auto& make : {figure_9, figure_11, figure_12}) figures.push_back(make(results));
    figures.push_back(figure_13(results));
    figures.push_back(restart_cost(results));
    figures.push_back(divergence(results));
    if (!results.triangle_tests.empty()) figures.push_back(traversal_share(results));
    if (!results.budgets.empty()) figures.push_back(loop_ceiling(results));
    if (results.has_gpu_times() && results.rounds > 0) figures.push_back(passes(results));
    return figures;
}

}  // namespace kd

#include "renderer/measure/paper/paper_growth.h"

#include <algorithm>
#include <array>
#include <limits>

namespace kd {

namespace {

/// Nine times as many triangles each, so that a logarithm grows as much from the second to the third as before. The
/// paper's own sizes end where its times differ too little to tell a logarithm from a root.
constexpr std::array<const char*, 3> wide_sizes{"ball:1000", "ball:9000", "ball:81000"};

/// The interval of b/a over the rounds, whatever it is in those where `a` is not above 0.
MedianInterval ratio_over(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> known, least, most;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool grows = a[i] > 0;
        if (grows) known.push_back(b[i] / a[i]);
        least.push_back(grows ? b[i] / a[i] : std::numeric_limits<double>::lowest());
        most.push_back(grows ? b[i] / a[i] : std::numeric_limits<double>::max());
    }
    MedianInterval result = median_interval(std::move(least));
    result.high = median_interval(std::move(most)).high;
    result.median = median_interval(std::move(known)).median;
    return result;
}

}  // namespace

Growth growth(const PaperResults& results, PaperMethod method) {
    std::array<std::vector<double>, 3> ms;
    for (std::size_t i = 0; i < ms.size(); ++i)
        if (const PaperScene* scene = results.scene(wide_sizes[i])) ms[i] = scene->ms(method);
    std::vector<double> first, second;
    for (std::size_t i = 0; i < std::min({ms[0].size(), ms[1].size(), ms[2].size()}); ++i) {
        first.push_back(ms[1][i] - ms[0][i]);
        second.push_back(ms[2][i] - ms[1][i]);
    }
    Growth growth{median_interval(first), {}};
    if (growth.first_ms.low > 0) growth.ratio = ratio_over(first, second);
    return growth;
}

double growth_of(const PaperResults& results, double (*f)(double)) {
    std::array<double, 3> n{1000, 9000, 81000};
    for (std::size_t i = 0; i < n.size(); ++i)
        if (const PaperScene* scene = results.scene(wide_sizes[i])) n[i] = double(scene->triangles);
    return (f(n[2]) - f(n[1])) / (f(n[1]) - f(n[0]));
}

}  // namespace kd

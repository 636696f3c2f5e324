#include "app/error_time/report_names.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <functional>
#include <tuple>

#include "app/cli/output_file.h"

namespace kd {

namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

/// Whether files of the longer stem may be called as those of the shorter: what reports add to a stem begins with "-"
/// and a letter.
bool may_meet(const std::string& a, const std::string& b) {
    const auto& [shorter, longer] = a.size() < b.size() ? std::tie(a, b) : std::tie(b, a);
    if (!longer.starts_with(shorter)) return false;
    const std::string rest = longer.substr(shorter.size());
    return rest.empty() || (rest.size() > 1 && rest[0] == '-' && !std::isdigit(static_cast<unsigned char>(rest[1])));
}

/// The first of `name(1)`, `name(2)`, ... that `taken` does not refuse.
std::string first_free(const std::function<std::string(int)>& name,
                       const std::function<bool(const std::string&)>& taken) {
    for (int n = 1;; ++n)
        if (std::string candidate = name(n); !taken(candidate)) return candidate;
}

}  // namespace

std::vector<ReportName> report_names(const std::vector<std::string>& scenes) {
    std::vector<ReportName> names;
    for (const std::string& scene : scenes) {
        const std::string stem = file_stem(scene);
        ReportName name;
        name.shown = first_free([&](int n) { return n == 1 ? scene : fmt::format("{} ({})", scene, n); },
                                [&](const std::string& candidate) {
                                    return std::ranges::find(names, candidate, &ReportName::shown) != names.end();
                                });
        // The number stands in front: behind, it would still begin as the other stem does.
        name.stem = first_free([&](int n) { return n == 1 ? stem : fmt::format("{}-{}", n, stem); },
                               [&](const std::string& candidate) {
                                   return std::ranges::any_of(names, [&](const ReportName& other) {
                                       return may_meet(lower(candidate), lower(other.stem));
                                   });
                               });
        names.push_back(std::move(name));
    }
    return names;
}

}  // namespace kd

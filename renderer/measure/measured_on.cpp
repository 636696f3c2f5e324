#include "renderer/measure/measured_on.h"

#include <fmt/format.h>

namespace kd {

std::vector<std::pair<std::string, std::string>> MeasuredOn::facts() const {
    const std::string gl = renderer.empty() ? "none" : renderer + (software_gl ? " (software, not a GPU)" : "");
    std::vector<std::pair<std::string, std::string>> all{{"date", date},
                                                         {"cpu", cpu},
                                                         {"instructions", instructions},
                                                         {"cpu_threads", fmt::format("{}", threads)},
                                                         {"load", load < 0 ? "unknown" : fmt::format("{:.2f}", load)},
                                                         {"renderer", gl},
                                                         {"driver", driver},
                                                         {"gl_threads", gl_threads},
                                                         {"gl_clock", gl_clock},
                                                         {"cpu_clock", "steady clock"},
                                                         {"version", version},
                                                         {"commit", commit},
                                                         {"compiler", compiler},
                                                         {"flags", flags},
                                                         {"build_type", build_type},
                                                         {"seed", fmt::format("{}", seed)}};
    if (!gl_groups.empty()) all.emplace_back("gl_groups", gl_groups);
    if (!settings.empty()) all.emplace_back("settings", settings);
    return all;
}

std::vector<std::string> MeasuredOn::lines() const {
    std::vector<std::string> lines;
    for (const auto& [name, value] : facts()) lines.push_back(name + ": " + value);
    return lines;
}

}  // namespace kd

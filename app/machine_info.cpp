#include "app/machine_info.h"

#include <fmt/format.h>
#include <fstream>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/io/printable.h"

namespace kd {

std::string cpu_model() {
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line)) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return printable(line.substr(colon + 2));
    }
    return "unknown CPU";
}

std::string cpu_renderer(int threads) {
    const int used = threads > 0 ? threads : default_threads();
    return fmt::format("{}, {}, {} thread{}", cpu_model(), cpu_target_name(), used, used == 1 ? "" : "s");
}

}  // namespace kd

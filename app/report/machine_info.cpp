#include "app/report/machine_info.h"

#include <cstdlib>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <thread>
#include <unistd.h>
#include <version.h>

#include "app/frame/frame_tracer.h"
#include "app/report/json_values.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/threads.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"
#include "renderer/trace/frame.h"

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

MeasuredOn measured_on(int threads, unsigned seed, const FrameTracer* gl) {
    MeasuredOn on;
    on.date = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
    on.cpu = cpu_model();
    on.instructions = cpu_target_name();
    on.threads = threads > 0 ? threads : default_threads();
    if (::getloadavg(&on.load, 1) != 1) on.load = -1;
    if (gl) {
        note_gl(on, gl->renderer(), gl->driver(), gl->software_gl());
        on.gl_clock = gl->clock();
    }
    on.version = build::version;
    on.commit = build::commit;
    on.compiler = build::compiler;
    on.flags = build::flags;
    on.build_type = build::build_type;
    on.seed = seed;
    return on;
}

MeasuredOn measured_on(const Session& session, std::initializer_list<const char*> varied, const FrameTracer* gl) {
    MeasuredOn on = measured_on(session.threads, session.seed, gl);
    on.settings = settings_but(session, varied).dump();
    return on;
}

MeasuredOn measured_on(int threads, unsigned seed, const Context& gl) {
    MeasuredOn on = measured_on(threads, seed);
    note_gl(on, gl.renderer(), gl.version(), gl.is_software());
    return on;
}

void note_gl(MeasuredOn& on, const std::string& renderer, const std::string& driver, bool software) {
    on.renderer = renderer;
    on.driver = driver;
    on.software_gl = software;
    if (const char* groups = std::getenv("KDSCOPE_COMPUTE")) on.gl_groups = printable(groups);
    if (!software) return;
    const char* told = std::getenv("LP_NUM_THREADS");
    on.gl_threads = told && *told ? fmt::format("{} (LP_NUM_THREADS)", printable(told))
                                  : fmt::format("{} (one a core)", std::thread::hardware_concurrency());
}

void check_frame_memory(int width, int height) {
    constexpr double per_pixel = sizeof(Vec4) + pass_count * (sizeof(Hit) + sizeof(RayCounters));
    const double needed = per_pixel * double(width) * double(height);
    const double there = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGESIZE));
    if (there > 0 && needed > 0.8 * there)
        throw InputError(
            fmt::format("--size: {}x{} pixels with all their counters take {:.1f} GB, this machine has {:.1f} "
                        "GB; choose a smaller size",
                        width, height, needed * 1e-9, there * 1e-9));
}

}  // namespace kd

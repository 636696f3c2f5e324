// What a measurement was made on: stored with every result, so that it can be made again.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace kd {

struct MeasuredOn {
    std::string date;               // "2026-11-22 09:35 UTC"
    std::string cpu, instructions;  // "Intel(R) Xeon(R) ...", "AVX-512"
    int threads = 0;                // of the CPU tracers
    double load = -1;               // of the machine when it began: processes that wanted to run; -1 = not known
    std::string renderer, driver;   // GL_RENDERER and GL_VERSION; empty without OpenGL
    bool software_gl = false;       // the shaders ran on the CPU
    std::string gl_threads;         // "2 (one a core)", "4 (LP_NUM_THREADS)"; empty where no software ran them
    std::string gl_groups;          // KDSCOPE_COMPUTE, which compute shaders were run by; empty where it is not set
    std::string gl_clock;           // that times of OpenGL were read from; the CPU's are from the steady clock
    std::string version, commit, compiler, flags, build_type;
    unsigned seed = 1;
    std::string settings;  // chosen for all of it, JSON on one line: what its rows do not name themselves

    /// Name and value of each, in the order above: "commit", "5278aa2".
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> facts() const;
    /// "commit: 5278aa2", as comments of tables.
    [[nodiscard]] std::vector<std::string> lines() const;
};

}  // namespace kd

#include "renderer/measure/process_memory.h"

#include <fstream>

#ifdef __linux__
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace kd {

std::optional<std::int64_t> resident_bytes() {
#if defined(__linux__) && !defined(KD_SANITIZED)
    std::ifstream file("/proc/self/statm");
    std::int64_t pages = 0, resident = 0;
    if (file >> pages >> resident) return resident * sysconf(_SC_PAGESIZE);
#endif
    return std::nullopt;
}

std::optional<std::int64_t> resident_bytes_in_use() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    return resident_bytes();
}

std::optional<std::int64_t> peak_resident_bytes() {
#if defined(__linux__) && !defined(KD_SANITIZED)
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) == 0) return std::int64_t(usage.ru_maxrss) * 1024;
#endif
    return std::nullopt;
}

}  // namespace kd

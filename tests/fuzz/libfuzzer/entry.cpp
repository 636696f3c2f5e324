// What libFuzzer calls. KD_FUZZ_TARGET is the function of tests/fuzz/targets.h that this program fuzzes.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    kd::fuzz::KD_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}

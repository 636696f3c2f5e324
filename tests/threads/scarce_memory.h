// Memory that runs out at a known place, in every build: this executable's operator new is our own.
#pragma once

#include <cstddef>

namespace kd::test {

/// For its scope, allocations of at least so many bytes throw std::bad_alloc, on all threads.
class ScarceMemory {
  public:
    explicit ScarceMemory(std::size_t too_much);
    ~ScarceMemory();
    ScarceMemory(const ScarceMemory&) = delete;
    ScarceMemory& operator=(const ScarceMemory&) = delete;
};

}  // namespace kd::test

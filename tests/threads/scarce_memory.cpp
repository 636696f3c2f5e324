// Apart from its users: inlined into containers, a pair of new and free looks mismatched to the compiler.
#include "tests/threads/scarce_memory.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> limit = no_limit;

}  // namespace

void* operator new(std::size_t size) {
    if (size < limit)
        if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }

void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace kd::test {

ScarceMemory::ScarceMemory(std::size_t too_much) { limit = too_much; }

ScarceMemory::~ScarceMemory() { limit = no_limit; }

}  // namespace kd::test

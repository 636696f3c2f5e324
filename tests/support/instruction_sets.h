// The hot code of every instruction set that this processor has, not of the best alone.
#pragma once

#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/targets.h"
// After targets.h.
#include <hwy/highway.h>

namespace kd::test {

/// Calls `check` once for each instruction set that the hot code was compiled for and that this processor has; while
/// it runs, CpuTracer runs with that one.
template <class Check>
void on_each_instruction_set(const Check& check) {
    struct AllAgain {
        ~AllAgain() { hwy::SetSupportedTargetsForTest(0); }
    } all_again;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        SCOPED_TRACE(cpu_target_name());
        check();
    }
}

}  // namespace kd::test

// What tests with a context share.
#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

#include "renderer/gl/gl_tracer.h"
#include "renderer/kdtree/build.h"
#include "tests/support/scenes.h"

namespace kd::test {

/// A test that runs once per kind of context; skipped, saying why, where this machine gives none of that kind.
class ContextTest : public testing::TestWithParam<ContextKind> {
  protected:
    void SetUp() override {
        try {
            context = Context::create(GetParam());
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
    }

    const GlApi& gl() const { return context->gl(); }

    std::unique_ptr<Context> context;
};

inline std::string context_name(const testing::TestParamInfo<ContextKind>& test) {
    return std::string(name_of(test.param));
}

/// A kind of context, and a kind of shaders on it.
struct Machine {
    ContextKind context;
    GlMode mode;
};

inline std::string machine_name(const testing::TestParamInfo<Machine>& test) {
    std::string name = std::string(name_of(test.param.context)) + "_" + std::string(tracer_name(test.param.mode));
    std::ranges::replace(name, '-', '_');
    return name;
}

/// Every kind of context and every kind of shaders, not every pair: where both contexts are software, one compiler
/// serves both, and compiling takes most of a test's time.
inline std::vector<Machine> all_machines() {
    return {{ContextKind::osmesa, GlMode::fragment},
            {ContextKind::egl, GlMode::fragment},
            {ContextKind::osmesa, GlMode::compute},
            {ContextKind::egl, GlMode::wavefront}};
}

/// A test that runs on each of all_machines().
class MachineTest : public testing::TestWithParam<Machine> {
  protected:
    void SetUp() override {
        try {
            context = Context::create(GetParam().context);
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
    }

    const GlApi& gl() const { return context->gl(); }
    GlMode mode() const { return GetParam().mode; }

    std::unique_ptr<Context> context;
};

#define KD_FOR_ALL_MACHINES(Suite)                                                                                     \
    INSTANTIATE_TEST_SUITE_P(Machines, Suite, testing::ValuesIn(test::all_machines()), test::machine_name)

#define KD_FOR_ALL_CONTEXTS(Suite)                                                                                     \
    INSTANTIATE_TEST_SUITE_P(Contexts, Suite, testing::Values(ContextKind::osmesa, ContextKind::egl), context_name)

inline Tile whole(int width, int height) { return {0, 0, width, height}; }

}  // namespace kd::test

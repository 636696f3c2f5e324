// What tests with a context share.
#pragma once

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

#define KD_FOR_ALL_CONTEXTS(Suite)                                                                                     \
    INSTANTIATE_TEST_SUITE_P(Contexts, Suite, testing::Values(ContextKind::osmesa, ContextKind::egl), context_name)

inline Tile whole(int width, int height) { return {0, 0, width, height}; }

}  // namespace kd::test

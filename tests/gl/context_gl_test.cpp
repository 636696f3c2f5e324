#include "renderer/gl/context.h"

#include <cstdlib>

#include "renderer/gl/gl_error.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

class ContextGl : public ContextTest {};
KD_FOR_ALL_CONTEXTS(ContextGl);

TEST_P(ContextGl, TellsWhatItIs) {
    EXPECT_EQ(context->kind(), GetParam());
    EXPECT_FALSE(context->renderer().empty());
    EXPECT_FALSE(context->version().empty());
    EXPECT_EQ(context->is_software(), context->renderer().find("llvmpipe") != std::string::npos);
    int major = 0, minor = 0;
    gl().GetIntegerv(GL_MAJOR_VERSION, &major);
    gl().GetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 43);
}

TEST_P(ContextGl, LeavesNoErrorBehind) { EXPECT_NO_THROW(check_gl(gl(), "creating")); }

TEST_P(ContextGl, ReportsErrorsWithTheirStep) {
    gl().Enable(GL_TEXTURE_2D + 12345);
    try {
        check_gl(gl(), "doing this");
        FAIL();
    } catch (const GlError& error) {
        EXPECT_STREQ(error.what(), "OpenGL: invalid enum while doing this (0x0500)");
    }
    EXPECT_NO_THROW(check_gl(gl(), "afterwards"));
}

TEST_P(ContextGl, ComesBackAfterAnotherContext) {
    GLuint buffer = 0;
    gl().GenBuffers(1, &buffer);
    const float value = 42.0f;
    gl().BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl().BufferData(GL_UNIFORM_BUFFER, sizeof value, &value, GL_STATIC_DRAW);
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
        try {
            const auto other = Context::create(kind);
            float read = 7.0f;
            context->make_current();
            gl().GetBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof read, &read);
            EXPECT_EQ(read, value) << "after making " << name_of(kind);
            other->make_current();
        } catch (const ContextError&) {
            continue;  // this machine does not have that one
        }
        // The other one is gone now.
        context->make_current();
        float read = 7.0f;
        gl().GetBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof read, &read);
        EXPECT_EQ(read, value) << "after the end of " << name_of(kind);
    }
    gl().DeleteBuffers(1, &buffer);
}

TEST_P(ContextGl, RefusesOldVersions) {
    context.reset();
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    setenv("MESA_GLSL_VERSION_OVERRIDE", "330", 1);
    std::string message;
    try {
        const auto old = Context::create(GetParam());
        message = "made " + old->version() + " on " + old->renderer();
        if (!old->is_software()) message = "4.3: not a Mesa driver; --tracer cpu";
    } catch (const ContextError& error) {
        message = error.what();
    }
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_GLSL_VERSION_OVERRIDE");
    EXPECT_NE(message.find("4.3"), std::string::npos) << message;
    EXPECT_NE(message.find("--tracer cpu"), std::string::npos) << message;
}

TEST(Context, AutomaticFindsOne) {
    try {
        const auto context = Context::create(ContextKind::automatic);
        EXPECT_NE(context->kind(), ContextKind::automatic);
        EXPECT_NE(context->kind(), ContextKind::adopted);
    } catch (const ContextError& error) {
        GTEST_SKIP() << "NO CONTEXT: " << error.what();
    }
}

TEST(GlApi, ListsWhatIsMissing) {
    GlApi gl;
    const auto missing = gl.load([](const char* name) -> void* {
        static int somewhere;
        return std::string_view(name) == "glFinish" || std::string_view(name) == "glEnablei" ? nullptr : &somewhere;
    });
    EXPECT_EQ(missing, (std::vector<std::string>{"glEnablei", "glFinish"}));
    EXPECT_EQ(gl.Finish, nullptr);
    EXPECT_NE(gl.Enable, nullptr);
}

}  // namespace
}  // namespace kd

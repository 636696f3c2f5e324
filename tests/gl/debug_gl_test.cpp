// Names in OpenGL, and what the driver says about errors.
#include "renderer/gl/gl_debug.h"

#include <array>
#include <cstdlib>

#include "renderer/gl/frame_targets.h"
#include "renderer/gl/gl_error.h"
#include "renderer/gl/pass_programs.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

class DebugGl : public ContextTest {
  protected:
    std::string label_of(GLenum kind, GLuint id) const {
        std::array<char, 256> text{};
        GLsizei length = 0;
        gl().GetObjectLabel(kind, id, GLsizei(text.size()), &length, text.data());
        return {text.data(), std::size_t(length)};
    }

    static std::string error_of(const GlApi& gl) {
        {
            const GlGroup group(gl, "some pass");
            gl.Enable(GL_TEXTURE_2D + 12345);
        }
        try {
            check_gl(gl, "doing this");
        } catch (const GlError& error) {
            return error.what();
        }
        return "no error";
    }

    /// A context of the kind under test that was made with KD_GL_DEBUG set to `value`.
    std::unique_ptr<Context> with_debug(const char* value) const {
        ::setenv("KD_GL_DEBUG", value, 1);
        auto made = Context::create(GetParam());
        ::unsetenv("KD_GL_DEBUG");
        return made;
    }
};
KD_FOR_ALL_CONTEXTS(DebugGl);

TEST_P(DebugGl, ProgramsTexturesAndFramebuffersAreNamed) {
    ProgramCache programs(gl());
    EXPECT_EQ(label_of(GL_PROGRAM, programs.get(program_key(Step::mark, {})).id()), "fragment/mark.frag");
    const FrameTargets targets(gl(), {.width = 8, .height = 8, .counters = true, .bounces = 1});
    EXPECT_EQ(label_of(GL_FRAMEBUFFER, targets.framebuffer(Pass::shade_prim)), "ShadePrim");
    EXPECT_EQ(label_of(GL_FRAMEBUFFER, targets.bounce_framebuffer(0)), "RTRefl");
    EXPECT_EQ(label_of(GL_TEXTURE, targets.colour()), "colour");
    EXPECT_EQ(label_of(GL_TEXTURE, targets.layer(Pass::rt_prim).counters_b.id()), "RTPrim counters b");
    EXPECT_NO_THROW(check_gl(gl(), "naming"));
}

TEST_P(DebugGl, ObjectsAreCountedWhileTheyLive) {
    const std::array<int, 7> before = count_objects(gl());
    {
        const GlTexture texture = make_texture(gl(), GL_RGBA32F, 4, 4, "counted");
        const std::array<const GlTexture*, output_count> outputs{&texture};
        const GlFramebuffer framebuffer = make_framebuffer(gl(), outputs, 0, "counted");
        std::array<int, 7> with = before;
        ++with[1];
        ++with[2];
        EXPECT_EQ(count_objects(gl()), with);
    }
    EXPECT_EQ(count_objects(gl()), before);
}

TEST_P(DebugGl, ErrorsNameTheGroupWhereAskedFor) {
    const auto debugging = with_debug("1");
    const std::string message = error_of(debugging->gl());
    EXPECT_NE(message.find("invalid enum while doing this"), std::string::npos) << message;
    if (message.find("the driver says") == std::string::npos) {
        if (debugging->is_software()) FAIL() << "Mesa was silent: " << message;
        GTEST_SKIP() << "this driver says nothing outside of a debug context";
    }
    EXPECT_NE(message.find("in some pass: "), std::string::npos) << message;
    EXPECT_EQ(error_of(debugging->gl()), message) << "messages of the last error are not told again";
    EXPECT_NO_THROW(check_gl(debugging->gl(), "going on"));
}

TEST_P(DebugGl, NobodyListensUnlessAskedFor) {
    for (const char* value : {"", "0"}) {
        const auto quiet = with_debug(value);
        EXPECT_EQ(quiet->gl().messages, nullptr);
        EXPECT_EQ(quiet->gl().IsEnabled(GL_DEBUG_OUTPUT_SYNCHRONOUS), GL_FALSE);
        EXPECT_EQ(error_of(quiet->gl()), "OpenGL: invalid enum while doing this (0x0500)");
    }
}

}  // namespace
}  // namespace kd

#include "renderer/gl/program.h"

#include "renderer/gl/pass_programs.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

class ProgramGl : public ContextTest {
  protected:
    /// The project's files, and over them `files`.
    static ShaderReader with(std::map<std::string, std::string> files) {
        return [files = std::move(files), built_in = default_shader_reader()](const std::string& path) {
            const auto found = files.find(path);
            return found == files.end() ? built_in(path) : std::optional(found->second);
        };
    }

    std::string message_of(const ProgramKey& key, const ShaderReader& read) {
        try {
            const GlProgram program(gl(), key, read);
        } catch (const GlError& error) {
            return error.what();
        }
        return "no error";
    }
};
KD_FOR_ALL_CONTEXTS(ProgramGl);

TEST_P(ProgramGl, ReportsFileAndLineOfAnError) {
    const auto read =
        with({{"bad.frag", "#include \"good.glsl\"\nout vec4 colour;\nvoid main()\n{\n    colour = nonsense;\n}\n"},
              {"good.glsl", "float one() { return 1.0; }\n\n\n"}});
    const std::string message = message_of({"fragment/quad.vert", "bad.frag", {{"KD_QUAD_DEPTH", "0.5"}}}, read);
    EXPECT_NE(message.find("shader bad.frag does not compile"), std::string::npos) << message;
    EXPECT_NE(message.find("shaders/bad.frag:5"), std::string::npos) << message;
    EXPECT_NE(message.find("nonsense"), std::string::npos) << message;
}

TEST_P(ProgramGl, ReportsFileAndLineInsideAnInclude) {
    const auto read = with({{"shared/box.glsl", "\n\nint broken( { }\n"}});
    const std::string message = message_of(program_key(Step::rt_prim, {}), read);
    EXPECT_NE(message.find("shaders/shared/box.glsl:3"), std::string::npos) << message;
}

TEST_P(ProgramGl, ReportsAMissingInclude) {
    const auto read = with({{"bad.frag", "#include \"none.glsl\"\nvoid main() {}\n"}});
    EXPECT_EQ(message_of({"fragment/quad.vert", "bad.frag", {}}, read),
              "shaders/bad.frag:1: there is no \"none.glsl\", neither beside this file nor in shaders/");
}

TEST_P(ProgramGl, ReportsLinkErrors) {
    const auto read = with({{"call.frag", "vec4 nowhere();\nout vec4 c;\nvoid main() { c = nowhere(); }\n"}});
    const std::string message = message_of({"fragment/quad.vert", "call.frag", {}}, read);
    // Drivers differ in the step that finds it.
    EXPECT_TRUE(message.find("do not link") != std::string::npos || message.find("not compile") != std::string::npos);
    EXPECT_NE(message.find("nowhere"), std::string::npos) << message;
}

TEST_P(ProgramGl, ReportsFileAndLineOfAComputeShader) {
    const auto read = with({{"bad.comp", "layout(local_size_x = 8) in;\nvoid main()\n{\n    nonsense();\n}\n"}});
    const std::string message = message_of({"", "", {}, "bad.comp"}, read);
    EXPECT_NE(message.find("shader bad.comp does not compile"), std::string::npos) << message;
    EXPECT_NE(message.find("shaders/bad.comp:4"), std::string::npos) << message;
    EXPECT_EQ(message_of({}, read), "OpenGL: a program of no shader");
}

TEST_P(ProgramGl, KeepsProgramsByKey) {
    ProgramCache cache(gl());
    ProgramSettings settings;
    const GlProgram& first = cache.get(program_key(Step::mark, settings));
    EXPECT_EQ(&cache.get(program_key(Step::mark, settings)), &first);
    EXPECT_EQ(cache.size(), 1u);
    settings.later_bounce = true;
    EXPECT_NE(cache.get(program_key(Step::mark, settings)).id(), first.id());
    EXPECT_EQ(cache.size(), 2u);
}

TEST_P(ProgramGl, KeepsSoManyAndDropsTheOneUnusedLongest) {
    ProgramCache cache(gl(), default_shader_reader(), 2);
    int compiled = 0;
    cache.tell_compiling([&] { ++compiled; });
    const auto use = [&](bool later_bounce, bool corrected) {
        ProgramSettings settings;
        settings.later_bounce = later_bounce;
        settings.corrected_rounding = corrected;
        (void)cache.get(program_key(Step::rays, settings));
    };
    use(false, false);
    use(true, false);
    use(false, false);
    EXPECT_EQ(compiled, 2);
    use(true, true);  // takes the place of the second
    EXPECT_EQ(cache.size(), 2u);
    EXPECT_EQ(compiled, 3);
    use(false, false);
    EXPECT_EQ(compiled, 3) << "the first was used since";
    use(true, false);
    EXPECT_EQ(compiled, 4);
    EXPECT_EQ(cache.size(), 2u);
}

TEST_P(ProgramGl, CompilesEveryStepWithEveryTraversalRuleAndSwitch) {
    ProgramCache cache(gl());
    const auto compile = [&](const TraversalInfo& traversal, const RulesInfo& rules, bool on, GlMode mode) {
        for (const Step step :
             {Step::rt_prim, Step::shade_prim, Step::rt_refl, Step::shade_refl, Step::mark, Step::rays}) {
            if (mode == GlMode::compute && step == Step::mark) continue;
            ProgramSettings s;
            s.mode = mode;
            s.compute.storage = s.compute.morton = on;
            s.compute.dealt = on;
            s.trace.traversal = traversal.id;
            s.trace.rules = rules.id;
            s.count_shaded = s.limited_loops = s.corrected_rounding = on;
            for (const FeatureInfo& feature : features()) s.needs.*feature.in_use = on;
            s.needs.bounces = 2;
            s.needs.lights = 1;
            s.needs.levels = on ? max_tree_depth : 8;
            s.early_z = on ? EarlyZ::as_published : EarlyZ::working;
            s.later_bounce = on && (step == Step::rt_refl || step == Step::shade_refl);
            EXPECT_NO_THROW((void)cache.get(program_key(step, s)))
                << traversal.name << " " << rules.name << " step " << int(step);
        }
    };
    for (const TraversalInfo& traversal : traversals())
        for (const RulesInfo& rules : all_rules())
            if (rules.id == Rules::robust || traversal.has_published_form())
                for (const bool on : {false, true}) compile(traversal, rules, on, GlMode::fragment);
    // The walks of compute shaders are the same text: all switches off in one context, and on in the other.
    for (const TraversalInfo& traversal : traversals())
        compile(traversal, info(Rules::robust), GetParam() == ContextKind::egl, GlMode::compute);
    EXPECT_NO_THROW(check_gl(gl(), "compiling"));
}

}  // namespace
}  // namespace kd

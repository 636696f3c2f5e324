// Includes, line tables and driver logs. Needs no context.
#include "renderer/gl/shader_source.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>

#include "renderer/gl/shader_text.h"

namespace kd {
namespace {

ShaderReader reader_of(std::map<std::string, std::string> files) {
    return [files = std::move(files)](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path);
        if (found == files.end()) return std::nullopt;
        return found->second;
    };
}

std::string message_of(const std::string& entry, std::map<std::string, std::string> files) {
    try {
        (void)resolve_shader(entry, {}, reader_of(std::move(files)));
    } catch (const ShaderError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ShaderSource, PutsVersionAndSettingsFirst) {
    const ShaderSource source =
        resolve_shader("a.frag", {{"TWO", "2"}, {"ONE", "1"}}, reader_of({{"a.frag", "void main() {}\n"}}));
    EXPECT_EQ(source.text, "#version 430 core\n#define ONE 1\n#define TWO 2\nvoid main() {}\n");
    EXPECT_EQ(source.locate(4), "shaders/a.frag:1");
    EXPECT_EQ(source.locate(3), "settings of a.frag:3");
}

TEST(ShaderSource, IncludesBesideTheFileBeforeTheRoot) {
    const ShaderSource source = resolve_shader("x/a.frag", {},
                                               reader_of({{"x/a.frag", "one\n#include \"b.glsl\"\nthree"},
                                                          {"x/b.glsl", "beside\n#include \"y/c.glsl\"\n"},
                                                          {"b.glsl", "root"},
                                                          {"y/c.glsl", "c1\r\nc2\r\n"}}));
    EXPECT_EQ(source.text, "#version 430 core\none\nbeside\nc1\nc2\nthree\n");
    EXPECT_EQ(source.locate(2), "shaders/x/a.frag:1");
    EXPECT_EQ(source.locate(3), "shaders/x/b.glsl:1");
    EXPECT_EQ(source.locate(5), "shaders/y/c.glsl:2");
    EXPECT_EQ(source.locate(6), "shaders/x/a.frag:3");
    EXPECT_EQ(source.lines.size(), 6u);
}

TEST(ShaderSource, NamesThePlaceOfAMissingInclude) {
    EXPECT_EQ(message_of("a.frag", {{"a.frag", "\n\n#include \"nowhere.glsl\"\n"}}),
              "shaders/a.frag:3: there is no \"nowhere.glsl\", neither beside this file nor in shaders/");
    EXPECT_EQ(message_of("a.frag", {}), "there is no shader file \"a.frag\" in shaders/");
}

TEST(ShaderSource, RefusesCycles) {
    EXPECT_EQ(message_of("a", {{"a", "#include \"b\""}, {"b", "\n#include \"c\""}, {"c", "#include \"a\""}}),
              "shaders/c:1: \"a\" includes itself");
    EXPECT_EQ(message_of("a", {{"a", "#include \"a\""}}), "shaders/a:1: \"a\" includes itself");
}

TEST(ShaderSource, MayIncludeAFileTwiceInARow) {
    const ShaderSource source =
        resolve_shader("a", {}, reader_of({{"a", "#include \"b\"\n#include \"b\"\n"}, {"b", "x"}}));
    EXPECT_EQ(source.text, "#version 430 core\nx\nx\n");
}

TEST(ShaderSource, MapsTheLogsOfDrivers) {
    const ShaderSource source =
        resolve_shader("a.frag", {{"N", "1"}}, reader_of({{"a.frag", "one\n#include \"b\"\n"}, {"b", "two\nthree\n"}}));
    EXPECT_EQ(source.map_log("0:3(7): error: no\n0:5(12): warning: 0:1 is a ratio"),
              "shaders/a.frag:1: error: no\nshaders/b:2: warning: settings of a.frag:1 is a ratio");
    EXPECT_EQ(source.map_log("0(4) : error C1008: undefined"), "shaders/b:1 : error C1008: undefined");
    EXPECT_EQ(source.map_log("ERROR: 0:4: 'x'"), "ERROR: shaders/b:1: 'x'");
    EXPECT_EQ(source.map_log("10:4: 1.0(3) x0(3) no position"), "10:4: 1.0(3) x0(3) no position");
    EXPECT_EQ(source.map_log("0:99(1): beyond"), "settings of a.frag:99: beyond");
    EXPECT_EQ(source.map_log(""), "");
}

TEST(ShaderSource, ResolvesEveryEntryPointOfTheProject) {
    int entries = 0;
    for (const ShaderFile& file : shader_files()) {
        if (!file.path.ends_with(".frag") && !file.path.ends_with(".vert") && !file.path.ends_with(".comp")) continue;
        ++entries;
        const ShaderSource source = resolve_shader(std::string(file.path), {});
        EXPECT_NE(source.text.find("void main()"), std::string::npos) << file.path;
        EXPECT_EQ(source.text.find("\n#include"), std::string::npos) << file.path;
    }
    EXPECT_GE(entries, 13);
}

TEST(ShaderSource, ReadsAFolderInstead) {
    const auto folder = std::filesystem::path(KD_TEST_OUTPUT_DIR) / "shader_folder";
    std::filesystem::create_directories(folder / "fragment");
    std::ofstream(folder / "fragment" / "mine.frag") << "from disk";
    setenv("KD_SHADER_DIR", folder.c_str(), 1);
    const ShaderReader read = default_shader_reader();
    unsetenv("KD_SHADER_DIR");
    EXPECT_EQ(read("fragment/mine.frag"), "from disk");
    EXPECT_EQ(read("fragment"), std::nullopt);
    EXPECT_EQ(read("fragment/rt_prim.frag"), std::nullopt);
    EXPECT_NE(default_shader_reader()("fragment/rt_prim.frag"), std::nullopt);
}

}  // namespace
}  // namespace kd

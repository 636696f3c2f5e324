// Planes by hand on the command line, in session files and in the window's engine.

#include <nlohmann/json.hpp>

#include "app/session_file.h"
#include "renderer/io/file.h"
#include "renderer/kdtree/build.h"
#include "tests/app/cli_run.h"
#include "tests/app/engine_run.h"

namespace kd {
namespace {

using nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;

const std::string square = std::string(KD_SOURCE_DIR) + "/tests/fixtures/app/large_square.gltf";
constexpr const char* outside = "plane by hand not used at 'b': it is not inside its cell";
constexpr const char* nowhere = "plane by hand not used at 'aaa': the tree ends above its node";

/// `stats --json` of a small picture.
json stats(std::vector<std::string> more) {
    more.insert(more.begin(), {"stats", "--json", "--size", "16x16"});
    const auto outcome = run_kdscope(more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)[0];
}

TEST(HandSplitOption, PutsPlanes) {
    const json free = stats({"ball:300"});
    const json split = stats({"ball:300", "--split", ":y:0.25", "--split", "b:x:-0.5"});
    EXPECT_NE(split["trees"][0]["tree"]["sah_cost"], free["trees"][0]["tree"]["sah_cost"]);
    EXPECT_EQ(split["trees"][0]["idle_hand_splits"], 0);
    EXPECT_EQ(
        split["settings"]["build"]["by_hand"],
        json::parse(R"([{"path": "", "axis": "y", "position": 0.25}, {"path": "b", "axis": "x", "position": -0.5}])"));
}

TEST(HandSplitOption, TakesPositionsInTheScenesUnits) {
    const TestFolder folder;
    const std::vector<std::string> render{"render",  square,      "-o",     folder.file("a.png"), "--size", "16x16",
                                          "--split", ":x:300000", "--json", folder.file("a.json")};
    const auto outcome = run_kdscope(render);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "") << "it stands in the tree";
    EXPECT_EQ(json::parse(read_file(folder.file("a.json")))["settings"]["build"]["by_hand"][0]["position"], 300000);
}

TEST(HandSplitOption, IdlePlanesAreTold) {
    const TestFolder folder;
    const std::vector<std::string> planes{"--split", ":y:0.25", "--split", "b:x:99", "--size", "16x16"};
    const auto told = [&](std::vector<std::string> command) {
        command.insert(command.end(), planes.begin(), planes.end());
        const auto outcome = run_kdscope(command);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE((outcome.out + outcome.err).find(outside), std::string::npos) << command.front();
    };
    told({"render", "ball:300", "-o", folder.file("a.png")});
    told({"stats", "ball:300"});
    told({"stats", "ball:300", "--predicted"});
    told({"stats", "ball:300", "--traversals"});
    told({"verify", "ball:300", "--tracer", "cpu", "--builder", "paper", "--traversal", "stack"});
    told({"bench", "ball:300", "--rounds", "1", "--warmup", "0", "--tracer", "cpu", "--traversal", "stack"});
}

TEST(HandSplitOption, BadOnesAreRefusedInOneLine) {
    const auto refused = [](const std::string& given, const std::vector<std::string>& words) {
        expect_usage_error(run_kdscope({"stats", "ball:300", "--split", given}), words);
    };
    refused("0.5", {"--split", "'0.5': not PATH:AXIS:AT, such as ba:x:0.5"});
    refused("b:x", {"'b:x': not PATH:AXIS:AT"});
    refused("b:w:1", {"'b:w:1': unknown axis 'w'", "x, y, z"});
    refused("B:X:1", {"'B:X:1': a path is made of b"});
    refused("b:x:far", {"'b:x:far': position 'far' is not a finite number"});
    refused("b:x:inf", {"'inf' is not a finite number"});
    refused("ab0:x:1", {"a path is made of b (the child below) and a (the child above)"});
    refused(std::string(70, 'a') + ":x:1", {"no tree is 71 levels deep"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--split", "b:x:0", "--split", "b:y:0"}),
                       {"there is another for the same node"});
}

TEST(HandSplitSession, ComesBackFromAFile) {
    const TestFolder folder;
    Session session;
    session.build.by_hand = {{"", 2, -0.1f}, {"ba", 0, 1e-30f}};
    write_session(folder.file("a.json"), session);
    EXPECT_EQ(read_session(folder.file("a.json")), session);
}

TEST(HandSplitSession, BadOnesAreRefusedWithTheirPlace) {
    const TestFolder folder;
    const auto refused = [&](const std::string& list, const std::vector<std::string>& words) {
        write_file(folder.file("bad.json"),
                   R"({"kdscope_session": 1, "settings": {"build": {"by_hand": )" + list + "}}}");
        expect_usage_error(run_kdscope({"render", folder.file("bad.json"), "-o", folder.file("a.png")}), words);
    };
    refused("3", {"/settings/build/by_hand: 3 is not a list of planes"});
    refused("[1]", {"/settings/build/by_hand/0: 1 is not an object"});
    refused(R"([{"axis": 0}])", {"/settings/build/by_hand/0/axis", "a text in quotes"});
    refused(R"([{"path": "b"}, {"path": "bc"}])", {"/settings/build/by_hand/1: a path is made of b"});
    refused(R"([{"path": "b"}, {"path": "b"}])", {"/settings/build/by_hand/1: there is another for the same node"});
    refused(R"([{"at": 1}])", {"/settings/build/by_hand/0/at: unknown key"});
}

TEST(HandSplitEngine, TellsIdlePlanesAndOpensThemInTheScenesUnits) {
    const TestFolder folder;
    Session session;
    session.scene = square;
    session.build.by_hand = {{"", 0, 300000.0f}, {"aaa", 1, 1.0f}};
    write_session(folder.file("a.json"), session);
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.open_session(folder.file("a.json"));
    ASSERT_TRUE(settle(engine));
    ASSERT_EQ(engine.state().world->loaded->name, square);
    EXPECT_EQ(engine.state().world->report.idle_hand_splits, 1);
    const auto& messages = engine.state().messages;
    const auto is_note = [](const Message& m) { return m.text == std::string("tree: ") + nowhere; };
    EXPECT_EQ(std::ranges::count_if(messages, is_note), 1);
}

}  // namespace
}  // namespace kd

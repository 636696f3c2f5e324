#include "app/session_file.h"

#include <clocale>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "app/cli/common_options.h"
#include "app/report/json_values.h"
#include "app/scenes.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "tests/app/cli_run.h"
#include "tests/app/session_samples.h"

namespace kd {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using test::unlike_the_default;

TEST(SessionFile, EveryFieldComesBack) {
    const TestFolder folder;
    const Session session = unlike_the_default();
    write_session(folder.file("a.session.json"), session);
    const Session back = read_session(folder.file("a.session.json"));
    EXPECT_EQ(back, session);
    EXPECT_TRUE(std::signbit(back.camera->eye.y)) << "the zero of a coordinate keeps its sign";
    for (const RangeMode mode : {RangeMode::automatic, RangeMode::fixed}) {
        Session other;
        other.view.heat.range_mode = mode;
        write_session(folder.file("b.session.json"), other);
        EXPECT_EQ(read_session(folder.file("b.session.json")), other);
    }
}

TEST(SessionFile, TheOneUnlikeTheDefaultIsSoInEveryField) {
    const auto leaves = [](const Session& session) { return json(settings_json(session, session.view)).flatten(); };
    const json unlike = leaves(unlike_the_default()), usual = leaves(Session{});
    for (const auto& [place, value] : usual.items()) EXPECT_NE(unlike.value(place, json("none")), value) << place;
}

/// Every key of an object and those within it, of objects in lists too.
void collect_keys(const json& object, std::set<std::string>& keys) {
    for (const auto& [key, value] : object.items()) {
        keys.insert(key);
        if (value.is_object()) collect_keys(value, keys);
        if (!value.is_array()) continue;
        for (const json& element : value)
            if (element.is_object()) collect_keys(element, keys);
    }
}

TEST(SessionFile, EveryKeyHasItsRowInTheDocumentAndEveryRowItsKey) {
    const Session session = unlike_the_default();
    std::set<std::string> keys, rows{"build", "view"};  // which have tables of their own
    collect_keys(json(settings_json(session, session.view)), keys);
    std::istringstream document(read_file(std::string(KD_SOURCE_DIR) + "/docs/session.md"));
    const std::regex name("`([a-z_]+)`");
    for (std::string line; std::getline(document, line);) {
        if (!line.starts_with("| `")) continue;
        const std::string cell = line.substr(0, line.find('|', 1));
        for (std::sregex_iterator match(cell.begin(), cell.end(), name), end; match != end; ++match)
            rows.insert((*match)[1]);
    }
    EXPECT_EQ(rows, keys);
}

TEST(SessionFile, KeysAreThoseOfThePng) {
    const TestFolder folder;
    Session session;
    session.scene = "ball:300";
    write_session(folder.file("a.session.json"), session);
    ASSERT_EQ(run_kdscope({"render", "ball:300", "-o", folder.file("a.png"), "--size", "8x8"}).code, 0);
    json of_png = json::parse(read_png_text(folder.file("a.png")).at("kdscope-settings"));
    json of_file = json::parse(read_file(folder.file("a.session.json")))["settings"];
    EXPECT_TRUE(of_png.erase("camera")) << "that of the scene, which the session leaves to it";
    std::set<std::string> keys_of_png, keys_of_file;
    collect_keys(of_png, keys_of_png);
    collect_keys(of_file, keys_of_file);
    EXPECT_EQ(keys_of_png, keys_of_file);
    EXPECT_EQ(of_png["view"]["map"]["shown"], false);
    EXPECT_EQ(of_file["view"]["map"]["shown"], true);
}

TEST(SessionFile, WhatIsMissingIsTheDefault) {
    const TestFolder folder;
    for (const char* text : {R"({"kdscope_session": 1})", R"({"kdscope_session": 1, "settings": {}})",
                             R"({"kdscope_session": 1, "settings": {"build": {}, "view": {"map": {}}}})"}) {
        write_file(folder.file("a.json"), text);
        EXPECT_EQ(read_session(folder.file("a.json")), Session{}) << text;
    }
}

struct BadFile {
    std::string text;
    std::vector<std::string> words;  // of the one line that it is refused with
};

/// A session whose settings are `text`.
std::string settings(const std::string& text) { return R"({"kdscope_session": 1, "settings": {)" + text + "}}"; }

std::vector<BadFile> bad_files() {
    const std::string deep(100000, '[');
    return {
        {"", {"parse error"}},
        {"[1, 2]", {"not a session file", "kdscope_session"}},
        {R"({"settings": {}})", {"not a session file", "kdscope_session"}},
        {R"({"kdscope_session": 2, "unheard_of": 1})", {"/kdscope_session", "newer kdscope", "version 1"}},
        {R"({"kdscope_session": "1"})", {"/kdscope_session", "must be 1"}},
        {R"({"kdscope_session": 1, "setings": {}})", {"/setings", "unknown key", "did you mean settings?"}},
        {R"({"kdscope_session": 1, "settings": [1]})", {"/settings: [1] is not an object"}},
        {R"({"kdscope_session": 1, "settings": )" + deep, {"nested deeper"}},
        {settings("\"scene\": \"\xff\""), {"UTF-8"}},
        {settings(R"("build": {"leaf_size": 0})"),
         {"/settings/build/leaf_size: 0 is not a whole number from 1 to 1048576"}},
        {settings(R"("build": {"leaf_size": 2.5})"), {"/settings/build/leaf_size: 2.5 is not a whole number"}},
        {settings(R"("build": {"leaf_size": "2"})"), {R"(/settings/build/leaf_size: "2" is not a whole number)"}},
        {settings(R"("build": {"leaf_size": null})"), {"/settings/build/leaf_size: null is not"}},
        {settings(R"("build": {"leaf_sise": 1})"), {"/settings/build/leaf_sise", "did you mean leaf_size?"}},
        {settings(R"("build": {"builder": "SAH"})"), {"/settings/build/builder", "unknown name 'SAH'", "paper"}},
        {settings(R"("build": {"empty_bonus": 1.0001})"), {"empty_bonus: 1.0001 is not a number from 0 to 1"}},
        {settings(R"("build": {"traversal_cost": 1e39})"), {"traversal_cost: 1e+39 is not a number from 0 to 1000000"}},
        {settings(R"("build": 7)"), {"/settings/build: 7 is not an object"}},
        {settings(R"("seed": -1)"), {"/settings/seed: -1 is not a whole number from 0 to 4294967295"}},
        {settings(R"("seed": 4294967296)"), {"/settings/seed: 4294967296 is not"}},
        {settings(R"("width": 16385)"), {"/settings/width: 16385 is not a whole number from 1 to 16384"}},
        {settings(R"("height": 18446744073709551615)"), {"/settings/height: 18446744073709551615 is not"}},
        {settings(R"("threads": 1e300)"), {"/settings/threads: 1e+300 is not"}},
        {settings(R"("scene": 5)"), {"/settings/scene: 5 is not a text"}},
        {settings(R"("tracer": "gpu")"),
         {"/settings/tracer", "unknown name 'gpu'",
          "known: cpu, cpu-wide, cpu-packet, gl-fragment, gl-compute, gl-wavefront"}},
        {settings(R"("tracer": ["cpu"])"), {R"(/settings/tracer: ["cpu"] is not a text)"}},
        {settings(R"("traversal": "stak")"), {"/settings/traversal", "did you mean stack?"}},
        {settings(R"("shadows": 1)"), {"/settings/shadows: 1 is not true or false"}},
        {settings(R"("short_stack": 0)"), {"/settings/short_stack: 0 is not a whole number from 1 to 8"}},
        {settings(R"("nodes": 4)"), {"/settings/nodes: 4 is not 16 or 8"}},
        {settings(R"("nodes": "8")"), {R"(/settings/nodes: "8" is not 16 or 8)"}},
        {settings(R"("forced": "ropes")"), {R"(/settings/forced: "ropes" is not a list)"}},
        {settings(R"("forced": ["ropes", "rope"])"), {"/settings/forced/1", "did you mean ropes?"}},
        {settings(R"("camera": null)"), {"/settings/camera: null is not an object"}},
        {settings(R"("camera": {"eye": [0, 0]})"), {"/settings/camera/eye: [0,0] is not three numbers"}},
        {settings(R"("camera": {"eye": [0, 0, "3"]})"), {R"(/settings/camera/eye/2: "3" is not a number)"}},
        {settings(R"("camera": {"eye": [0, 0, 1e39]})"), {"/settings/camera/eye/2: 1e+39 is not a number"}},
        {settings(R"("camera": {"eye": [1, 1, 1], "target": [1, 1, 1]})"), {"/settings/camera: eye and target must"}},
        {settings(R"("camera": {"up": [0, 0, 0]})"), {"/settings/camera/up: [0, 0, 0] is no direction"}},
        {settings(R"("camera": {"fov": 180})"), {"/settings/camera/fov: 180 is not a number from 0 to 179.9"}},
        {settings(R"("camera": {"fov": 0})"), {"/settings/camera/fov", "above 0"}},
        {settings(R"("view": {"map": {"name": "noodles"}})"), {"/settings/view/map/name", "unknown name 'noodles'"}},
        {settings(R"("view": {"map": {"rays": "secondary"}})"), {"/settings/view/map/rays", "reflection-shadow"}},
        {settings(R"("view": {"map": {"tile_width": 1, "tile_height": 1}})"), {"/settings/view/map", "4 to 1024"}},
        {settings(R"("view": {"map": {"name": "oracle", "rays": "shadow"}})"), {"/settings/view/map", "no nearest"}},
        {settings(R"("view": {"map": {"range": [2, 1]}})"), {"/settings/view/map/range: [2,1] is not", "LOW below"}},
        {settings(R"("view": {"map": {"range": "auto"}})"), {R"(/settings/view/map/range: "auto" is not)"}},
        {settings(R"("view": {"map": {"locked": true}})"), {"/settings/view/map/locked: there is nothing to lock"}},
        {settings(R"("view": {"map": {"opacity": -0.1}})"), {"/settings/view/map/opacity: -0.1 is not a number"}},
        {settings(R"("view": {"overlay": {"depth": 1000}})"), {"/settings/view/overlay/depth: 1000 is not"}},
        {settings(R"("line\nfeed": 1)"), {"/settings/line?feed: unknown key"}},
        {R"({"kdscope_session": 1, "x": ")" + std::string(1 << 20, 'x') + "\"}", {"larger than the limit of 1048576"}},
    };
}

TEST(SessionFile, WhatIsWrongIsToldInOneLineWithItsPlace) {
    const TestFolder folder;
    const std::string file = folder.file("bad.json");
    for (const BadFile& bad : bad_files()) {
        SCOPED_TRACE(bad.text.substr(0, 200));
        write_file(file, bad.text);
        try {
            (void)read_session(file);
            ADD_FAILURE() << "read";
        } catch (const InputError& error) {
            const std::string line = error.what();
            EXPECT_NE(line.find("bad.json: "), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
            for (const std::string& word : bad.words) EXPECT_NE(line.find(word), std::string::npos) << line;
        }
    }
    EXPECT_THROW((void)read_session(folder.file("none.json")), InputError);
    EXPECT_THROW((void)read_session(folder.folder()), InputError);
}

/// Refused in one line that holds every one of `words`.
void expect_refused(const TestFolder& folder, const std::string& text, const std::vector<std::string>& words) {
    write_file(folder.file("bad.json"), text);
    expect_usage_error(run_kdscope({"render", folder.file("bad.json"), "-o", folder.file("a.png")}), words);
    EXPECT_FALSE(fs::exists(folder.file("a.png")));
}

TEST(SessionFile, S01_OneThatIsCutOffIsRefused) {
    expect_refused(TestFolder(), R"({"kdscope_session": 1, "settings": {"seed": 1)", {"bad.json: parse error"});
}

TEST(SessionFile, S02_AnotherVersionIsRefused) {
    expect_refused(TestFolder(), R"({"kdscope_session": 0})", {"bad.json: /kdscope_session: must be 1"});
}

TEST(SessionFile, S03_ANewerVersionIsRefused) {
    expect_refused(TestFolder(), R"({"kdscope_session": 2})", {"bad.json: /kdscope_session: written by a newer"});
}

TEST(SessionFile, S04_AnUnknownKeyIsRefusedAndSoIsAKeyTwice) {
    const TestFolder folder;
    expect_refused(folder, settings(R"("sed": 1)"), {"/settings/sed: unknown key", "did you mean seed?"});
    expect_refused(folder, settings(R"("seed": 1, "build": {}, "seed": 2)"), {"bad.json: /settings/seed: ", "twice"});
    expect_refused(folder, settings(R"("build": {"bins": 8, "bins": 8})"), {"/settings/build/bins: ", "twice"});
    expect_refused(folder, R"({"kdscope_session": 1, "kdscope_session": 1})",
                   {"bad.json: /kdscope_session: ", "twice"});
}

TEST(SessionFile, S05_ACameraThatIsNoNumberIsRefused) {
    const TestFolder folder;
    expect_refused(folder, settings(R"("camera": {"eye": [NaN, 0, 0]})"), {"parse error"});
    expect_refused(folder, settings(R"("camera": {"eye": [1e999, 0, 0]})"), {"number overflow"});
}

TEST(SessionFile, S06_ASceneThatIsNotThereIsToldWithItsPlace) {
    const TestFolder folder;
    expect_refused(folder, settings(R"("scene": "gone.gltf")"), {"bad.json: /settings/scene: ", "gone.gltf"});
    expect_refused(folder, settings(R"("scene": "bal:300")"), {"bad.json: /settings/scene: ", "did you mean ball:300"});
}

TEST(SessionFile, S07_AChangedModelIsNotNoticed) {
    const TestFolder folder;
    write_file(folder.file("a.json"), settings(R"("scene": "m.gltf")"));
    fs::copy(std::string(KD_SOURCE_DIR) + "/tests/fixtures/app/large_square.gltf", folder.file("m.gltf"));
    const Session before = read_session(folder.file("a.json"));
    write_file(folder.file("m.gltf"), "{}");
    EXPECT_EQ(read_session(folder.file("a.json")), before);
}

TEST(SessionFile, S08_AWrongTypeIsRefused) {
    expect_refused(TestFolder(), settings(R"("seed": "1")"), {R"(/settings/seed: "1" is not a whole number)"});
}

TEST(SessionFile, PacketsAreNumbersAndWereTexts) {
    const TestFolder folder;
    for (const char* size : {"8", R"("8")"}) {
        write_file(folder.file("a.json"), settings(fmt::format(R"("packet_size": {})", size)));
        const Session session = read_session(folder.file("a.json"));
        EXPECT_EQ(session.trace.packet_size, 8);
        write_session(folder.file("b.json"), session);
        EXPECT_NE(read_file(folder.file("b.json")).find("\"packet_size\": 8"), std::string::npos);
    }
    expect_refused(folder, settings(R"("packet_size": 5)"), {"packet_size: 5 is not 4, 8 or 16"});
}

TEST(SessionFile, S09_NumbersHaveAPointInEveryLocale) {
    const TestFolder folder;
    expect_refused(folder, settings(R"("build": {"empty_cut": "0,5"})"), {R"(empty_cut: "0,5" is not a number)"});
    const std::string before = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // where the machine has it
    write_session(folder.file("a.json"), unlike_the_default());
    EXPECT_EQ(read_session(folder.file("a.json")), unlike_the_default());
    std::setlocale(LC_ALL, before.c_str());
}

TEST(SessionFile, S10_TheLastWriterWinsWithAWholeFile) {
    const TestFolder folder;
    write_session(folder.file("a.json"), Session{});
    write_session(folder.file("a.json"), unlike_the_default());
    EXPECT_EQ(read_session(folder.file("a.json")), unlike_the_default());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.json"});
}

TEST(SessionFile, SceneFilesBelowItsFolderMoveWithIt) {
    const TestFolder folder;
    const std::string square = std::string(KD_SOURCE_DIR) + "/tests/fixtures/app/large_square.gltf";
    const fs::path lesson = folder.file("lesson"), moved = folder.file("moved");
    fs::create_directories(lesson / "models");
    fs::copy(square, lesson / "models/a.gltf");
    const auto named = [](const fs::path& file) { return json::parse(read_file(file))["settings"]["scene"]; };
    Session session;
    session.scene = (lesson / "models/a.gltf").string();
    write_session(lesson / "1.session.json", session);
    EXPECT_EQ(named(lesson / "1.session.json"), "models/a.gltf");
    session.scene = square;
    write_session(lesson / "2.session.json", session);
    EXPECT_EQ(named(lesson / "2.session.json"), square);
    for (const char* name : {"ball:20", "stress:T16=1e-4", "lantern.gltf"}) {
        session.scene = name;
        write_session(lesson / "3.session.json", session);
        EXPECT_EQ(read_session(lesson / "3.session.json").scene, name);
    }
    fs::rename(lesson, moved);
    EXPECT_EQ(read_session(moved / "1.session.json").scene, (moved / "models/a.gltf").string());
    EXPECT_EQ(load_scene(read_session(moved / "1.session.json").scene, 1).triangles.size(), 2u);

    session.scene = "sc\xffne.gltf";
    EXPECT_THROW(write_session(moved / "4.session.json", session), InputError);
    EXPECT_FALSE(fs::exists(moved / "4.session.json"));
}

}  // namespace
}  // namespace kd

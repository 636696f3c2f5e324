// Parts of the window that need no display: camera moves, key table, file names.
#ifdef KD_WITH_WINDOW

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "app/camera_text.h"
#include "app/window/camera_moves.h"
#include "app/window/event_log.h"
#include "app/window/exporting.h"
#include "app/window/home_path.h"
#include "app/window/keys.h"
#include "app/window/plot.h"
#include "app/window/recent_files.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/scene/procedural.h"

namespace kd {
namespace {

namespace fs = std::filesystem;

const Camera start{.eye = Vec3(1, 2, 5), .target = Vec3(0.5f, 0, -1)};

float distance(const Camera& camera) { return glm::distance(camera.eye, camera.target); }

TEST(CameraMoves, OrbitKeepsTargetAndDistance) {
    Camera camera = start;
    for (int i = 0; i < 100; ++i) camera = orbit(camera, 0.13f, i % 2 ? 0.3f : -0.29f);
    EXPECT_EQ(camera.target, start.target);
    EXPECT_NEAR(distance(camera), distance(start), 1e-3f);
}

TEST(CameraMoves, AFullTurnComesBack) {
    Camera camera = start;
    for (int i = 0; i < 8; ++i) camera = orbit(camera, float(2 * M_PI / 8), 0);
    EXPECT_LT(glm::distance(camera.eye, start.eye), 1e-4f);
}

TEST(CameraMoves, OrbitNeverReachesThePole) {
    Camera camera = start;
    for (int i = 0; i < 50; ++i) camera = orbit(camera, 0, 0.5f);
    EXPECT_TRUE(is_valid(camera));
    const Vec3 view = glm::normalize(camera.target - camera.eye);
    EXPECT_GT(glm::length(glm::cross(view, camera.up)), 1e-3f);
}

TEST(CameraMoves, LookingAroundKeepsTheEyeAndFollowsTheMouse) {
    const Camera right = look_around(start, 0.2f, 0);
    const Camera down = look_around(start, 0, 0.2f);
    EXPECT_LT(glm::distance(right.eye, start.eye), 1e-6f);
    EXPECT_NEAR(distance(right), distance(start), 1e-4f);
    EXPECT_GT(glm::dot(right.target - start.target, pinhole(start, 1, 1).right), 0);
    EXPECT_LT(down.target.y, start.target.y);
}

TEST(CameraText, ComesBackAsItWas) {
    const Camera camera{.eye = Vec3(0.1f, 2, 5), .target = Vec3(1, 0, -1), .up = Vec3(0, 0, 1), .fov_y_degrees = 33.3f};
    EXPECT_EQ(parse_camera(camera_text(camera)), camera);
    EXPECT_EQ(parse_camera(R"({"eye":[0,0,3],"target":[0,0,0]})"), Camera{});
    for (const char* text : {"", "{}", "[1,2]", R"({"eye":[0,0],"target":[0,0,0]})",
                             R"({"eye":[0,0,0],"target":[0,0,0]})", R"({"eye":[0,0,3],"target":[0,0,0],"up":[0,0,0]})"})
        EXPECT_THROW((void)parse_camera(text), InputError) << text;
}

TEST(CameraMoves, PanMovesEyeAndTargetAlikeAcrossTheView) {
    const Camera camera = pan(start, 0.25f, 0);
    const Vec3 moved = camera.eye - start.eye;
    EXPECT_LT(glm::distance(moved, camera.target - start.target), 1e-5f);
    EXPECT_NEAR(glm::dot(moved, start.target - start.eye), 0, 1e-4f);
    EXPECT_NEAR(glm::length(moved), 0.25f * 2 * distance(start) * std::tan(0.5f * 45 * float(M_PI) / 180), 1e-4f);
}

TEST(CameraMoves, ZoomIsRefusedWhereItWouldEndInTheTarget) {
    EXPECT_NEAR(distance(zoom(start, 0.5f, 10)), 0.5f * distance(start), 1e-5f);
    EXPECT_EQ(zoom(start, 0, 10), start);
    EXPECT_EQ(zoom(start, std::numeric_limits<float>::quiet_NaN(), 10), start);
    EXPECT_EQ(look_at(start, start.eye), start);
}

TEST(CameraMoves, F11_AMillionStepsOfZoomStayWithinReachOfTheScene) {
    for (const float size : {1e-3f, 1.0f, 1e5f}) {
        Camera camera = start;
        for (int i = 0; i < 1'000'000; ++i) camera = zoom(camera, 0.9f, size);
        EXPECT_TRUE(is_valid(camera));
        EXPECT_GT(distance(camera), 0.9e-6f * size);
        for (int i = 0; i < 1'000'000; ++i) camera = zoom(camera, 1.1f, size);
        EXPECT_TRUE(is_valid(camera));
        EXPECT_LE(distance(camera), 1.1e6f * size);
        EXPECT_GT(distance(camera), 0.8e6f * size);
        for (int i = 0; i < 1'000'000; ++i) camera = zoom(camera, 0.9f, size);
        EXPECT_LT(distance(camera), 2e-6f * std::max(size, 10.0f)) << "and back";
    }
}

TEST(CameraMoves, F11_MovesThatAreNoNumbersLeaveTheCamera) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        EXPECT_EQ(orbit(start, bad, 0), start);
        EXPECT_EQ(look_around(start, bad, 0), start);
        EXPECT_EQ(pan(start, bad, 1), start);
        EXPECT_EQ(pan(start, 0, bad), start);
        EXPECT_EQ(fly(start, bad, 0, 0), start);
        EXPECT_EQ(fly(start, 0, 0, bad), start);
        EXPECT_EQ(look_at(start, Vec3(bad)), start);
        EXPECT_TRUE(is_valid(zoom(start, bad, 10)));
    }
    EXPECT_EQ(orbit(start, 0, std::numeric_limits<float>::quiet_NaN()), start);
}

TEST(CameraMoves, ThePixelInTheMiddleLooksAtTheTarget) {
    const Vec3 direction = pixel_direction(start, {50, 50}, 101, 101);
    EXPECT_LT(glm::distance(direction, glm::normalize(start.target - start.eye)), 1e-5f);
}

TEST(HomePath, IsWrittenWithATilde) {
    const char* home = std::getenv("HOME");
    if (!home) GTEST_SKIP() << "no home folder";
    EXPECT_EQ(home_short(fs::path(home) / "figures"), "~/figures");
    EXPECT_EQ(home_short(home), "~");
    EXPECT_EQ(home_short(fs::path(home).parent_path() / "no-home-of-mine"),
              (fs::path(home).parent_path() / "no-home-of-mine").string());
    EXPECT_EQ(home_long("~/figures"), fs::path(home) / "figures");
    EXPECT_EQ(home_long("~"), fs::path(home));
    EXPECT_EQ(home_long("~other/x"), "~other/x");
    EXPECT_EQ(home_long("figures"), "figures");
}

TEST(Tree, ThePapersRulesKeepTheCosts) {
    const BuildConfig paper = edits::papers_rules({.traversal_cost = 3});
    EXPECT_EQ(paper, (BuildConfig{.traversal_cost = 3, .empty_bonus_gate = 0, .trim_leaves = false}));
}

TEST(ProceduralScenes, SayWhetherASeedChangesThem) {
    for (const ProceduralScene& scene : procedural_scenes()) {
        const int size = std::min(scene.default_size, std::max(scene.smallest_size, 300));
        const auto triangles = [&](unsigned seed) { return flatten(scene.make(size, seed)).triangles; };
        EXPECT_EQ(triangles(1) != triangles(2), scene.seeded) << scene.name;
    }
    EXPECT_EQ(find_procedural("scatter:77")->name, "scatter");
    EXPECT_EQ(find_procedural("scatter.glb"), nullptr);
}

TEST(Keys, EachKeyMeansOneThing) {
    std::set<std::pair<int, int>> keys;
    std::set<std::string> labels;
    for (const KeyBinding& binding : key_bindings()) {
        EXPECT_TRUE(keys.insert({binding.key, binding.modifiers}).second) << binding.label;
        EXPECT_TRUE(labels.insert(binding.label).second) << binding.label;
        EXPECT_NE(std::string(binding.title), "");
    }
}

TEST(Keys, StandInTheManual) {
    const std::string page = read_file(std::string(KD_SOURCE_DIR) + "/docs/window.md");
    const auto expect_row = [&](const std::string& label, const std::string& title) {
        const std::string row = "| " + label + " | " + title + " |\n";
        EXPECT_NE(page.find(row), std::string::npos) << "docs/window.md lacks the row: " << row;
    };
    for (const KeyBinding& binding : key_bindings()) expect_row(binding.label, binding.title);
    for (const Gesture& gesture : gestures()) expect_row(gesture.label, gesture.title);
}

TEST(Keys, TraversalKeyGoesRoundWithoutTheNaiveOne) {
    EngineState state;
    Edit edit;
    std::set<Traversal> seen;
    const Traversal first = edit.session.trace.traversal;
    for (std::size_t i = 1; i < traversals().size(); ++i) {
        EXPECT_TRUE(apply_key('T', 0, state, edit));
        seen.insert(edit.session.trace.traversal);
    }
    EXPECT_EQ(seen.count(Traversal::naive), 0U);
    EXPECT_EQ(seen.size(), traversals().size() - 1);
    EXPECT_EQ(edit.session.trace.traversal, first) << "all the way round";
    EXPECT_FALSE(apply_key('T', 2 /* Ctrl */, state, edit)) << "left to the desktop";
}

TEST(Keys, TextGrowsAndShrinksWithCtrl) {
    EngineState state;
    Edit edit;
    constexpr int shift = 1, ctrl = 2;
    EXPECT_TRUE(apply_key('=', ctrl, state, edit));
    EXPECT_TRUE(apply_key('=', ctrl | shift, state, edit)) << "as most keyboards make a plus";
    EXPECT_FLOAT_EQ(edit.window.text_scale, 1.2f);
    for (int i = 0; i < 40; ++i) apply_key('-', ctrl, state, edit);
    EXPECT_FLOAT_EQ(edit.window.text_scale, least_text_scale);
    EXPECT_TRUE(apply_key('0', ctrl, state, edit));
    EXPECT_FLOAT_EQ(edit.window.text_scale, 1);
    EXPECT_FALSE(apply_key('=', 0, state, edit));
    edit.room_for_text = 1.3f;
    for (int i = 0; i < 40; ++i) apply_key('=', ctrl, state, edit);
    EXPECT_FLOAT_EQ(edit.window.text_scale, 1.3f) << "as far as the window has room";
}

TEST(Keys, HeatAndDivergenceRememberTheMap) {
    EngineState state;
    Edit edit;
    edits::choose_map(edit, "triangles");
    edits::show_divergence(edit);
    EXPECT_EQ(edit.session.view.map.map, "divergence");
    edits::show_heat(edit);
    EXPECT_EQ(edit.session.view.map.map, "triangles");
    edits::show_beauty(edit);
    EXPECT_FALSE(edit.session.view.show_map);
}

TEST(Edits, DivergenceGoesBackToWhatWasShown) {
    Edit edit;
    edits::show_map(edit, "leaves");
    edits::toggle_divergence(edit);
    EXPECT_EQ(edit.session.view.map.map, "divergence");
    edits::toggle_divergence(edit);
    EXPECT_EQ(edit.session.view.map.map, "leaves");
    EXPECT_TRUE(edit.session.view.show_map);
    edits::show_beauty(edit);
    edits::toggle_divergence(edit);
    EXPECT_TRUE(edit.session.view.show_map);
    edits::toggle_divergence(edit);
    EXPECT_FALSE(edit.session.view.show_map);
    edits::show_heat(edit);
    EXPECT_EQ(edit.session.view.map.map, "leaves");
}

TEST(Edits, RecentFilesComeFirstAndByTheirNames) {
    const fs::path folder = fs::path(KD_TEST_OUTPUT_DIR) / "app" / "recent-files";
    fs::remove_all(folder);
    std::vector<std::string> recent;
    for (const char* name : {"a/one.gltf", "a/two.gltf", "b/one.gltf", "a/two.gltf"}) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << "{}";
        add_recent(recent, (folder / name).string());
    }
    add_recent(recent, "ball:300");
    add_recent(recent, (folder / "missing.gltf").string());
    const std::string two = (folder / "a/two.gltf").string();
    ASSERT_EQ(recent, (std::vector{two, (folder / "b/one.gltf").string(), (folder / "a/one.gltf").string()}));

    const auto options = recent_options(recent, fs::relative(two).string());
    EXPECT_EQ(options[0].name, fs::relative(two).string()) << "the scene chosen goes by the name it was given";
    EXPECT_EQ(options[0].shown(), "two.gltf");
    EXPECT_EQ(options[0].summary, two);
    EXPECT_EQ(options[1].shown(), "one.gltf (b)");
    EXPECT_EQ(options[2].shown(), "one.gltf (a)");

    for (int i = 0; i < 20; ++i) {
        const fs::path file = folder / ("f" + std::to_string(i) + ".glb");
        std::ofstream(file) << "{}";
        add_recent(recent, file.string());
    }
    EXPECT_EQ(recent.size(), 8u);
    EXPECT_EQ(fs::path(recent.front()).filename(), "f19.glb");
}

TEST(Edits, SharesAndNamesHaveNoLogarithmicScale) {
    Edit edit;
    const auto log = [&] { return edit.session.view.heat.logarithmic; };
    edits::toggle_log(edit);
    EXPECT_TRUE(log());
    for (const char* map : {"revisit-share", "exit", "divergence"}) {
        edits::show_map(edit, map);
        EXPECT_FALSE(log()) << map;
        edits::toggle_log(edit);
        EXPECT_FALSE(log()) << map;
    }
    edits::show_map(edit, "t");
    EXPECT_TRUE(log()) << "the wish is kept for maps that can have it";
    edits::toggle_log(edit);
    edits::show_map(edit, "leaves");
    EXPECT_FALSE(log());
}

TEST(Plot, ScalesAreRound) {
    EXPECT_FLOAT_EQ(plot::round_up(0), 1);
    EXPECT_FLOAT_EQ(plot::round_up(3.2f), 5);
    EXPECT_FLOAT_EQ(plot::round_up(51), 100);
    EXPECT_FLOAT_EQ(plot::round_up(0.011f), 0.02f);
    EXPECT_FLOAT_EQ(plot::round_up(20), 20);
}

TEST(Plot, OneSlowRoundDoesNotSetTheScale) {
    std::vector<float> values(40, 50.0f);
    EXPECT_FLOAT_EQ(plot::scale_of({{0, values}}), 50);
    values[7] = 80;
    EXPECT_FLOAT_EQ(plot::scale_of({{0, values}}), 100) << "it is in the picture";
    values[7] = 2000;
    EXPECT_FLOAT_EQ(plot::scale_of({{0, values}}), 100) << "it is not, and marked";
    EXPECT_FLOAT_EQ(plot::scale_of({{0, values}, {0, std::vector<float>(40, 400.0f)}}), 1000);
    EXPECT_FLOAT_EQ(plot::scale_of({{0, {}}, {0, {3, 4}}}), 5);
}

TEST(Export, NamesCountUpOverAllKinds) {
    const fs::path folder = fs::path(KD_TEST_OUTPUT_DIR) / "export names";
    fs::remove_all(folder);
    fs::create_directories(folder);
    EXPECT_EQ(next_file(folder, ".png").filename(), "kdscope-1.png");
    std::ofstream(folder / "kdscope-1.csv") << "x";
    EXPECT_EQ(next_file(folder, ".png").filename(), "kdscope-2.png");
    std::ofstream(folder / "kdscope-3.png") << "x";
    EXPECT_EQ(next_file(folder, ".json").filename(), "kdscope-2.json");
    std::ofstream(folder / "kdscope-2.session.json") << "x";
    EXPECT_EQ(next_file(folder, ".png").filename(), "kdscope-4.png");
}

TEST(EventLog, AnEventIsAnsweredByAPictureOfItsSession) {
    const fs::path file = fs::path(KD_TEST_OUTPUT_DIR) / "events.csv";
    {
        EventLog log(file.string());
        Picture picture;
        picture.generation = 4;
        log.input("move", 1000);
        log.presented(&picture, 1010);  // not applied yet
        log.applied(4);
        log.input("key", 2000);
        log.presented(&picture, 2062.5);  // answers the move alone
        log.applied(5);
        log.presented(&picture, 2070);
        picture.generation = 5;
        log.presented(&picture, 2125);
        log.input("scroll", 3000);  // never answered
    }
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(text, "event,kind,t_event_ms,t_first_frame_ms,t_frame_ms,latency_ms\n"
                    "1,move,1000.00,2062.50,2062.50,1062.50\n"
                    "2,key,2000.00,2070.00,2125.00,125.00\n"
                    "3,scroll,3000.00,,,\n");
    EXPECT_THROW(EventLog("/no/such/folder/events.csv"), InputError);
}

}  // namespace
}  // namespace kd

#endif

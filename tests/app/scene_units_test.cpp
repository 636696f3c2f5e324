// A scene 2^20 times as large as usual is kept in other units inside; people and files see its own.

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/engine/engine.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "tests/app/cli_run.h"
#include "viz/figure.h"

namespace kd {
namespace {

using nlohmann::json;
using test::run_kdscope;
using test::TestFolder;

constexpr float large = 0x1p20f;
const std::string square = std::string(KD_SOURCE_DIR) + "/tests/fixtures/app/large_square.gltf";

/// A field of a CSV table: the row (0 is the header), and the column by name.
std::string field(const std::string& table, std::size_t row, const std::string& column) {
    std::istringstream lines(table);
    std::string header, line;
    std::getline(lines, header);
    for (std::size_t i = 0; i < row; ++i) std::getline(lines, line);
    std::istringstream names(header), values(line);
    for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');)
        if (name == column) return value;
    return "";
}

TEST(SceneUnits, FilesOfAPictureHaveThem) {
    const TestFolder folder;
    const auto outcome = run_kdscope({"render", square, "-o", folder.file("a.png"), "--size", "33x33", "--map", "t",
                                      "--json", folder.file("a.json"), "--csv", folder.file("a.csv")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json summary = json::parse(read_file(folder.file("a.json")));
    EXPECT_EQ(summary["settings"]["camera"]["eye"], json::parse("[0, 0, 3145728]"));
    const std::size_t middle = 1 + 16 * 33 + 16;
    EXPECT_FLOAT_EQ(std::stof(field(read_file(folder.file("a.csv")), middle, "primary_t")), 3 * large);
    const PngText text = read_png_text(folder.file("a.png"));
    EXPECT_NE(text.at("kdscope-settings").find("3145728"), std::string::npos);
    EXPECT_NE(text.at("Description").find("camera \"0,0,3145728 "), std::string::npos) << text.at("Description");
}

TEST(SceneUnits, TheCameraOfACaptionMakesTheSamePicture) {
    const TestFolder folder;
    const auto picture = [&](const std::string& name, std::vector<std::string> more) {
        more.insert(more.begin(), {"render", square, "-o", folder.file(name), "--size", "33x33"});
        EXPECT_EQ(run_kdscope(more).code, 0);
        return read_png(folder.file(name));
    };
    const std::string camera = "100000,0,2500000 0,0,0 0,1,0 40";
    const Image<Rgba8> first = picture("a.png", {"--camera", camera});
    const std::string caption = read_png_text(folder.file("a.png")).at("Description");
    const std::size_t from = caption.find("camera \"") + 8;
    EXPECT_EQ(picture("b.png", {"--camera", caption.substr(from, caption.find('"', from) - from)}), first);
    EXPECT_NE(picture("c.png", {}), first);
}

TEST(SceneUnits, MapLegendAndPixelShowThem) {
    Session session;
    session.scene = square;
    session.width = session.height = 33;
    session.view.map.map = "t";
    EngineOptions options;
    options.duel = false;
    Engine engine(session, std::move(options));
    engine.set_probes(PixelPosition{16, 16}, {});
    engine.wait_for_picture(10);
    for (int i = 0; i < 100 && engine.state().stale(); ++i) engine.wait_for_picture(0.1);
    const EngineState& state = engine.state();
    ASSERT_TRUE(state.picture && state.picture->map && state.hovered);
    EXPECT_NE(state.world->scene().exponent, 0);
    EXPECT_FLOAT_EQ(state.picture->map->summary.min, 3 * large);
    EXPECT_GE(state.picture->map->summary.range.max, 3 * large);
    EXPECT_FLOAT_EQ(state.hovered->primary().distance, 3 * large);
    EXPECT_FLOAT_EQ(state.hovered->primary().hit.t, std::ldexp(3 * large, -state.world->scene().exponent));
}

}  // namespace
}  // namespace kd

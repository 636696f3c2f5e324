// render and gallery: the files they write, and those that they leave alone.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"
#include "tests/app/cli_run.h"
#include "viz/colormap.h"
#include "viz/map.h"

namespace kd {
namespace {

using nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using Words = std::vector<std::string>;

TEST(Render, BeautyIsThePictureItself) {
    const TestFolder folder;
    const test::Outcome outcome = run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "40x30"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Image<Rgba8> image = read_png(folder.file("a.png"));
    EXPECT_EQ(image.width, 40);
    EXPECT_EQ(image.height, 30);
    EXPECT_GT(image.at(20, 25).r, 60);  // the lit floor
    EXPECT_NE(outcome.out.find("left out"), std::string::npos) << outcome.out;
    EXPECT_EQ(folder.names(), Words{"a.png"});
}

TEST(Render, MapHasLegendUnlessRefused) {
    const TestFolder folder;
    const Words common{"render", "cornell", "--size", "40x30", "--map", "nodes", "-o"};
    Words with = common, without = common;
    with.push_back(folder.file("with.png"));
    without.insert(without.end(), {folder.file("without.png"), "--no-legend"});
    ASSERT_EQ(run_kdscope(with).code, 0);
    ASSERT_EQ(run_kdscope(without).code, 0);
    EXPECT_GT(read_png(folder.file("with.png")).width, 200);
    EXPECT_EQ(read_png(folder.file("without.png")).width, 40);
}

TEST(Render, PictureCarriesItsSettings) {
    const TestFolder folder;
    ASSERT_EQ(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "32x32", "--map", "leaves",
                           "--traversal", "restart", "--eye", "0,1,4.5", "--builder", "spatial-median", "--seed", "7"})
                  .code,
              0);
    const PngText text = read_png_text(folder.file("a.png"));
    const json settings = json::parse(text.at("kdscope-settings"));
    EXPECT_EQ(settings["scene"], "cornell");
    EXPECT_EQ(settings["traversal"], "restart");
    EXPECT_EQ(settings["build"]["builder"], "spatial-median");
    EXPECT_EQ(settings["seed"], 7);
    EXPECT_EQ(settings["camera"]["eye"], json::parse("[0, 1, 4.5]"));
    EXPECT_EQ(settings["view"]["map"]["name"], "leaves");
    EXPECT_NE(text.at("Description").find("cornell"), std::string::npos);
    EXPECT_NE(text.at("Description").find(" ms "), std::string::npos);
}

/// The counters of a JSON object, summed anew from those of single rays; the deepest stack is a maximum.
void expect_sums(const json& found, std::span<const RayCounters> rays, const std::string& what) {
    for (const CounterInfo& counter : counter_table()) {
        std::uint64_t sum = 0, largest = 0;
        for (const RayCounters& ray : rays) {
            sum += ray.*counter.field;
            largest = std::max<std::uint64_t>(largest, ray.*counter.field);
        }
        const bool is_maximum = counter.field == &RayCounters::stack_depth;
        EXPECT_EQ(found[std::string(counter.name)], is_maximum ? largest : sum) << what << ": " << counter.name;
    }
}

TEST(Render, JsonCountersAreThoseOfTheRays) {
    const TestFolder folder;
    ASSERT_EQ(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "32x24", "--traversal", "restart",
                           "--json", folder.file("a.json")})
                  .code,
              0);
    const json counters = json::parse(read_file(folder.file("a.json")))["counters"];

    const FlatScene scene = flatten(*make_procedural("cornell"));
    const KdTree tree = build_tree(scene.triangles, {});
    const PinholeCamera camera = pinhole(scene.camera, 32, 24);
    TraceConfig config;
    config.traversal = Traversal::restart;
    CpuTracer tracer(scene, tree);

    // Primary rays one by one, without frames and passes.
    const std::vector<Ray> rays = pixel_rays(camera, 32, 24);
    std::vector<Hit> hits(rays.size());
    std::vector<RayCounters> walks(rays.size());
    tracer.trace_rays(config, rays, false, hits, walks);
    expect_sums(counters["primary"], walks, "primary");
    EXPECT_EQ(counters["primary"]["rays"], rays.size());
    EXPECT_GT(counters["primary"]["restarts"], 0);

    // A ray from every pixel that shows the mirror.
    const auto shows_mirror = [&](const Hit& hit) {
        if (hit.triangle < 0) return false;
        const int material = scene.attributes[std::size_t(hit.triangle)].material;
        return scene.materials[std::size_t(material)].reflectance != Vec3(0);
    };
    EXPECT_EQ(counters["reflection"]["rays"], std::ranges::count_if(hits, shows_mirror));

    Frame frame(32, 24);
    ASSERT_TRUE(tracer.trace_frame(config, camera, frame));
    expect_sums(counters["shadow"], frame.layer(Pass::shade_prim).counters.pixels, "shadow");
    expect_sums(counters["reflection"], frame.layer(Pass::rt_refl).counters.pixels, "reflection");
    expect_sums(counters["reflection_shadow"], frame.layer(Pass::shade_refl).counters.pixels, "reflection shadow");
}

TEST(Render, OracleCountsWhatIsWrong) {
    const TestFolder folder;
    const auto oracle = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{
            "render", "rooms", "-o", folder.file("o.png"), "--json", folder.file("o.json"), "--size", "64x64"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const test::Outcome outcome = run_kdscope(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return std::pair(outcome.out, json::parse(read_file(folder.file("o.json"))));
    };
    const auto [right, robust] = oracle({"--map", "oracle"});
    EXPECT_NE(right.find("oracle    0 wrong of 4096 primary rays; 0 of n means below 3/n"), std::string::npos) << right;
    EXPECT_EQ(robust["oracle"]["agrees"], 4096);
    EXPECT_EQ(robust["oracle"]["wrong"], 0);
    const auto [wrong, published] = oracle({"--map", "t-error", "--log", "--rules", "as-published"});
    EXPECT_GT(published["oracle"]["missed"], 0);
    EXPECT_EQ(published["oracle"]["wrong"].get<int>() + published["oracle"]["agrees"].get<int>() +
                  published["oracle"]["tie"].get<int>(),
              published["oracle"]["compared"].get<int>());
    EXPECT_NE(wrong.find(std::to_string(published["oracle"]["missed"].get<int>()) + " missed"), std::string::npos);
    EXPECT_FALSE(oracle({"--map", "nodes"}).second.contains("oracle")) << "costs only where asked for";
    EXPECT_EQ(oracle({"--map", "oracle", "--rays", "reflection"}).second["oracle"]["compared"], 0);
    EXPECT_EQ(run_kdscope({"render", "rooms", "-o", folder.file("p.png"), "--map", "oracle", "--rays", "shadow"}).code,
              2);
}

TEST(Render, JsonDescribesThePicture) {
    const TestFolder folder;
    const test::Outcome outcome =
        run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "32x24", "--json",
                     folder.file("a.json"), "--csv", folder.file("a.csv"), "--exr", folder.file("a.exr")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json data = json::parse(read_file(folder.file("a.json")));
    for (const char* rays : {"primary", "shadow", "reflection", "reflection_shadow"})
        EXPECT_GT(data["counters"][rays]["rays"], 0) << rays;
    EXPECT_EQ(data["scene"]["triangles"], 34);
    EXPECT_EQ(data["tree"]["leaves"].get<int>(), data["tree"]["interior"].get<int>() + 1);
    EXPECT_GE(data["ms"]["build"], 0);
    EXPECT_GT(data["ms"]["trace"], 0);
    EXPECT_TRUE(data["renderer"].is_string());
    for (const char* fact : {"date", "cpu", "commit", "compiler", "flags"})
        EXPECT_FALSE(data["measured_on"][fact].get<std::string>().empty()) << fact;
    EXPECT_FALSE(data["left_out"].empty());
    EXPECT_NE(outcome.out.find(folder.file("a.csv") + " (768 rows)\n"), std::string::npos) << outcome.out;
    const std::string csv = read_file(folder.file("a.csv"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 32 * 24 + 1);
    EXPECT_EQ(folder.names(), (Words{"a.csv", "a.exr", "a.json", "a.png"}));
}

TEST(Render, OptionsChangeWhatIsTraced) {
    const TestFolder folder;
    const auto rays = [&](const Words& more, const char* kind) {
        Words arguments{"render", "cornell", "-o",     folder.file("a.png"),
                        "--size", "32x32",   "--json", folder.file("a.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(run_kdscope(arguments).code, 0);
        return json::parse(read_file(folder.file("a.json")))["counters"][kind]["rays"].get<int>();
    };
    EXPECT_EQ(rays({"--no-shadows"}, "shadow"), 0);
    EXPECT_EQ(rays({"--reflection-depth", "0"}, "reflection"), 0);
    EXPECT_EQ(rays({"--min-contribution", "1"}, "reflection"), 0);
    EXPECT_GT(rays({}, "reflection"), 0);
}

TEST(C07, RenderTellsBadOutputsBeforeTheWork) {
    const TestFolder folder;
    const auto refused = [&](const Words& outputs, const Words& words) {
        Words arguments{"render", "ball:2000000"};
        arguments.insert(arguments.end(), outputs.begin(), outputs.end());
        const test::Outcome outcome = run_kdscope(arguments);
        expect_usage_error(outcome, words);
        EXPECT_EQ(outcome.out, "");
    };
    refused({"-o", folder.file("none/a.png")}, {"--output", "none/a.png", "no folder"});
    refused({"-o", folder.file("a.jpg")}, {"--output", "a.jpg", ".png"});
    std::filesystem::create_directory(folder.file("dir.png"));
    refused({"-o", folder.file("dir.png")}, {"--output", "is a directory"});
    refused({"-o", folder.file("a.png"), "--json", folder.folder()}, {"--json", "is a directory"});
    refused({"-o", folder.file(std::string(300, 'a') + ".png")}, {"--output", "too long"});
    if (std::filesystem::exists("/dev/full"))
        for (const char* option : {"--json", "--csv", "--exr"})
            refused({"-o", folder.file("a.png"), option, "/dev/full"}, {option, "/dev/full", "No space left"});
    if (std::filesystem::exists("/proc/self"))  // root may write there by its permissions, and still cannot
        refused({"-o", "/proc/a.png"}, {"--output", "/proc/a.png", "another folder"});
    EXPECT_EQ(folder.names(), Words{"dir.png"});
}

TEST(C10, OutputsMustDiffer) {
    const TestFolder folder;
    const auto refused = [&](const Words& outputs, const Words& words) {
        Words arguments{"render", "ball:2000000", "-o", folder.file("a.png")};
        arguments.insert(arguments.end(), outputs.begin(), outputs.end());
        expect_usage_error(run_kdscope(arguments), words);
    };
    refused({"--csv", folder.file("a.png")}, {"--csv", "--output writes it too"});
    refused({"--csv", folder.folder() + "/./a.png"}, {"--csv", "--output writes it too"});
    refused({"--json", folder.file("n"), "--exr", folder.file("n")}, {"--exr", "--json writes it too"});
    std::ofstream(folder.file("n")) << "kept";
    std::filesystem::create_symlink("n", folder.file("link"));
    refused({"--json", folder.file("n"), "--exr", folder.file("link")}, {"--exr", "--json writes it too"});
    EXPECT_EQ(folder.names(), (Words{"link", "n"}));
    EXPECT_EQ(read_file(folder.file("n")), "kept");
    EXPECT_EQ(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "8x8", "--csv", "/dev/null",
                           "--json", "/dev/null"})
                  .code,
              0);
}

TEST(C10, MapsThatCannotBeDrawnAreToldBeforeTheWork) {
    const TestFolder folder;
    const test::Outcome outcome =
        run_kdscope({"render", "ball:2000000", "-o", folder.file("a.png"), "--map", "divergence", "--tile", "500x500"});
    expect_usage_error(outcome, {"tile", "500x500", "1024"});
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Render, PicturesLargerThanMemoryAreRefused) {
    std::ifstream meminfo("/proc/meminfo");
    std::string word;
    double kilobytes = 0;
    if (!(meminfo >> word >> kilobytes) || kilobytes * 1024 > 50e9) GTEST_SKIP() << "too much memory, or not known";
    const TestFolder folder;
    expect_usage_error(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "16384x16384"}),
                       {"--size", "16384x16384", "GB"});
}

TEST(C08, RenderDoesNotOverwriteItsOwnScene) {
    const TestFolder folder;
    std::filesystem::copy_file(std::string(KD_SOURCE_DIR) + "/assets/scenes/lantern.gltf", folder.file("s.gltf"));
    const std::string before = read_file(folder.file("s.gltf"));
    expect_usage_error(
        run_kdscope({"render", folder.file("s.gltf"), "-o", folder.file("a.png"), "--csv", folder.file("s.gltf")}),
        {"--csv", "scene's own file"});
    EXPECT_EQ(read_file(folder.file("s.gltf")), before);
}

TEST(Render, StopLeavesNoFile) {
    const TestFolder folder;
    std::stop_source stop;
    stop.request_stop();
    const test::Outcome outcome =
        run_kdscope({"render", "ball:1000", "-o", folder.file("a.png"), "--size", "512x512"}, stop.get_token());
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(outcome.err, "kdscope: interrupted\n");
    EXPECT_TRUE(folder.names().empty());
}

/// The place of `part` in `whole`; nothing where it is not in it.
std::optional<std::pair<int, int>> find_image(const Image<Rgba8>& whole, const Image<Rgba8>& part) {
    const auto same_row = [&](int x, int y, int row) {
        for (int i = 0; i < part.width; ++i)
            if (whole.at(x + i, y + row) != part.at(i, row)) return false;
        return true;
    };
    for (int y = 0; y + part.height <= whole.height; ++y)
        for (int x = 0; x + part.width <= whole.width; ++x) {
            int row = 0;
            while (row < part.height && same_row(x, y, row)) ++row;
            if (row == part.height) return std::pair(x, y);
        }
    return std::nullopt;
}

/// Pixels of about this colour from column `from_x` on.
std::ptrdiff_t count_beside(const Image<Rgba8>& figure, int from_x, Rgba8 colour) {
    constexpr int tolerance = 4;  // the bar's rows stand for the middles of their values
    const auto alike = [](int a, int b) { return std::abs(a - b) <= tolerance; };
    std::ptrdiff_t count = 0;
    for (int y = 0; y < figure.height; ++y)
        for (int x = from_x; x < figure.width; ++x) {
            const Rgba8 c = figure.at(x, y);
            count += alike(c.r, colour.r) && alike(c.g, colour.g) && alike(c.b, colour.b);
        }
    return count;
}

class Gallery : public testing::Test {
  protected:
    static constexpr int width = 96, height = 72;
    TestFolder folder;

    /// What `render` draws without title and legend.
    Image<Rgba8> bare(const std::string& scene, const Words& options) {
        Words arguments{"render", scene, "-o", folder.file("bare.png"), "--size", "96x72", "--no-legend"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(run_kdscope(arguments).code, 0);
        return read_png(folder.file("bare.png"));
    }
};

TEST_F(Gallery, WritesAndNamesSixteenDifferentPictures) {
    const test::Outcome outcome = run_kdscope({"gallery", "-o", folder.file("new/out"), "--size", "96x72"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream paths(outcome.out);
    std::vector<std::pair<std::string, Image<Rgba8>>> pictures;
    for (std::string path; std::getline(paths, path);) pictures.emplace_back(path, read_png(path));
    ASSERT_EQ(pictures.size(), 16u);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_NE(pictures[i].second.pixels, pictures[k].second.pixels)
                << pictures[i].first << " " << pictures[k].first;

    for (const auto& [path, image] : pictures) {
        const bool is_beauty = path.ends_with("-beauty.png");
        EXPECT_EQ(image.width == width && image.height == height, is_beauty) << path;
        EXPECT_EQ(read_png_text(path).at("kdscope-settings").empty(), false) << path;
    }
}

TEST_F(Gallery, PicturesHoldWhatTheirNamesSay) {
    ASSERT_EQ(run_kdscope({"gallery", "-o", folder.folder(), "--size", "96x72"}).code, 0);
    const auto picture = [&](const std::string& name) { return read_png(folder.file(name + ".png")); };
    EXPECT_EQ(picture("rooms-beauty").pixels, bare("rooms", {}).pixels);

    const auto expect_figure = [&](const std::string& name, const Image<Rgba8>& content, const std::string& title) {
        const Image<Rgba8> figure = picture(name);
        const auto place = find_image(figure, content);
        ASSERT_TRUE(place) << name;
        EXPECT_GT(figure.width, content.width + 40) << name << " has room for a legend";
        EXPECT_NE(read_png_text(folder.file(name + ".png")).at("Title").find(title), std::string::npos) << name;
    };
    const auto title = [](const char* map) { return std::string(find_map(map)->title.substr(1)); };
    expect_figure("rooms-nodes", bare("rooms", {"--map", "nodes"}), title("nodes"));
    expect_figure("rooms-divergence", bare("rooms", {"--map", "divergence"}), title("divergence"));
    expect_figure("rooms-splits", bare("rooms", {"--overlay", "--overlay-depth", "10"}), "Splits");

    // The legend's bar runs through the whole colour map.
    const Image<Rgba8> nodes = picture("rooms-nodes");
    const int beside = find_image(nodes, bare("rooms", {"--map", "nodes"})).value_or(std::pair(0, 0)).first + width;
    for (const float position : {0.0f, 1.0f})
        EXPECT_GT(count_beside(nodes, beside, get_colormap("viridis")(position)), 0) << position;
}

TEST_F(Gallery, RefusesAFileAsFolder) {
    std::ofstream(folder.file("taken")) << "x";
    expect_usage_error(run_kdscope({"gallery", "-o", folder.file("taken")}), {"--output", "taken"});
}

}  // namespace
}  // namespace kd

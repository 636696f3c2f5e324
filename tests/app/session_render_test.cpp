// Pictures made from session files.

#include <nlohmann/json.hpp>

#include "app/session_file.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "tests/app/cli_run.h"
#include "tests/app/session_samples.h"

namespace kd {
namespace {

using nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using test::unlike_the_default;

/// The settings that a file holds, or those that a picture was made with.
json settings_in(const std::string& file) { return json::parse(read_file(file))["settings"]; }

TEST(SessionRender, TakesEveryFieldFromTheFile) {
    const TestFolder folder;
    Session session = unlike_the_default();
    session.width = session.height = 8;
    session.threads = 2;
    session.tracer = TracerKind::cpu;  // the other needs OpenGL
    session.build.leaf_size = 3;       // else the tree is one leaf
    const std::string file = folder.file("a.session.json");
    write_session(file, session);
    const auto outcome = run_kdscope({"render", file, "-o", folder.file("a.png"), "--json", folder.file("a.json")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(settings_in(folder.file("a.json")), settings_in(file));
}

TEST(SessionRender, MakesThePictureThatOptionsMake) {
    const TestFolder folder;
    Session session;
    session.scene = "cornell";
    session.width = 40;
    session.height = 30;
    session.trace.traversal = Traversal::restart;
    session.camera = Camera{Vec3(0.25f, 1, 4), Vec3(0, 1, 0), Vec3(0, 1, 0), 40};
    session.view.map.map = "leaves";
    session.view.heat.opacity = 1;
    const std::string file = folder.file("a.session.json");
    write_session(file, session);
    ASSERT_EQ(
        run_kdscope({"render", file, "-o", folder.file("a.png"), "--json", folder.file("a.json"), "--no-legend"}).code,
        0);
    ASSERT_EQ(run_kdscope({"render", "cornell", "-o", folder.file("b.png"), "--json", folder.file("b.json"), "--size",
                           "40x30", "--no-legend", "--traversal", "restart", "--map", "leaves", "--camera",
                           "0.25,1,4 0,1,0 0,1,0 40"})
                  .code,
              0);
    const json a = json::parse(read_file(folder.file("a.json"))), b = json::parse(read_file(folder.file("b.json")));
    EXPECT_EQ(a["settings"], b["settings"]);
    EXPECT_EQ(a["counters"], b["counters"]);
    EXPECT_EQ(read_png(folder.file("a.png")).pixels, read_png(folder.file("b.png")).pixels);

    ASSERT_EQ(run_kdscope({"render", file, "-o", folder.file("d.png"), "--json", folder.file("d.json"), "--size",
                           "20x15", "--threads", "1"})
                  .code,
              0);
    json larger = settings_in(folder.file("d.json"));
    EXPECT_EQ(larger["width"], 20);
    EXPECT_EQ(larger["height"], 15);
    EXPECT_EQ(larger["threads"], 1);
    for (const char* key : {"width", "height", "threads"}) larger[key] = a["settings"][key];
    EXPECT_EQ(larger, a["settings"]);

    expect_usage_error(run_kdscope({"render", file, "-o", folder.file("c.png"), "--map", "t", "--seed", "2"}),
                       {"--map, --seed", "session file"});
    for (const char* command : {"stats", "bench", "verify"})
        expect_usage_error(run_kdscope({command, file}), {"a.session.json: a session file", "view and render"});
    expect_usage_error(run_kdscope({"view", file, "--builder", "exact"}), {"--builder", "session file"});
    write_file(file, "{}");
    expect_usage_error(run_kdscope({file}), {"a.session.json: not a session file"});
    expect_usage_error(run_kdscope({"render", file, "-o", folder.file("c.png"), "--map", "t"}), {"not a session file"});
    expect_usage_error(run_kdscope({folder.file("none.json")}), {"none.json", "does not exist"});
}

TEST(SessionRender, ItsLargestLeafIsOneThatBuildersTake) {
    const TestFolder folder;
    write_file(folder.file("a.json"),
               R"({"kdscope_session": 1, "settings": {"scene": "cornell", "width": 8, "height": 8,
                                           "build": {"leaf_size": 1048576}}})");
    const auto outcome = run_kdscope({"render", folder.file("a.json"), "-o", folder.file("a.png")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

}  // namespace
}  // namespace kd

#include "app/figure_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kd {
namespace {

TEST(FigureText, CaptionNamesAllThatWasChosenAndWhatItTook) {
    FigureFacts facts;
    facts.scene = "ball:9000";
    facts.triangles = 9010;
    facts.trace.traversal = Traversal::restart;
    facts.tracer = TracerKind::gl_fragment;
    facts.renderer = "llvmpipe";
    facts.software_gl = true;
    facts.width = 640;
    facts.height = 480;
    facts.milliseconds = 12.34;
    facts.clock = "timer queries";
    const std::string caption = caption_of(facts);
    EXPECT_EQ(
        caption.substr(0, caption.rfind(';')),
        "ball:9000, 9\u2009010 triangles; paper tree (t_t 1, t_i 1.5, b_e 0.2 gate 0.1, leaf 2); restart traversal, "
        "robust rules, leaf lists of references; gl-fragment on llvmpipe (software, not a GPU); 640 × 480 in 12.3 ms "
        "(timer queries)");
    EXPECT_NE(caption.find("; kdscope "), std::string::npos);

    facts.build.trim_leaves = false;
    facts.software_gl = false;
    facts.clock.clear();
    const std::string other = caption_of(facts);
    EXPECT_NE(other.find("leaf 2, box leaves)"), std::string::npos) << other;
    EXPECT_NE(other.find("llvmpipe; 640"), std::string::npos) << other;
    EXPECT_NE(other.find("12.3 ms; kdscope"), std::string::npos) << other;
}

TEST(FigureText, TitleSaysWhatIsShown) {
    ViewConfig view;
    EXPECT_EQ(title_of("rooms", view), "Interior nodes visited, primary rays");
    view.map.rays = Pass::shade_prim;
    view.map.map = "t";
    EXPECT_EQ(title_of("rooms", view), "Distance to the hit, shadow rays");
    view.show_map = false;
    EXPECT_EQ(title_of("folder/model.glb", view), "folder/model.glb") << "a name is kept as it is";
    view.overlay.show = true;
    EXPECT_EQ(title_of("rooms", view), "Splits of the kd-tree down to depth 6");
}

TEST(FigureText, FilesCarryTheirSettings) {
    Session session;
    session.scene = "sc\xffne";  // a file's name need not be UTF-8
    ViewConfig view;
    view.map.map = "leaves";
    const PngText text = png_text("a title", "a caption", session, view);
    EXPECT_EQ(text.at("Title"), "a title");
    EXPECT_EQ(text.at("Description"), "a caption");
    const auto settings = nlohmann::json::parse(text.at("kdscope-settings"));
    EXPECT_EQ(settings["view"]["map"]["name"], "leaves");
    EXPECT_EQ(settings["traversal"], "stack");
}

}  // namespace
}  // namespace kd

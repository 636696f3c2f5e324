#include "app/report/figure_text.h"

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
        "robust rules, leaf lists of references, defaults elsewhere; gl-fragment on llvmpipe (software, not a GPU); "
        "640 × 480 in 12.3 ms "
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

TEST(FigureText, CaptionSaysWhereInItsMotionASceneIs) {
    FigureFacts facts;
    facts.scene = "sheet:20000";
    facts.duration = 4.0;
    EXPECT_TRUE(caption_of(facts).starts_with("sheet:20000, ")) << "at 0 it is the scene of that name";
    facts.time = 0.5;
    EXPECT_TRUE(caption_of(facts).starts_with("sheet:20000 at 0.5 s of 4 s, ")) << caption_of(facts);
}

TEST(FigureText, CaptionNamesWhatDiffersFromTheDefault) {
    FigureFacts facts;
    EXPECT_NE(caption_of(facts).find("leaf lists of references, defaults elsewhere;"), std::string::npos);
    facts.trace.shadows = false;
    facts.trace.reflection_depth = 3;
    facts.trace.least_contribution = 0.25f;
    facts.early_z = EarlyZ::as_published;  // which the CPU does not have
    facts.seed = 7;
    facts.camera = Camera{.eye = Vec3(1, 2, 3.5f)};
    facts.build.max_depth = 9;
    facts.build.bad_refines = 5;
    facts.build.reference_cap = 12;
    const std::string differences =
        "leaf lists of references, no shadows, bounces 3, least contribution 0.25{}, seed 7, camera \"1,2,3.5 0,0,0 "
        "0,1,0 45\", defaults elsewhere;";
    const auto with = [&](const std::string& early_z) {
        std::string text = differences;
        return text.replace(text.find("{}"), 2, early_z);
    };
    EXPECT_NE(caption_of(facts).find(with("")), std::string::npos) << caption_of(facts);
    EXPECT_NE(caption_of(facts).find("max depth 9, bad refines 5, reference cap 12)"), std::string::npos);
    facts.trace.nodes = NodeEncoding::packed;
    EXPECT_NE(caption_of(facts).find("leaf lists of references, nodes of 8 bytes, no shadows"), std::string::npos)
        << caption_of(facts);
    facts.trace.nodes = NodeEncoding::float4;
    facts.build.builder = "binned";
    EXPECT_NE(caption_of(facts).find("leaf 2, 32 bins, max depth 9"), std::string::npos) << caption_of(facts);
    facts.tracer = TracerKind::gl_fragment;
    EXPECT_NE(caption_of(facts).find(with(", early z as published")), std::string::npos) << caption_of(facts);
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
    view.overlay.colour = CellColour::ratio;
    EXPECT_EQ(title_of("rooms", view),
              "Splits of the kd-tree down to depth 6, by visits of shadow rays over predicted");
    view.overlay.colour = CellColour::predicted;
    EXPECT_EQ(title_of("rooms", view), "Splits of the kd-tree down to depth 6, by visits predicted");
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

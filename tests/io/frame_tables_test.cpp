#include <cstdlib>
#include <memory>
#include <sstream>
#include <tinyexr.h>

#include "renderer/io/tables.h"
#include "renderer/trace/counters.h"
#include "tests/io/scratch.h"

namespace kd {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

Frame small_frame() {
    Frame frame(3, 2);
    RayLayer& primary = frame.layer(Pass::rt_prim);
    primary.hit.at(1, 0) = {7, 0.1f, 0.25f, 1.0f / 3.0f};
    primary.counters.at(1, 0) = {1, 2, 3, 4, 5, 6, 8, KD_EXIT_HIT, 9};
    primary.hit.at(0, 1).t = KD_T_LIMIT;
    primary.counters.at(2, 1).exit_reason = KD_EXIT_STEP_CAP;
    for (Vec4& colour : frame.colour.pixels) colour.w = 1;  // traced
    frame.colour.at(2, 0).w = 0;
    return frame;
}

TEST(FrameCsv, HasARowPerPixelFromTheTop) {
    const std::vector<std::string> lines = lines_of(frame_csv(small_frame()));
    ASSERT_EQ(lines.size(), 7u);
    EXPECT_EQ(lines[0],
              "x,y,primary_triangle,primary_t,primary_u,primary_v,primary_interior_first,primary_interior_again,"
              "primary_leaves,primary_triangle_tests,primary_restarts,primary_backtracks,primary_stack_depth,"
              "primary_exit_reason");
    EXPECT_EQ(lines[1], "0,0,-1,0,0,0,0,0,0,0,0,0,0,miss");
    EXPECT_EQ(lines[2], "1,0,7,0.1,0.25,0.33333334,1,2,3,4,5,6,8,hit");
    EXPECT_EQ(lines[3], "2,0,-1,0,0,0,0,0,0,0,0,0,0,none") << "not traced";
    EXPECT_EQ(lines[4], "0,1,-1,3e+38,0,0,0,0,0,0,0,0,0,miss");
    EXPECT_EQ(lines[6], "2,1,-1,0,0,0,0,0,0,0,0,0,0,step cap");
}

TEST(FrameCsv, WritesMinusZeroAsZero) {
    Frame frame(1, 1);
    frame.layer(Pass::rt_prim).hit.at(0, 0) = {3, 1.5f, -0.0f, -0.0f};
    EXPECT_TRUE(holds(lines_of(frame_csv(frame))[1], ",3,1.5,0,0,"));
}

TEST(FrameCsv, DistancesAreInSceneUnits) {
    Frame frame = small_frame();
    frame.exponent = 20;
    const std::vector<std::string> lines = lines_of(frame_csv(frame));
    EXPECT_TRUE(lines[2].starts_with("1,0,7,104857.6,0.25,")) << lines[2];
    EXPECT_TRUE(lines[4].starts_with("0,1,-1,3e+38,")) << lines[4];
}

TEST(FrameCsv, AddsThePassesThatRan) {
    Frame frame = small_frame();
    frame.layer(Pass::shade_refl).counters.at(2, 1).leaves = 9;
    const std::vector<std::string> lines = lines_of(frame_csv(frame));
    EXPECT_TRUE(holds(lines[0], ",reflection_shadow_leaves,"));
    EXPECT_EQ(lines[0].find("reflection_leaves"), std::string::npos);
    EXPECT_EQ(lines[0].find(",shadow_leaves"), std::string::npos);
    EXPECT_TRUE(holds(lines[6], ",-1,0,0,0,0,0,9,0,0,0,0,miss"));
    EXPECT_TRUE(holds(lines[5], ",-1,0,0,0,0,0,0,0,0,0,0,none")) << "no such ray";
}

/// One channel of an EXR file; empty where it has none of that name.
std::vector<float> channel_of(const std::filesystem::path& path, const std::string& name) {
    EXRVersion version;
    EXRHeader header;
    EXRImage image;
    InitEXRHeader(&header);
    InitEXRImage(&image);
    const char* error = nullptr;
    std::vector<float> values;
    EXPECT_EQ(ParseEXRVersionFromFile(&version, path.c_str()), TINYEXR_SUCCESS);
    EXPECT_EQ(ParseEXRHeaderFromFile(&header, &version, path.c_str(), &error), TINYEXR_SUCCESS);
    EXPECT_EQ(LoadEXRImageFromFile(&image, &header, path.c_str(), &error), TINYEXR_SUCCESS);
    for (int c = 0; c < header.num_channels; ++c) {
        if (header.channels[c].name != name) continue;
        EXPECT_EQ(header.pixel_types[c], TINYEXR_PIXELTYPE_FLOAT);
        const auto* first = reinterpret_cast<const float*>(image.images[c]);
        values.assign(first, first + image.width * image.height);
    }
    FreeEXRImage(&image);
    FreeEXRHeader(&header);
    return values;
}

TEST(FrameExr, HoldsEveryCounterAndT) {
    const auto path = scratch_folder() / "frame.exr";
    write_frame_exr(path, small_frame());
    EXPECT_EQ(count_files(path.parent_path()), 1);
    float expected = 1.0f;
    for (const CounterInfo& counter : counter_table()) {
        EXPECT_EQ(channel_of(path, std::string(counter.name)), (std::vector<float>{0, expected, 0, 0, 0, 0}))
            << counter.name;
        expected = expected == 6.0f ? 8.0f : expected + 1.0f;
    }
    EXPECT_EQ(channel_of(path, "t"), (std::vector<float>{0, 0.1f, 0, KD_T_LIMIT, 0, 0}));
    EXPECT_EQ(channel_of(path, "exit_reason"), (std::vector<float>{0, 1, 0, 0, 0, 2}));
    EXPECT_TRUE(channel_of(path, "no such channel").empty());
}

TEST(FrameExr, KeepsLargePictures) {
    const auto path = scratch_folder() / "large.exr";
    Frame frame(301, 203);
    std::vector<float> expected;
    for (int y = 0; y < 203; ++y) {
        for (int x = 0; x < 301; ++x) {
            frame.layer(Pass::rt_prim).counters.at(x, y).triangle_tests = uint(x * y);
            expected.push_back(static_cast<float>(x * y));
        }
    }
    write_frame_exr(path, frame);
    EXPECT_EQ(channel_of(path, "triangle_tests"), expected);
}

TEST(FrameExr, FailsInOneLine) {
    const auto folder = scratch_folder();
    EXPECT_TRUE(holds(error_of([&] { write_frame_exr(folder / "a.exr", Frame()); }), "the picture is empty"));
    EXPECT_TRUE(holds(error_of([&] { write_frame_exr(folder / "n" / "a.exr", Frame(2, 2)); }), "there is no folder"));
    EXPECT_EQ(count_files(folder), 0);
}

}  // namespace
}  // namespace kd

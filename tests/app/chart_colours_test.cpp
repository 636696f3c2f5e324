// A colour means one thing: a machine, in the window's numbers as in its charts and in files; a depth; a ray's cells.
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

#include "app/window/chart_marks.h"
#include "app/window/theme.h"
#include "viz/chart_palette.h"
#include "viz/colormap.h"
#include "viz/overlay.h"

namespace kd {
namespace {

ImU32 packed(Rgba8 c) { return IM_COL32(c.r, c.g, c.b, c.a); }

TEST(ChartColours, WindowAndFilesDrawACurveAlike) {
    for (const Ink ink : {Ink::cpu, Ink::gpu, Ink::green, Ink::red, Ink::purple, Ink::blue, Ink::grey})
        EXPECT_EQ(chart::look_of(ink).colour, packed(colour_of(ink, Ground::white))) << int(ink);
}

TEST(ChartColours, AreThoseOfTheTheme) {
    EXPECT_EQ(chart::look_of(Ink::cpu).colour, theme::cpu);
    EXPECT_EQ(chart::look_of(Ink::gpu).colour, theme::gpu);
    EXPECT_EQ(chart::look_of(Ink::reference).colour, theme::text);
}

/// The sum of what two colours' channels differ by.
int apart(Rgba8 a, Rgba8 b) {
    return std::abs(int(a.r) - int(b.r)) + std::abs(int(a.g) - int(b.g)) + std::abs(int(a.b) - int(b.b));
}

TEST(ChartColours, TheCellsOfARayHaveNoColourThatStandsForADepth) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(theme::ray_cells);
    const auto byte = [](float x) { return static_cast<unsigned char>(std::lround(x * 255)); };
    const Rgba8 cells{byte(c.x), byte(c.y), byte(c.z), 255};
    for (int depth = 0; depth <= 12; ++depth) EXPECT_GT(apart(cells, depth_colour(depth, 12)), 192) << depth;
    // Ratios of visits, on lines beside them.
    const Colormap& ratios = get_colormap("blue-grey-orange");
    for (const Rgba8 beyond : {ratios.below, ratios.above}) EXPECT_GT(apart(cells, beyond), 192);
}

}  // namespace
}  // namespace kd

// A machine has one colour, in the window's numbers as in its charts and in files.
#include <gtest/gtest.h>

#include "app/window/chart_marks.h"
#include "app/window/theme.h"
#include "viz/chart_palette.h"

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

}  // namespace
}  // namespace kd

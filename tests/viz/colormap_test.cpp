#include "viz/colormap.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "renderer/geometry/input_error.h"
#include "tests/viz/colour_vision.h"

namespace kd {
namespace {

using test::luminance;

TEST(Colormap, ViridisIsTheDefaultAndNamesAreUnique) {
    EXPECT_EQ(colormaps().front().name, "viridis");
    std::set<std::string_view> names;
    for (const Colormap& map : colormaps()) EXPECT_TRUE(names.insert(map.name).second) << map.name;
    EXPECT_EQ(names.size(), 8u);
}

// Entries 0, 64, 128, 192 and 255 of the published 256-entry viridis.
TEST(Colormap, ViridisIsThePublishedOne) {
    const Colormap& viridis = get_colormap("viridis");
    const std::array<std::pair<int, Rgba8>, 5> published{
        {{0, {68, 1, 84}}, {64, {59, 82, 139}}, {128, {33, 145, 140}}, {192, {94, 201, 98}}, {255, {253, 231, 37}}}};
    for (const auto& [index, expected] : published) {
        const Rgba8 c = viridis(float(index) / 255.0f);
        EXPECT_NEAR(c.r, expected.r, 2) << index;
        EXPECT_NEAR(c.g, expected.g, 2) << index;
        EXPECT_NEAR(c.b, expected.b, 2) << index;
    }
}

TEST(Colormap, EndsAreTheTablesEndsAndPositionsAreClamped) {
    for (const Colormap& map : colormaps()) {
        EXPECT_EQ(map(0), map.table.front()) << map.name;
        EXPECT_EQ(map(1), map.table.back()) << map.name;
        EXPECT_EQ(map(-3), map.table.front()) << map.name;
        EXPECT_EQ(map(7), map.table.back()) << map.name;
        EXPECT_EQ(map(std::nanf("")), map.table.front()) << map.name;
    }
}

TEST(Colormap, InterpolatesBetweenEntries) {
    const Colormap& grey = get_colormap("grey");
    for (int level = 0; level < 256; ++level) {
        const auto byte = static_cast<unsigned char>(level);
        EXPECT_EQ(grey(float(level) / 255.0f), (Rgba8{byte, byte, byte, 255}));
    }
}

TEST(Colormap, UniformMapsOnlyGetLighter) {
    for (const char* name : {"viridis", "cividis", "magma", "inferno", "plasma", "grey"}) {
        const Colormap& map = get_colormap(name);
        // Steps of 1/64: each is larger than the rounding to 8 bits.
        for (int i = 0; i < 64; ++i) {
            EXPECT_LT(luminance(map(float(i) / 64.0f)), luminance(map(float(i + 1) / 64.0f))) << name << " at " << i;
        }
    }
}

TEST(Colormap, DivergingMapIsNeutralInTheMiddleAndEvenOnBothSides) {
    const Colormap& map = get_colormap("blue-grey-orange");
    ASSERT_TRUE(map.diverging);
    const Rgba8 centre = map(0.5f);
    EXPECT_EQ(centre.r, centre.g);
    EXPECT_EQ(centre.g, centre.b);
    EXPECT_GT(map(0).b, map(0).r);
    EXPECT_GT(map(1).r, map(1).b);
    for (int i = 0; i <= 32; ++i) {
        const float x = float(i) / 64.0f;
        EXPECT_NEAR(luminance(map(x)), luminance(map(1 - x)), 0.02) << x;
        if (i < 32) {
            EXPECT_LT(luminance(map(x)), luminance(map(x + 1.0f / 64.0f))) << x;
        }
    }
}

// Legend swatches side by side: each must be told from the map's ends and from each other, at six times and more the
// difference that is just noticeable, by everybody.
TEST(Colormap, ExceptionalColoursAreToldFromTheEndsAndFromEachOther) {
    constexpr double bound = 14;
    for (const Colormap& map : colormaps()) {
        const std::pair<const char*, Rgba8> swatches[] = {{"lower end", map(0)},         {"upper end", map(1)},
                                                          {"below", map.below},          {"above", map.above},
                                                          {"no value", untraced_colour}, {"broken", nan_colour}};
        for (const auto& [name, colour] : swatches) {
            for (const auto& [other_name, other] : swatches) {
                if (name == other_name) continue;
                EXPECT_GE(test::least_difference(colour, other), bound)
                    << map.name << ": " << name << ", " << other_name;
            }
        }
    }
}

TEST(Colormap, ABrokenValueAndOneOffTheRangeAreOnNoMap) {
    for (const Colormap& map : colormaps()) {
        for (const Rgba8 exception : {map.below, map.above, nan_colour, untraced_colour}) {
            // The dark greys of the grey map pass by the colour for no value.
            if (map.name == "grey" && exception == untraced_colour) continue;
            for (int i = 0; i <= 255; ++i) EXPECT_NE(map(float(i) / 255.0f), exception) << map.name;
        }
    }
}

TEST(Colormap, UnknownNameListsTheKnownOnes) {
    EXPECT_EQ(find_colormap("jet"), nullptr);
    try {
        static_cast<void>(get_colormap("jet"));
        FAIL() << "no error";
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("'jet'"), std::string::npos) << text;
        EXPECT_NE(text.find("viridis"), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
}

TEST(Colormap, CategoriesDifferAndRepeat) {
    for (int i = 0; i < 8; ++i) {
        for (int j = i + 1; j < 8; ++j) EXPECT_NE(category_colour(i), category_colour(j)) << i << " " << j;
    }
    EXPECT_EQ(category_colour(9), category_colour(1));
    EXPECT_EQ(category_colour(-1), category_colour(7));
}

}  // namespace
}  // namespace kd

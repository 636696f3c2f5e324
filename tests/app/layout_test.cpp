// Where the parts of the window stand.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>

#include "app/window/layout.h"

namespace kd {
namespace {

TEST(Layout, F09_AreasOfAnyWindowAreNumbers) {
    for (const auto& [width, height] : {std::pair{0.0f, 0.0f}, {1.0f, 1.0f}, {30000.0f, 1.0f}, {1.0f, 30000.0f}})
        for (const bool panels : {false, true}) {
            const Layout layout = divide(width, height, {}, 1, panels);
            for (const Rectangle& r :
                 {layout.top, layout.left, layout.picture, layout.right, layout.bottom, layout.status})
                for (const float x : {r.x, r.y, r.width, r.height}) EXPECT_TRUE(std::isfinite(x));
            EXPECT_GE(layout.picture.width, 1);
            EXPECT_GE(layout.picture.height, 1);
        }
}

TEST(Layout, AreasCoverTheWindowAndNeverOverlap) {
    for (const float width : {640.0f, 1280.0f, 1920.0f})
        for (const float height : {480.0f, 720.0f, 1080.0f})
            for (const float size : {0.0f, 300.0f, 5000.0f}) {
                const Layout l = divide(width, height, {size, size, size}, 1, true);
                EXPECT_LE(l.left.x + l.left.width, l.picture.x);
                EXPECT_LE(l.picture.x + l.picture.width, l.right.x);
                EXPECT_LE(l.picture.y + l.picture.height, l.bottom.y);
                EXPECT_LE(l.bottom.y + l.bottom.height, l.status.y + 0.5f);
                EXPECT_LE(l.left.y + l.left.height, l.status.y + 0.5f);
                EXPECT_LE(l.left.x + l.left.width, l.bottom.x);
                EXPECT_FLOAT_EQ(l.bottom.x + l.bottom.width, width);
                EXPECT_FLOAT_EQ(l.right.x + l.right.width, width);
                EXPECT_FLOAT_EQ(l.status.y + l.status.height, height);
                EXPECT_GE(l.picture.width, 0.39f * width);
                EXPECT_GE(l.picture.height, 1);
            }
}

TEST(Layout, ThePictureGetsSixtyPercentOfTheWidthAtFirst) {
    EXPECT_GE(divide(1280, 720, {}, 1, true).picture.width, 0.6f * 1280);
    EXPECT_GE(divide(1280, 720, {}, 1, true).picture.height, 0.6f * 720);
    EXPECT_FLOAT_EQ(divide(1280, 720, {}, 1, false).picture.width, 1280);
}

TEST(Layout, TheBottomGrowsWithTheWindowUntilItIsDragged) {
    const auto bottom = [](float height, const LayoutSizes& sizes) {
        return divide(1280, height, sizes, 1, true).bottom.height;
    };
    EXPECT_FLOAT_EQ(bottom(720, {}), 204);
    EXPECT_FLOAT_EQ(bottom(1080, {}), 259);
    EXPECT_FLOAT_EQ(bottom(1600, {}), 260);
    for (const float height : {720.0f, 1080.0f, 1600.0f}) EXPECT_FLOAT_EQ(bottom(height, {.bottom = 150}), 150);
    EXPECT_FLOAT_EQ(divide(2560, 1440, {}, 2, true).bottom.height, 408) << "at scale 2";
}

TEST(Layout, WhatStaysIsInViewWhereTheRestScrolls) {
    EXPECT_FLOAT_EQ(upper_height({.scrolling = 300, .staying = 90}, 452), 300) << "right below the rest";
    EXPECT_FLOAT_EQ(upper_height({.scrolling = 700, .staying = 90}, 452), 362);
    EXPECT_FLOAT_EQ(upper_height({.scrolling = 700, .staying = 400}, 450), 150) << "some of both";
}

TEST(Layout, TheFirstWindowSuitsTheScreen) {
    EXPECT_EQ(first_size({1280, 720}, 1), (WindowSize{1280, 720}));
    EXPECT_EQ(first_size({1920, 1040}, 1), (WindowSize{1728, 936}));
    EXPECT_EQ(first_size({1024, 768}, 1), (WindowSize{1024, 720})) << "a small screen is filled, no more";
    EXPECT_EQ(first_size({2560, 1600}, 2), (WindowSize{2560, 1440})) << "1280 x 720 at scale 2";
}

TEST(Layout, TextGrowsAsFarAsPanelsStandBesideEachOther) {
    EXPECT_FLOAT_EQ(room_for_text({1280, 720}, 1), 1.3f);
    EXPECT_FLOAT_EQ(room_for_text({1920, 1080}, 1), 1.9f);
    EXPECT_FLOAT_EQ(room_for_text({2560, 1440}, 2), 1.3f) << "on a display of twice the density";
    EXPECT_FLOAT_EQ(room_for_text({640, 480}, 1), 1) << "never smaller than it is at first";
}

}  // namespace
}  // namespace kd

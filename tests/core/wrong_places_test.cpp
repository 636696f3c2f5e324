// Places where rays go wrong: apart from each other, worst first, none forgotten.
#include "renderer/trace/wrong_places.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

#include "renderer/scene/random.h"

namespace kd {
namespace {

JudgedLayer layer_of(int width, int height, const std::vector<std::pair<int, int>>& wrong) {
    JudgedLayer layer;
    layer.hits = Image<JudgedHit>(width, height, JudgedHit{HitVerdict::agrees, 0, {}});
    for (const auto& [x, y] : wrong) layer.hits.at(x, y).verdict = HitVerdict::missed;
    layer.tally();
    return layer;
}

/// Square of side 2 * half + 1.
std::vector<std::pair<int, int>> square(int cx, int cy, int half) {
    std::vector<std::pair<int, int>> pixels;
    for (int y = cy - half; y <= cy + half; ++y)
        for (int x = cx - half; x <= cx + half; ++x) pixels.emplace_back(x, y);
    return pixels;
}

int apart(const JudgedLayer& layer, std::size_t a, std::size_t b) {
    const int w = layer.hits.width, i = int(a), j = int(b);
    return std::max(std::abs(i % w - j % w), std::abs(i / w - j / w));
}

TEST(WrongPlaces, ReachGrowsWithThePicture) {
    EXPECT_EQ(place_reach(64, 48), 8);
    EXPECT_EQ(place_reach(1920, 960), 40);
}

TEST(WrongPlaces, TheWorstComesFirstAndAClusterIsOnePlace) {
    std::vector<std::pair<int, int>> wrong = square(30, 100, 3);
    for (const auto& pixel : square(150, 40, 1)) wrong.push_back(pixel);
    wrong.emplace_back(90, 10);
    const JudgedLayer layer = layer_of(200, 150, wrong);
    ASSERT_EQ(layer.places.size(), 3u);
    EXPECT_LE(apart(layer, layer.places[0], layer.hits.index(30, 100)), 3);
    EXPECT_LE(apart(layer, layer.places[1], layer.hits.index(150, 40)), 1);
    EXPECT_EQ(layer.places[2], layer.hits.index(90, 10));
}

TEST(WrongPlaces, LieApartAndLeaveNoWrongPixelOut) {
    Random random(7);
    std::vector<std::pair<int, int>> wrong;
    for (int i = 0; i < 400; ++i) wrong.emplace_back(int(random.between(0, 299.9)), int(random.between(0, 199.9)));
    for (int x = 0; x < 300; ++x) wrong.emplace_back(x, 120);  // as along a split plane
    const JudgedLayer layer = layer_of(300, 200, wrong);
    const int reach = place_reach(300, 200);
    ASSERT_GT(layer.places.size(), 20u);
    for (std::size_t i = 0; i < layer.places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GT(apart(layer, layer.places[i], layer.places[j]), reach);
    for (const auto& [x, y] : wrong) {
        const std::size_t pixel = layer.hits.index(x, y);
        const auto near = [&](std::size_t place) { return apart(layer, place, pixel) <= reach; };
        EXPECT_TRUE(std::ranges::any_of(layer.places, near)) << x << ", " << y;
    }
}

TEST(NextPlace, GoesRoundAndEachStepLeadsElsewhere) {
    const JudgedLayer layer = layer_of(100, 100, {{10, 10}, {11, 10}, {12, 10}, {50, 50}, {51, 50}, {90, 20}});
    ASSERT_EQ(layer.places.size(), 3u);
    const auto first = next_place(layer, {}, false);
    EXPECT_EQ(first, layer.places[0]);
    EXPECT_EQ(next_place(layer, {}, true), layer.places[2]);
    auto at = first;
    for (const std::size_t place : {1u, 2u, 0u}) {
        at = next_place(layer, at, false);
        EXPECT_EQ(at, layer.places[place]);
    }
    EXPECT_EQ(next_place(layer, at, true), layer.places[2]);
}

TEST(NextPlace, FromElsewhereTheNearestComesFirst) {
    const JudgedLayer layer = layer_of(100, 100, {{10, 10}, {11, 10}, {50, 50}, {90, 20}});
    EXPECT_EQ(next_place(layer, layer.hits.index(80, 30), false), layer.hits.index(90, 20));
    EXPECT_EQ(next_place(layer, layer.hits.index(80, 30), true), layer.hits.index(90, 20));
    ASSERT_EQ(layer.places[1], layer.hits.index(90, 20));
    EXPECT_EQ(next_place(layer, layer.hits.index(92, 22), false), layer.places[2]) << "seen all around the place";
}

TEST(NextPlace, TheOnlyPlaceFollowsItself) {
    EXPECT_FALSE(next_place(layer_of(3, 1, {}), {}, false));
    EXPECT_FALSE(next_place(JudgedLayer{}, {}, true));
    const JudgedLayer layer = layer_of(3, 1, {{1, 0}});
    EXPECT_EQ(next_place(layer, 1, false), 1u);
    EXPECT_EQ(next_place(layer, 2, true), 1u);
}

}  // namespace
}  // namespace kd

#include "viz/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace kd {
namespace {

std::vector<std::string> linear_texts(ValueRange range, bool integer = true) {
    return tick_texts(tick_values(range, false, integer), false);
}

using Texts = std::vector<std::string>;

TEST(Ticks, AreRound) {
    EXPECT_EQ(linear_texts({0, 50}), (Texts{"0", "10", "20", "30", "40", "50"}));
    EXPECT_EQ(linear_texts({0, 382}), (Texts{"0", "100", "200", "300"}));
    EXPECT_EQ(linear_texts({0, 1}, false), (Texts{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(linear_texts({-10, 10}), (Texts{"\u221210", "\u22125", "0", "5", "10"}));
    EXPECT_EQ(linear_texts({0, 20000}), (Texts{"0", "5\u2009000", "10\u2009000", "15\u2009000", "20\u2009000"}));
    EXPECT_EQ(linear_texts({0, 0.004f}, false), (Texts{"0.000", "0.001", "0.002", "0.003", "0.004"}));
}

TEST(Ticks, WholeNumbersForCounts) {
    EXPECT_EQ(linear_texts({0, 1}), (Texts{"0", "1"}));
    EXPECT_EQ(linear_texts({0, 3}), (Texts{"0", "1", "2", "3"}));
}

TEST(Ticks, DecadesOnALogScale) {
    EXPECT_EQ(tick_texts(tick_values({1, 10000}, true, true), true),
              (Texts{"1", "10", "100", "1\u2009000", "10\u2009000"}));
    EXPECT_EQ(tick_texts(tick_values({3, 60}, true, true), true), (Texts{"5", "10", "20", "50"}));
    for (const double tick : tick_values({1e-20f, 1e20f}, true, false)) {
        EXPECT_NEAR(std::log10(tick), std::round(std::log10(tick)), 1e-9);
    }
}

TEST(Ticks, LieInsideInOrderAndAreFew) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> exponent(-12, 12), share(0.001f, 1);
    int few = 0;
    for (int i = 0; i < 5000; ++i) {
        const float size = std::pow(10.0f, exponent(random));
        const ValueRange range{i % 2 == 0 ? 0 : -size * share(random), size};
        const bool log = i % 5 == 0;
        const ValueRange used = log ? ValueRange{size * share(random) * 0.9f, size} : range;
        const std::vector<double> ticks = tick_values(used, log, false);
        ASSERT_GE(ticks.size(), log ? 1u : 3u) << used.min << " " << used.max;
        ASSERT_LE(ticks.size(), 8u) << used.min << " " << used.max;
        few += ticks.size() >= 4 && ticks.size() <= 6;
        const double slack = 1e-5 * (double(used.max) - double(used.min));
        for (std::size_t k = 0; k < ticks.size(); ++k) {
            EXPECT_GE(ticks[k], double(used.min) - slack);
            EXPECT_LE(ticks[k], double(used.max) + slack);
            if (k > 0) {
                EXPECT_GT(ticks[k], ticks[k - 1]);
            }
        }
    }
    EXPECT_GT(few, 4000) << "mostly four to six";
}

TEST(Ticks, NoneForARangeThatIsNone) {
    EXPECT_TRUE(tick_values({1, 1}, false, false).empty());
    EXPECT_TRUE(tick_values({0, 1}, true, false).empty());
    EXPECT_TRUE(tick_values({0, std::nanf("")}, false, false).empty());
}

TEST(NumberText, FourDigitsAndThinSpaces) {
    const std::pair<double, const char*> cases[] = {{0, "0"},
                                                    {-0.0, "0"},
                                                    {7, "7"},
                                                    {999, "999"},
                                                    {1000, "1\u2009000"},
                                                    {41233, "41\u2009233"},
                                                    {1234567, "1\u2009234\u2009567"},
                                                    {-12, "\u221212"},
                                                    {3.14159, "3.142"},
                                                    {23.456, "23.46"},
                                                    {123.456, "123.5"},
                                                    {1234.56, "1\u2009235"},
                                                    {0.5, "0.5000"},
                                                    {0.025, "0.02500"},
                                                    {0.0001234, "1.234e\u22124"},
                                                    {0.000999996, "1e\u22123"},
                                                    {-2e-7, "\u22122e\u22127"},
                                                    {5e10, "5e10"},
                                                    {6.022e23, "6.022e23"}};
    for (const auto& [value, text] : cases) EXPECT_EQ(number_text(value), text);
    EXPECT_EQ(number_text(std::nan("")), "nan");
    EXPECT_EQ(number_text(-INFINITY), "-inf");
}

TEST(PercentText, NeverRoundsToNothingOrAll) {
    EXPECT_EQ(percent_text(0, 100), "0 %");
    EXPECT_EQ(percent_text(1, 100000), "< 0.1 %");
    EXPECT_EQ(percent_text(5, 1000), "0.5 %");
    EXPECT_EQ(percent_text(12.4, 100), "12 %");
    EXPECT_EQ(percent_text(99999, 100000), "> 99 %");
    EXPECT_EQ(percent_text(5, 5), "100 %");
    EXPECT_EQ(percent_text(1, 0), "0 %");
}

TEST(Numbers, CountsComeWithTheirShare) {
    EXPECT_EQ(count_text(0, 500), "0");
    EXPECT_EQ(count_text(5, 500), "5  1.0 %");
    EXPECT_EQ(count_text(1, 1e6), "1  < 0.1 %");
}

}  // namespace
}  // namespace kd

// Clicks that come within one slow frame reach Dear ImGui one change at a time.
#ifdef KD_WITH_WINDOW

#include "app/window/button_queue.h"

#include <gtest/gtest.h>
#include <string>

namespace kd {
namespace {

class Clicking : public testing::Test {
  protected:
    ButtonQueue queue;

    void click(double seconds, int button = 0, double late = 0) {
        queue.add({button, true, 10, 20, seconds, late});
        queue.add({button, false, 11, 20, seconds, late});
    }
    /// Each frame: d or u for a change of the left button, D for the second press of a double click, r for the right
    /// one.
    std::string frames() {
        std::string text;
        while (!queue.empty()) {
            const ButtonFrame frame = queue.take();
            text += !frame.change               ? '.'
                    : frame.change->button == 1 ? 'r'
                    : frame.second_of_two       ? 'D'
                    : frame.change->down        ? 'd'
                                                : 'u';
        }
        return text;
    }
};

TEST_F(Clicking, EachChangeHasAFrame) {
    click(1);
    EXPECT_EQ(frames(), "du");
}

TEST_F(Clicking, TwoClicksOfOneSlowFrameAreADoubleClick) {
    click(1);
    click(1);
    EXPECT_EQ(frames(), "duDu");
}

TEST_F(Clicking, ThreeClicksAreADoubleClickAndOneMore) {
    for (int i = 0; i < 3; ++i) click(1);
    EXPECT_EQ(frames(), "duDudu");
}

TEST_F(Clicking, ClicksApartAreTwo) {
    click(1);
    click(1.31);
    EXPECT_EQ(frames(), "dudu");
}

TEST_F(Clicking, TheTimeOfASlowFrameBetweenThemIsForgiven) {
    click(1);
    click(1.7, 0, 0.5);
    EXPECT_EQ(frames(), "duDu");
}

TEST_F(Clicking, AnotherButtonIsNoDoubleClick) {
    click(1, 0);
    click(1, 1);
    click(1, 0);
    EXPECT_EQ(frames(), "durrdu");
}

TEST_F(Clicking, TheFrameKnowsWhereItWasAndWhatIsDown) {
    click(1);
    const ButtonFrame press = queue.take();
    EXPECT_EQ(press.change->x, 10);
    EXPECT_TRUE(press.down[0]);
    const ButtonFrame release = queue.take();
    EXPECT_EQ(release.change->x, 11);
    EXPECT_FALSE(release.down[0]);
    EXPECT_FALSE(queue.take().change);
}

TEST_F(Clicking, ButtonsBeyondTheFifthArePassedOver) {
    queue.add({7, true, 0, 0, 0, 0});
    EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace kd

#endif

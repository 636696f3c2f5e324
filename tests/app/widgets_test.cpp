// Tooltips and lists, as they answer the mouse and the keys.
#ifdef KD_WITH_WINDOW

#include "app/window/widgets.h"

#include <gtest/gtest.h>

#include "app/window/list.h"
#include "tests/app/ui_run.h"

namespace kd {
namespace {

TEST(Tooltips, RestOverWhatWasUsedUntilTheMouseHasLeft) {
    int pressed = 0;
    test::Ui ui([&] {
        if (widgets::button("run", "Runs it.")) ++pressed;
        (void)widgets::button("other", "Does nothing.");
    });
    ui.point_at("run");
    EXPECT_TRUE(ui.sees("tooltip"));
    ui.click();
    EXPECT_EQ(pressed, 1);
    EXPECT_FALSE(ui.sees("tooltip"));
    ui.point_at("run", 0.6f);
    ui.frames(200);
    EXPECT_FALSE(ui.sees("tooltip")) << "moved within the button";
    ui.point_at("other");
    EXPECT_TRUE(ui.sees("tooltip")) << "another control";
    ui.point_at("run");
    EXPECT_TRUE(ui.sees("tooltip")) << "left and back";
}

TEST(Tooltips, RestOverWhatTakesThePlaceOfTheUsed) {
    bool runs = false;
    test::Ui ui([&] {
        if (runs)
            (void)widgets::button("cancel", "Ends it.");
        else if (widgets::button("measure", "Measures it."))
            runs = true;
    });
    ui.click_on("measure");
    ASSERT_TRUE(ui.sees("cancel"));
    EXPECT_FALSE(ui.sees("tooltip"));
    runs = false;
    ui.frames(5);
    ASSERT_TRUE(ui.sees("measure"));
    EXPECT_FALSE(ui.sees("tooltip")) << "the result is there, and the mouse has not moved";
    ui.move_to({900, 600});
    ui.point_at("measure");
    EXPECT_TRUE(ui.sees("tooltip"));
}

TEST(Tooltips, OfAControlThatCannotBeUsedAreShown) {
    test::Ui ui([] { (void)widgets::button("sweep", "No parameter.", false); });
    ui.point_at("sweep");
    EXPECT_TRUE(ui.sees("tooltip"));
    ui.click();
    EXPECT_TRUE(ui.sees("tooltip")) << "nothing was used";
}

/// a, b, c and d, of which c cannot be chosen.
std::vector<widgets::Option> letters() {
    std::vector<widgets::Option> options;
    for (const char* name : {"a", "b", "c", "d"}) options.push_back({name, "A letter."});
    options[2].missing = "no such letter";
    return options;
}

class Lists : public testing::Test {
  protected:
    std::string name = "b";
    int changes = 0;
    test::Ui ui{[this] { changes += widgets::combo("list", name, letters(), "Letters.", 120) ? 1 : 0; }};

    void open() {
        ui.click_on("list");
        ASSERT_TRUE(ui.sees("list/a"));
    }
};

TEST_F(Lists, ArrowsMoveEnterTakes) {
    open();
    ui.press(ImGuiKey_DownArrow);
    EXPECT_EQ(name, "b") << "not taken yet";
    EXPECT_TRUE(ui.sees("list/tooltip")) << "what the line stands for";
    ui.press(ImGuiKey_Enter);
    EXPECT_EQ(name, "d") << "c is passed over";
    EXPECT_EQ(changes, 1);
    EXPECT_FALSE(ui.sees("list/a")) << "closed";
    open();
    for (int i = 0; i < 5; ++i) ui.press(ImGuiKey_UpArrow);
    ui.press(ImGuiKey_KeyPadEnter);
    EXPECT_EQ(name, "a");
    open();
    ui.press(ImGuiKey_End);
    ui.press(ImGuiKey_Enter);
    EXPECT_EQ(name, "d");
}

TEST_F(Lists, EscapeClosesAndTakesNothing) {
    open();
    ui.press(ImGuiKey_DownArrow);
    ui.press(ImGuiKey_Escape);
    EXPECT_FALSE(ui.sees("list/a"));
    EXPECT_EQ(name, "b");
    EXPECT_EQ(changes, 0);
    open();
    ui.press(ImGuiKey_Enter);
    EXPECT_EQ(name, "b") << "begins at the line chosen, not where the keys were before";
    EXPECT_FALSE(ui.sees("list/a"));
}

TEST_F(Lists, TheMouseTakesOverWhereItMoves) {
    open();
    ui.press(ImGuiKey_UpArrow);
    ui.point_at("list/d");
    ui.press(ImGuiKey_Enter);
    EXPECT_EQ(name, "d");
    open();
    ui.click_on("list/c");
    EXPECT_EQ(name, "d") << "cannot be chosen";
    ui.click_on("list/a");
    EXPECT_EQ(name, "a");
}

TEST(StepInList, StopsAtTheEnds) {
    const std::vector<widgets::Option> options = letters();
    EXPECT_EQ(widgets::step_in_list(options, 1, 1), 3);
    EXPECT_EQ(widgets::step_in_list(options, 3, 4), 3);
    EXPECT_EQ(widgets::step_in_list(options, 3, -1), 1);
    EXPECT_EQ(widgets::step_in_list(options, 0, -8), 0);
    EXPECT_EQ(widgets::step_in_list(options, -1, 1), 0) << "none was chosen";
    EXPECT_EQ(widgets::step_in_list(options, -1, -1), -1);
    EXPECT_EQ(widgets::step_in_list({}, -1, 1), -1);
}

}  // namespace
}  // namespace kd

#endif

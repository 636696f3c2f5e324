// Keys that come in one burst reach Dear ImGui over as many frames as it needs to tell them apart.
#ifdef KD_WITH_WINDOW

#include "app/window/key_queue.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <string>

namespace kd {
namespace {

class Typing : public testing::Test {
  protected:
    KeyQueue queue;

    void tap(int key, int modifiers = 0) {
        queue.add({key, 0, GLFW_PRESS, modifiers, 0});
        queue.add({key, 0, GLFW_RELEASE, modifiers, 0});
    }
    void type(const std::string& text) {
        for (const char c : text) {
            queue.add({c - 'a' + GLFW_KEY_A, 0, GLFW_PRESS, 0, 0});
            queue.add({.character = static_cast<unsigned char>(c)});
            queue.add({c - 'a' + GLFW_KEY_A, 0, GLFW_RELEASE, 0, 0});
        }
    }
    /// What each frame gets, frames separated by spaces: characters, and < for Backspace.
    std::string frames() {
        std::string text;
        for (int frame = 0; frame < 100 && !queue.empty(); ++frame) {
            for (const KeyEvent& event : queue.take()) {
                if (event.character) text += char(event.character);
                if (event.key == GLFW_KEY_BACKSPACE && event.action == GLFW_PRESS) text += '<';
                if (event.key == GLFW_KEY_V && event.action == GLFW_PRESS && event.modifiers) text += 'V';
            }
            text += ' ';
        }
        return text;
    }
};

TEST_F(Typing, CharactersOfABurstGoTogether) {
    type("abcabc");
    EXPECT_EQ(frames(), "abcabc ");
}

TEST_F(Typing, EachBackspaceHasAFrameAndOneToBeReleasedIn) {
    for (int i = 0; i < 3; ++i) tap(GLFW_KEY_BACKSPACE);
    EXPECT_EQ(frames(), "<  <  <  ");
}

TEST_F(Typing, BackspaceStaysBetweenItsCharacters) {
    type("ab");
    tap(GLFW_KEY_BACKSPACE);
    type("c");
    EXPECT_EQ(frames(), "ab < c ");
}

TEST_F(Typing, LettersWithCtrlAreKeysThatEdit) {
    tap(GLFW_KEY_V, GLFW_MOD_CONTROL);
    tap(GLFW_KEY_V, GLFW_MOD_CONTROL);
    type("x");
    EXPECT_EQ(frames(), "V  V x ");
}

TEST_F(Typing, WaitsForWhatAClickChose) {
    queue.pause();
    type("a");
    EXPECT_EQ(frames(), " a ");
}

TEST_F(Typing, WhatFollowsEnterWaitsUntilTheFieldIsLeft) {
    type("a");
    tap(GLFW_KEY_ENTER);
    type("t");
    EXPECT_EQ(frames(), "a   t ");
}

TEST_F(Typing, NothingIsLost) {
    const std::string pattern = "ab<c<<dV";
    int events = 0;
    for (int round = 0; round < 20; ++round)
        for (const char c : pattern) {
            if (c == '<')
                tap(GLFW_KEY_BACKSPACE);
            else if (c == 'V')
                tap(GLFW_KEY_V, GLFW_MOD_CONTROL);
            else
                type(std::string(1, c));
            events += c == '<' || c == 'V' ? 2 : 3;
        }
    for (int frame = 0; frame < 1000 && !queue.empty(); ++frame) events -= int(queue.take().size());
    EXPECT_EQ(events, 0);
}

}  // namespace
}  // namespace kd

#endif

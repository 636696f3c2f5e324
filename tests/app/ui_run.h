// Dear ImGui without a window: widgets and panels are drawn, and used as a person would.
#pragma once

#include <functional>
#include <gtest/gtest.h>
#include <imgui.h>
#include <string>
#include <utility>

#include "app/window/places.h"
#include "app/window/theme.h"

namespace kd::test {

class Ui {
  public:
    /// `draw` draws into a column at the left, `width` wide.
    explicit Ui(std::function<void()> draw, float width = 300) : draw_(std::move(draw)), width_(width) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.UserData = &places_;
        io.DisplaySize = {1280, 720};
        for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
        theme::apply(1);
        frames(3);
    }
    ~Ui() { ImGui::DestroyContext(); }
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }

    /// Whether a control of that label is to be seen; "list/line" in an open list.
    [[nodiscard]] bool sees(const std::string& label) const { return places_.all().contains(label); }
    /// Whether one is to be seen whose label begins like that.
    [[nodiscard]] bool sees_any(const std::string& beginning) const {
        const auto found = places_.all().lower_bound(beginning);
        return found != places_.all().end() && found->first.starts_with(beginning);
    }

    /// Where a control is; nowhere, and a failure, where it is not to be seen.
    [[nodiscard]] Rectangle place(const std::string& label) const {
        const auto found = places_.all().find(label);
        if (found != places_.all().end()) return found->second;
        ADD_FAILURE() << "there is no '" << label << "' to be seen";
        return {};
    }

    /// What the tooltip says; empty where none is shown.
    [[nodiscard]] const std::string& tooltip() const { return places_.tooltip; }

    /// A share of its width from its left.
    void point_at(const std::string& label, float share = 0.5f) {
        const Rectangle r = place(label);
        if (r.width > 0) move_to({r.x + share * r.width, r.y + r.height / 2});
    }
    void move_to(ImVec2 place) {
        ImGui::GetIO().MousePos = place;
        frames(2);
    }
    void click() {
        ImGui::GetIO().MouseDown[0] = true;
        frame();
        ImGui::GetIO().MouseDown[0] = false;
        frames(2);
    }
    void click_on(const std::string& label, float share = 0.5f) {
        point_at(label, share);
        click();
    }
    void press(ImGuiKey key) {
        ImGui::GetIO().KeysDown[key] = true;
        frame();
        ImGui::GetIO().KeysDown[key] = false;
        frames(2);
    }
    void type(const char* text) {
        ImGui::GetIO().AddInputCharactersUTF8(text);
        frames(2);
    }

  private:
    void frame() {
        places_.clear();
        ImGui::GetIO().DeltaTime = 1.0f / 60;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({width_, 720});
        ImGui::Begin("column", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        draw_();
        ImGui::End();
        ImGui::Render();
    }

    std::function<void()> draw_;
    float width_;
    Places places_;
};

}  // namespace kd::test

// Where every control stands, by the name of its panel and its label: for scripts that drive the window.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "app/window/layout.h"
#include "app/window/tooltip_rest.h"

namespace kd {

/// The controls of one frame that can be seen, such as "TREE/leaf size" or, in an open list, "TREE/builder/paper".
/// Belongs to a Dear ImGui context, whose UserData points to it; a context without one notes nothing.
class Places {
  public:
    void clear() {
        all_.clear();
        tooltip.clear();
    }
    void add(std::string_view label, ImVec2 low, ImVec2 high);
    [[nodiscard]] const std::map<std::string, Rectangle>& all() const { return all_; }

    /// The item that Dear ImGui was given last.
    static void note(std::string_view label);
    /// Those of the current context; null where it has none.
    static Places* current();

    std::string tooltip;  // what it says; empty where none is shown
    TooltipRest tooltip_rest;

  private:
    friend class Section;
    std::string section_;
    std::map<std::string, Rectangle> all_;
};

/// While it lives, controls belong to this panel or list: their identity to Dear ImGui, and their place.
class Section {
  public:
    explicit Section(const char* name);
    ~Section();
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;

  private:
    std::size_t outer_ = 0;  // length of the name before
};

}  // namespace kd

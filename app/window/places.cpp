#include "app/window/places.h"

namespace kd {

Places* Places::current() { return static_cast<Places*>(ImGui::GetIO().UserData); }

void Places::add(std::string_view label, ImVec2 low, ImVec2 high) {
    all_[section_ + std::string(label)] = {low.x, low.y, high.x - low.x, high.y - low.y};
}

void Places::note(std::string_view label) {
    if (Places* places = current(); places && ImGui::IsItemVisible())
        places->add(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

Section::Section(const char* name) {
    ImGui::PushID(name);
    Places* places = Places::current();
    if (!places) return;
    outer_ = places->section_.size();
    places->section_ += std::string(name) + "/";
}

Section::~Section() {
    if (Places* places = Places::current()) places->section_.resize(outer_);
    ImGui::PopID();
}

}  // namespace kd

// What a person chooses by name: the same words on the command line and in files.
#pragma once

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/closest_name.h"
#include "app/session.h"

namespace kd {

template <class T>
struct NamedValue {
    std::string name;
    T value;
};

/// The names separated by ", ".
template <class T>
[[nodiscard]] std::string list_names(const std::vector<NamedValue<T>>& choices) {
    std::string list;
    for (const NamedValue<T>& choice : choices) list += (list.empty() ? "" : ", ") + choice.name;
    return list;
}

/// What `name` stands for. Throws std::invalid_argument with the known names; `what` is chosen among.
template <class T>
[[nodiscard]] T chosen(const std::vector<NamedValue<T>>& choices, const std::string& name, std::string_view what) {
    const auto found = std::ranges::find(choices, name, &NamedValue<T>::name);
    if (found != choices.end()) return found->value;
    std::vector<std::string> names;
    for (const NamedValue<T>& choice : choices) names.push_back(choice.name);
    throw std::invalid_argument(
        fmt::format("unknown {} '{}'{}; known: {}", what, name, did_you_mean(name, names), list_names(choices)));
}

/// The way back.
template <class T>
[[nodiscard]] std::string name_among(const std::vector<NamedValue<T>>& choices, const T& value) {
    const auto found = std::ranges::find(choices, value, &NamedValue<T>::value);
    return found == choices.end() ? "" : found->name;
}

/// "cpu-wide", "gl-fragment".
[[nodiscard]] std::string_view name_of(TracerKind tracer);
[[nodiscard]] std::string_view name_of(LeafLists lists);
/// Bytes of a node: "16", "8".
[[nodiscard]] std::string name_of(NodeEncoding nodes);
[[nodiscard]] std::string_view name_of(EarlyZ early_z);
/// Of a pass's rays, as --rays takes it: "reflection-shadow".
[[nodiscard]] std::string option_name(Pass rays);

namespace choices {

[[nodiscard]] std::vector<NamedValue<TracerKind>> tracers();
[[nodiscard]] std::vector<NamedValue<LeafLists>> leaf_lists();
[[nodiscard]] std::vector<NamedValue<NodeEncoding>> node_encodings();
[[nodiscard]] std::vector<NamedValue<int>> packet_sizes();
[[nodiscard]] std::vector<NamedValue<EarlyZ>> early_z();
[[nodiscard]] std::vector<NamedValue<Traversal>> traversals();
[[nodiscard]] std::vector<NamedValue<Rules>> rules();
[[nodiscard]] std::vector<NamedValue<Feature>> features();
[[nodiscard]] std::vector<NamedValue<std::string>> builders();
[[nodiscard]] std::vector<NamedValue<std::string>> maps();
[[nodiscard]] std::vector<NamedValue<std::string>> colormaps();
[[nodiscard]] std::vector<NamedValue<Pass>> rays();
[[nodiscard]] std::vector<NamedValue<Schedule>> schedules();
[[nodiscard]] std::vector<NamedValue<CellColour>> cell_colours();
[[nodiscard]] std::vector<NamedValue<int>> axes();

}  // namespace choices

}  // namespace kd

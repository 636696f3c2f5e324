#include "app/choices.h"

#include "renderer/scene/needs.h"
#include "viz/cell_colours.h"
#include "viz/colormap.h"

namespace kd {

std::string_view name_of(TracerKind tracer) {
    return runs_on_cpu(tracer) ? tracer_name(cpu_mode(tracer)) : tracer_name(gl_mode(tracer));
}

std::string_view name_of(EarlyZ early_z) { return early_z == EarlyZ::working ? "working" : "as-published"; }

std::string_view name_of(LeafLists lists) { return lists == LeafLists::references ? "references" : "duplicated"; }

std::string name_of(NodeEncoding nodes) { return std::to_string(bytes_of(nodes)); }

std::string option_name(Pass rays) {
    std::string name(ray_names[std::size_t(rays)]);
    std::ranges::replace(name, ' ', '-');
    return name;
}

namespace choices {

namespace {

template <class T>
std::vector<NamedValue<T>> named(std::initializer_list<T> values) {
    std::vector<NamedValue<T>> choices;
    for (const T value : values) choices.push_back({std::string(name_of(value)), value});
    return choices;
}

/// Entries of a table that have an id.
template <class T, class Table>
std::vector<NamedValue<T>> ids_of(const Table& table) {
    std::vector<NamedValue<T>> choices;
    for (const auto& entry : table) choices.push_back({std::string(entry.name), entry.id});
    return choices;
}

/// Entries that go by their names.
template <class Table>
std::vector<NamedValue<std::string>> names_of(const Table& table) {
    std::vector<NamedValue<std::string>> choices;
    for (const auto& entry : table) choices.push_back({std::string(entry.name), std::string(entry.name)});
    return choices;
}

}  // namespace

std::vector<NamedValue<TracerKind>> tracers() {
    using enum TracerKind;
    return named({cpu, cpu_wide, cpu_packet, gl_fragment, gl_compute, gl_wavefront});
}
std::vector<NamedValue<LeafLists>> leaf_lists() { return named({LeafLists::references, LeafLists::duplicated}); }
std::vector<NamedValue<NodeEncoding>> node_encodings() { return named({NodeEncoding::float4, NodeEncoding::packed}); }
std::vector<NamedValue<int>> packet_sizes() { return {{"4", 4}, {"8", 8}, {"16", 16}}; }
std::vector<NamedValue<EarlyZ>> early_z() { return named({EarlyZ::working, EarlyZ::as_published}); }
std::vector<NamedValue<Traversal>> traversals() { return ids_of<Traversal>(kd::traversals()); }
std::vector<NamedValue<Rules>> rules() { return ids_of<Rules>(all_rules()); }
std::vector<NamedValue<Feature>> features() { return ids_of<Feature>(kd::features()); }
std::vector<NamedValue<std::string>> builders() { return names_of(kd::builders()); }
std::vector<NamedValue<std::string>> maps() { return names_of(kd::maps()); }
std::vector<NamedValue<std::string>> colormaps() { return names_of(kd::colormaps()); }
std::vector<NamedValue<Schedule>> schedules() { return ids_of<Schedule>(kd::schedules()); }

std::vector<NamedValue<CellColour>> cell_colours() { return ids_of<CellColour>(all_cell_colours()); }

std::vector<NamedValue<Pass>> rays() {
    std::vector<NamedValue<Pass>> choices;
    for (int pass = 0; pass < pass_count; ++pass) choices.push_back({option_name(Pass(pass)), Pass(pass)});
    return choices;
}

std::vector<NamedValue<int>> axes() { return {{"x", 0}, {"y", 1}, {"z", 2}}; }

}  // namespace choices

}  // namespace kd

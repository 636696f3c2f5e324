#include "app/report/figure_text.h"

#include <cctype>
#include <fmt/format.h>
#include <version.h>

#include "app/report/json_values.h"
#include "app/scenes.h"
#include "app/tracer_choices.h"
#include "renderer/trace/walk_choices.h"
#include "viz/numbers.h"

namespace kd {

namespace {

/// ", NAME VALUE" where `value` is not the default.
template <class Value>
std::string changed(const char* name, const Value& value, const Value& otherwise) {
    return value == otherwise ? "" : fmt::format(", {} {}", name, value);
}

std::string tree_text(const BuildConfig& b, bool refitted) {
    const BuildConfig start;
    const Builder* builder = find_builder(b.builder);
    return fmt::format("{} tree{} (t_t {}, t_i {}, b_e {} gate {}, leaf {}{}{}{}{}{}{}{}{})", b.builder,
                       refitted ? " of time 0, refitted" : "", b.traversal_cost, b.intersection_cost, b.empty_bonus,
                       b.empty_bonus_gate, b.leaf_size,
                       builder && builder->has_bins ? fmt::format(", {} bins", b.bins) : "",
                       b.trim_leaves ? "" : ", box leaves", changed("max depth", b.max_depth, start.max_depth),
                       changed("empty parts cut off from", b.empty_cut, start.empty_cut),
                       changed("bad refines", b.bad_refines, start.bad_refines),
                       changed("reference cap", b.reference_cap, start.reference_cap),
                       changed("planes by hand", b.by_hand.size(), start.by_hand.size()),
                       changed("leaf blocks of", b.leaf_block, start.leaf_block));
}

std::string camera_words(const Camera& c) {
    const auto text = [](Vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    return fmt::format(", camera \"{} {} {} {}\"", text(c.eye), text(c.target), text(c.up), c.fov_y_degrees);
}

/// What else differs from the default, with a comma before each; the camera as option --camera takes it.
std::string differences(const FigureFacts& f) {
    const TraceConfig start;
    const bool published = f.tracer == TracerKind::gl_fragment && f.early_z == EarlyZ::as_published;
    return (f.trace.shadows ? "" : ", no shadows") +
           changed("bounces", f.trace.reflection_depth, start.reflection_depth) +
           changed("least contribution", f.trace.least_contribution, start.least_contribution) +
           (published ? ", early z as published" : "") + changed("seed", f.seed, 1u) +
           (f.camera ? camera_words(*f.camera) : "");
}

std::string leaf_lists_text(const FigureFacts& f) {
    if (!why_idle(TracerChoice::leaf_lists, f.tracer).empty()) return "leaves in blocks";
    return f.trace.leaf_lists == LeafLists::references ? "leaf lists of references" : "leaf lists of copies";
}

/// What differs from the paper's layout.
std::string nodes_text(const TraceConfig& trace) {
    const NodeEncoding nodes = nodes_in_force(trace);
    return nodes == NodeEncoding::float4 ? "" : fmt::format(", nodes of {} bytes", bytes_of(nodes));
}

std::string machine_text(const FigureFacts& f) {
    return fmt::format("{} on {}{}", tracer_text(f.tracer, f.trace), f.renderer,
                       f.software_gl ? " (software, not a GPU)" : "");
}

std::string time_text(const FigureFacts& f) {
    return fmt::format("{:.1f} ms{}", f.milliseconds, f.clock.empty() ? "" : fmt::format(" ({})", f.clock));
}

/// What the colours of cells say, with a comma before; depths are in the legend.
std::string words_of(CellColour colour, Pass rays) {
    switch (colour) {
        case CellColour::depth: break;
        case CellColour::visits: return fmt::format(", by visits of {} rays", ray_names[std::size_t(rays)]);
        case CellColour::predicted: return ", by visits predicted";
        case CellColour::ratio:
            return fmt::format(", by visits of {} rays over predicted", ray_names[std::size_t(rays)]);
    }
    return "";
}

}  // namespace

std::string title_of(const std::string& scene, const ViewConfig& view, int samples) {
    std::string title = scene;
    if (view.show_map) {
        const MapInfo* map = find_map(view.map.map);
        title = fmt::format("{}, {} rays", map ? map->title : view.map.map, ray_names[std::size_t(view.map.rays)]);
        if (samples > 1) title += fmt::format(", sums over {} samples", samples);
    } else if (view.overlay.show) {
        title = fmt::format("Splits of the kd-tree down to depth {}{}", view.overlay.max_depth,
                            words_of(view.overlay.colour, view.map.rays));
    }
    if (title != scene) title[0] = char(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

namespace {

std::string samples_text(const FigureFacts& f) {
    if (f.samples == 0) return "";
    if (f.average_samples < double(f.samples))
        return fmt::format(", light by {:.1f} samples on average, {} at most", f.average_samples, f.samples);
    return fmt::format(", light by {} sample{}", f.samples, f.samples == 1 ? "" : "s");
}

}  // namespace

std::string caption_of(const FigureFacts& f) {
    return fmt::format(
        "{}, {} triangle{}; {}; {} traversal, {} rules, {}{}{}{}, defaults elsewhere; {}; {} × {} in {}; kdscope {}",
        scene_text(f.scene, f.time, f.duration), number_text(double(f.triangles)), f.triangles == 1 ? "" : "s",
        tree_text(f.build, f.refitted), walk_text(f.trace), info(rules_in_force(f.trace)).name, leaf_lists_text(f),
        nodes_text(f.trace), samples_text(f), differences(f), machine_text(f), f.width, f.height, time_text(f),
        build::version);
}

PngText png_text(const std::string& title, const std::string& caption, const Session& session, const ViewConfig& view) {
    return {{"Title", title},
            {"Description", caption},
            {"Software", fmt::format("kdscope {} ({})", build::version, build::commit)},
            {"kdscope-settings", settings_json(session, view).dump(-1, ' ', false, Json::error_handler_t::replace)}};
}

}  // namespace kd

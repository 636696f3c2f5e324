#include "app/engine/paint.h"

#include <algorithm>
#include <utility>

#include "viz/legend_text.h"

namespace kd {

namespace {

/// Lines on a preview are drawn at no less than half of the picture's resolution: coarser ones could not be read.
constexpr int coarsest_lines = 2;

template <class T>
Image<T> thin_out(const Image<T>& image) {
    Image<T> result((image.width + sketch_step - 1) / sketch_step, (image.height + sketch_step - 1) / sketch_step);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) result.at(x, y) = image.at(x * sketch_step, y * sketch_step);
    return result;
}

/// The rays that `view` shows and the primary ones, thinned out.
TracedFrame thin_out(const TracedFrame& traced, const ViewConfig& view) {
    auto frame = std::make_shared<Frame>();
    frame->colour = thin_out(traced.frame->colour);
    frame->width = frame->colour.width;
    frame->height = frame->colour.height;
    frame->exponent = traced.frame->exponent;
    for (const Pass pass : {Pass::rt_prim, view.map.rays}) {
        frame->layer(pass).hit = thin_out(traced.frame->layer(pass).hit);
        frame->layer(pass).counters = thin_out(traced.frame->layer(pass).counters);
    }
    TracedFrame result = traced;
    result.frame = std::move(frame);
    if (traced.judged && traced.judged->step == 1) {
        auto judged = std::make_shared<JudgedLayer>();
        judged->rays = traced.judged->rays;
        judged->step = sketch_step;
        judged->hits = thin_out(traced.judged->hits);
        judged->tally();
        result.judged = std::move(judged);
    }
    result.scale *= sketch_step;
    return result;
}

template <class T>
Image<T> enlarge(const Image<T>& image, int factor) {
    Image<T> result(image.width * factor, image.height * factor);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) result.at(x, y) = image.at(x / factor, y / factor);
    return result;
}

/// What draw_lines() reads of a frame, enlarged.
Frame enlarge_hits(const Frame& frame, int factor) {
    Frame result;
    result.width = frame.width * factor;
    result.height = frame.height * factor;
    result.layer(Pass::rt_prim).hit = enlarge(frame.layer(Pass::rt_prim).hit, factor);
    return result;
}

Image<Rgba8> paint_image(const TracedFrame& traced, const ViewConfig& view, const std::optional<MapView>& map,
                         const std::optional<CellColours>& cells) {
    const Frame& frame = *traced.frame;
    const KdTree& tree = traced.world->tree;
    if (traced.scale <= coarsest_lines || !view.overlay.show)
        return make_picture(frame, tree, traced.camera, view, map, cells);

    ViewConfig without_lines = view;
    without_lines.overlay.show = false;
    const int factor = traced.scale / coarsest_lines;
    Image<Rgba8> image = enlarge(make_picture(frame, tree, traced.camera, without_lines, map, {}), factor);
    const Frame hits = enlarge_hits(frame, factor);
    draw_lines(image, split_lines(tree, view.overlay), pinhole(traced.camera, hits.width, hits.height), hits,
               view.overlay, cells ? std::span<const Rgba8>(cells->of_node) : std::span<const Rgba8>());
    return image;
}

/// What the view's map and cells are made from, where it is there.
BesideFrame beside_of(const PaintRequest& request) {
    const NodeVisits* visits = request.traced.visits.get();
    if (!is_complete_for(request.traced, request.view, false)) return {nullptr, nullptr, visits};
    return {request.traced.judged.get(), needs_walks(request.view) ? request.traced.walks.get() : nullptr, visits};
}

MapMeaning meaning_of(MapView view) {
    MapMeaning meaning{{}, std::move(view.summary), count_categories(view.map)};
    meaning.labels = std::move(view.map);
    return meaning;
}

}  // namespace

Picture paint(const PaintRequest& request) {
    Picture picture;
    const BesideFrame beside = beside_of(request);
    std::optional<MapView> map = view_map(*request.traced.frame, request.view, beside);
    std::optional<CellColours> cells = view_cells(request.traced.world->tree, request.view, beside);
    picture.image = paint_image(request.traced, request.view, map, cells);
    picture.view = request.view;
    if (map) picture.map = meaning_of(std::move(*map));
    if (cells) {
        CellScale& scale = cells->scale;
        picture.cells = CellMeaning{{std::move(scale.map), std::move(scale.summary), {}}, std::move(scale.heat)};
    }
    picture.traced = request.traced;
    picture.generation = request.generation;
    return picture;
}

Picture paint_sketch(const PaintRequest& request) {
    PaintRequest thin = request;
    thin.traced = thin_out(request.traced, request.view);
    Picture picture = paint(thin);
    picture.traced = request.traced;
    picture.sketch = true;
    return picture;
}

}  // namespace kd

#include "app/window/cost_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/edit.h"
#include "app/window/chart_marks.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr float tag_gap = 3;  // above and below the row of builders' numbers

/// Where the plot lies on the screen.
struct Plot {
    const CostChart& chart;
    ImVec2 low, high;  // its upper left and lower right corner

    [[nodiscard]] float from() const { return chart.cell.costs->cell.lower[chart.axis]; }
    [[nodiscard]] float to() const { return chart.cell.costs->cell.upper[chart.axis]; }
    [[nodiscard]] float x(float position) const {
        return low.x + (high.x - low.x) * std::clamp((position - from()) / (to() - from()), 0.0f, 1.0f);
    }
    [[nodiscard]] float y(double cost) const {
        const double share = (cost - chart.scale.low) / (chart.scale.high - chart.scale.low);
        return high.y - (high.y - low.y) * float(std::clamp(share, 0.0, 1.0));
    }
    [[nodiscard]] float position(float at) const {
        return from() + (to() - from()) * std::clamp((at - low.x) / (high.x - low.x), 0.0f, 1.0f);
    }
};

/// A builder's plane across this axis: its number below the axis, and the place on the curve where it stands.
struct Tag {
    std::size_t choice = 0;
    ImVec2 centre, foot;
};

/// Moves numbers that would lie upon each other apart, each group about its middle, within [low, high] where they fit.
/// The least sum of squared moves: isotonic regression by pooling neighbours, with `step` between them taken off first
/// (Barlow et al., Statistical Inference under Order Restrictions, 1972).
void spread(std::vector<Tag>& tags, float low, float high, float step) {
    struct Pool {
        float sum = 0;
        int count = 0;
        [[nodiscard]] float mean() const { return sum / float(count); }
    };
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < tags.size(); ++i) {
        Pool pool{tags[i].centre.x - float(i) * step, 1};
        for (; !pools.empty() && pools.back().mean() >= pool.mean(); pools.pop_back()) {
            pool.sum += pools.back().sum;
            pool.count += pools.back().count;
        }
        pools.push_back(pool);
    }
    const float last = std::max(low, high - float(tags.size() - 1) * step);
    std::size_t i = 0;
    for (const Pool& pool : pools)
        for (int k = 0; k < pool.count; ++k, ++i)
            tags[i].centre.x = std::clamp(pool.mean(), low, last) + float(i) * step;
}

std::vector<Tag> tags_of(const Plot& plot) {
    const CellCosts& costs = *plot.chart.cell.costs;
    const float size = ImGui::GetTextLineHeight();
    std::vector<Tag> tags;
    for (std::size_t i = 0; i < costs.choices.size(); ++i) {
        const BuilderChoice& choice = costs.choices[i];
        if (!choice.split || choice.split->axis != plot.chart.axis) continue;
        const float x = plot.x(choice.split->position);
        tags.push_back({i, {x, plot.high.y + theme::px(tag_gap) + size / 2}, {x, plot.y(choice.cost)}});
    }
    if (tags.empty()) return tags;
    std::ranges::stable_sort(tags, {}, [](const Tag& tag) { return tag.foot.x; });
    const float room = (plot.high.x - plot.low.x) / float(tags.size());
    spread(tags, plot.low.x + size / 2, plot.high.x - size / 2, std::min(size + theme::px(1), room));
    return tags;
}

void draw_centred(ImDrawList& list, ImVec2 centre, ImU32 colour, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddText({std::round(centre.x - size.x / 2), std::round(centre.y - size.y / 2)}, colour, text.c_str());
}

void draw_tags(ImDrawList& list, const Plot& plot, const std::vector<Tag>& tags, const Tag* hovered) {
    const float radius = ImGui::GetTextLineHeight() / 2;
    for (const Tag& tag : tags) {
        const ImU32 colour = choice_colour(tag.choice);
        list.AddLine({tag.foot.x, plot.high.y}, tag.foot, theme::faded(colour, 0.5f));
        list.AddLine(tag.centre, {tag.foot.x, plot.high.y}, colour);
        list.AddCircleFilled(tag.foot, theme::px(4), theme::outline);
        list.AddCircleFilled(tag.foot, theme::px(3), colour);
    }
    for (const Tag& tag : tags) {
        list.AddCircleFilled(tag.centre, radius, choice_colour(tag.choice));
        if (hovered == &tag) list.AddCircle(tag.centre, radius + theme::px(1), theme::text, 0, theme::px(1.5f));
        draw_centred(list, tag.centre, IM_COL32_BLACK, fmt::format("{}", tag.choice + 1));
    }
}

/// Few candidates: each, and the straight lines between them.
void draw_steps(ImDrawList& list, const Plot& plot, const std::vector<SplitCandidate>& curve) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const SplitCandidate& c = curve[i];
        const float x = plot.x(c.position);
        list.AddLine({x, plot.y(std::max({c.cost_before, c.cost, c.cost_after}))},
                     {x, plot.y(std::min({c.cost_before, c.cost, c.cost_after}))}, theme::faded(theme::text, 0.3f));
        if (i + 1 < curve.size())
            list.AddLine({x, plot.y(c.cost_after)}, {plot.x(curve[i + 1].position), plot.y(curve[i + 1].cost_before)},
                         theme::text, theme::px(1.5f));
        list.AddCircleFilled({x, plot.y(c.cost)}, theme::px(2), theme::text);
    }
}

/// Many: the cheapest of each column, and how far up the others reach. Line by line, because the joints of one path
/// would stick out where it turns back.
void draw_columns(ImDrawList& list, const Plot& plot, const ThinCurve& curve) {
    std::optional<ImVec2> last;
    for (const ThinCurve::Point& point : curve.points) {
        const ImVec2 at{plot.x(point.position), plot.y(point.least)};
        if (point.most > point.least) list.AddLine(at, {at.x, plot.y(point.most)}, theme::faded(theme::text, 0.3f));
        if (last) list.AddLine(*last, at, theme::text, theme::px(1.5f));
        last = at;
    }
}

void draw_curve(ImDrawList& list, const Plot& plot) {
    const std::size_t axis = std::size_t(plot.chart.axis);
    const std::vector<SplitCandidate>& curve = plot.chart.cell.costs->curves[axis];
    constexpr std::size_t few = 64;
    if (curve.size() <= few)
        draw_steps(list, plot, curve);
    else
        draw_columns(list, plot, plot.chart.cell.curves[axis]);
}

/// Costs at the left, positions at both ends below the builders' numbers.
void draw_scales(ImDrawList& list, const Plot& plot) {
    const CostChart& chart = plot.chart;
    const auto range = ValueRange{float(chart.scale.low), float(chart.scale.high)};
    const std::vector<double> ticks = tick_values(range, false, false);
    const std::vector<std::string> texts = tick_texts(ticks, false);
    float free_above = plot.high.y + ImGui::GetTextLineHeight();
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const float y = std::round(plot.y(ticks[i]));
        list.AddLine({plot.low.x, y}, {plot.high.x, y}, theme::line);
        const ImVec2 size = ImGui::CalcTextSize(texts[i].c_str());
        if (!chart.numbers || y + size.y > free_above) continue;
        list.AddText({plot.low.x - size.x - theme::px(4), y - size.y / 2}, theme::dim_text, texts[i].c_str());
        free_above = y;
    }
    const std::string low = number_text(double(plot.from()) * double(chart.unit));
    const std::string high = number_text(double(plot.to()) * double(chart.unit));
    const float y = plot.high.y + ImGui::GetTextLineHeight() + theme::px(2 * tag_gap);
    list.AddText({plot.low.x, y}, theme::dim_text, low.c_str());
    list.AddText({plot.high.x - ImGui::CalcTextSize(high.c_str()).x, y}, theme::dim_text, high.c_str());
    draw_centred(list, {(plot.low.x + plot.high.x) / 2, y + ImGui::GetTextLineHeight() / 2}, theme::text,
                 axis_names[chart.axis]);
}

void draw_plane(ImDrawList& list, const Plot& plot, bool held) {
    if (!plot.chart.plane) return;
    const float x = std::round(plot.x(*plot.chart.plane));
    list.AddLine({x, plot.low.y}, {x, plot.high.y}, theme::selected, theme::px(2));
    const ImVec2 grip{x, plot.y(cost_at(plot.chart, *plot.chart.plane))};
    list.AddCircleFilled(grip, theme::px(7), theme::outline);
    list.AddCircleFilled(grip, theme::px(5), held ? theme::text : theme::selected);
    if (Places* places = Places::current())
        places->add(fmt::format("plane across {}", axis_names[plot.chart.axis]),
                    {grip.x - theme::px(5), grip.y - theme::px(5)}, {grip.x + theme::px(5), grip.y + theme::px(5)});
}

std::string tag_text(const Plot& plot, const BuilderChoice& choice) {
    return fmt::format("{} would cut here: {} at {}, cost {}.\n\nClick: the plane goes there.", choice.builder,
                       axis_names[choice.split->axis],
                       number_text(double(choice.split->position) * double(plot.chart.unit)), number_text(choice.cost));
}

/// What a click at the mouse takes, and what is told of it before.
struct Aim {
    float position = 0;
    const SplitCandidate* candidate = nullptr;  // that stands there; null with Shift held, which goes anywhere
};

std::optional<Aim> aim_at(const Plot& plot, const std::vector<SplitCandidate>& curve, ImVec2 mouse) {
    const float position = plot.position(mouse.x);
    if (ImGui::GetIO().KeyShift) {
        const auto kept = edits::inside(plot.chart.cell.costs->cell, plot.chart.axis, position);
        return kept ? std::optional(Aim{*kept, nullptr}) : std::nullopt;
    }
    const SplitCandidate* nearest = nearest_candidate(curve, position);
    return nearest ? std::optional(Aim{nearest->position, nearest}) : std::nullopt;
}

std::string aim_text(const Plot& plot, const Aim& aim) {
    const std::string place = fmt::format("{} at {}", axis_names[plot.chart.axis],
                                          number_text(double(aim.position) * double(plot.chart.unit)));
    if (!aim.candidate)
        return fmt::format("{}: cost {}", place, number_text(cost_at(plot.chart, aim.position))) +
               ".\n\nDrag or click: the plane goes exactly there. Without Shift it goes to the nearest end of a "
               "triangle.";
    const SplitCandidate& c = *aim.candidate;
    return fmt::format(
        "{}: cost {}, {} triangles below, {} above.\n\nDrag or click: the plane goes there, the nearest end of a "
        "triangle; with Shift held, anywhere. The chart of another axis turns it.",
        place, number_text(c.cost), number_text(c.below), number_text(c.above));
}

/// The tag under the mouse; null where none is.
const Tag* tag_at(const std::vector<Tag>& tags, ImVec2 mouse) {
    const float reach = ImGui::GetTextLineHeight() / 2 + theme::px(1);
    for (const Tag& tag : tags)
        if (std::hypot(mouse.x - tag.centre.x, mouse.y - tag.centre.y) <= reach) return &tag;
    return nullptr;
}

/// What the mouse does in the chart, which is the item that Dear ImGui was given last.
struct Mouse {
    const Tag* tag = nullptr;  // under it
    bool drags = false;        // the plane
    CostAnswer answer;
};

Mouse read_mouse(const Plot& plot, const std::vector<SplitCandidate>& curve, const std::vector<Tag>& tags) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool active = ImGui::IsItemActive();
    Mouse mouse;
    if (active || ImGui::IsItemHovered()) mouse.tag = tag_at(tags, io.MousePos);
    // Dear ImGui keeps what a press that is not over yet began with.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID dragging = ImGui::GetID("dragging");
    if (ImGui::IsItemActivated()) {
        storage.SetBool(dragging, mouse.tag == nullptr);
        mouse.answer.begins = mouse.tag == nullptr;
        if (mouse.tag) mouse.answer.taken = &plot.chart.cell.costs->choices[mouse.tag->choice];
    }
    mouse.drags = active && storage.GetBool(dragging);
    const bool moves = mouse.answer.begins || io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
    if (mouse.drags && moves)
        if (const auto aim = aim_at(plot, curve, io.MousePos)) mouse.answer.position = aim->position;
    if (mouse.drags || ImGui::IsItemHovered())
        ImGui::SetMouseCursor(mouse.tag && !mouse.drags ? ImGuiMouseCursor_Hand : ImGuiMouseCursor_ResizeEW);
    return mouse;
}

void note_tags(const Plot& plot, const std::vector<Tag>& tags) {
    Places* places = Places::current();
    if (!places) return;
    const float reach = theme::px(4);
    for (const Tag& tag : tags)
        places->add(fmt::format("take {}", plot.chart.cell.costs->choices[tag.choice].builder),
                    {tag.centre.x - reach, tag.centre.y - reach}, {tag.centre.x + reach, tag.centre.y + reach});
}

void read_out(const Plot& plot, const std::vector<SplitCandidate>& curve, const Tag* tag) {
    if (tag) return widgets::read_out(tag_text(plot, plot.chart.cell.costs->choices[tag->choice]), false);
    if (const auto aim = aim_at(plot, curve, ImGui::GetIO().MousePos)) widgets::read_out(aim_text(plot, *aim), false);
}

void draw_leaf_cost(ImDrawList& list, const Plot& plot) {
    const float y = std::round(plot.y(plot.chart.cell.costs->leaf_cost));
    const chart::Look look{theme::dim_text, theme::px(1.5f), 0};  // grey: every other colour is a builder's
    chart::draw_stroke(list, {plot.low.x, y}, {plot.high.x, y}, look, Stroke::dashed);
    const ImVec2 word = ImGui::CalcTextSize("leaf");
    const float top = y - word.y < plot.low.y ? y + theme::px(1) : y - word.y;
    list.AddText({plot.high.x - word.x - theme::px(2), top}, theme::dim_text, "leaf");
}

}  // namespace

ImU32 choice_colour(std::size_t choice) {
    // Without the purple of what is selected; the curve's white comes last.
    constexpr std::array colours{theme::cpu, theme::gpu, theme::passed, theme::hit, theme::error, theme::text};
    return colours[choice % colours.size()];
}

CostScale cost_scale(const CellState& cell) {
    const CellCosts& costs = *cell.costs;
    double low = std::min(costs.leaf_cost, costs.chosen_cost), high = std::max(costs.leaf_cost, costs.chosen_cost);
    for (const ThinCurve& curve : cell.curves)
        for (const ThinCurve::Point& point : curve.points) {
            low = std::min(low, point.least);
            high = std::max(high, point.most);
        }
    for (const BuilderChoice& choice : costs.choices) {
        low = std::min(low, choice.cost);
        high = std::max(high, choice.cost);
    }
    const double rim = std::max(0.05 * (high - low), 1e-3 * std::max(1.0, high));
    return {low - rim, high + rim};
}

const SplitCandidate* nearest_candidate(const std::vector<SplitCandidate>& curve, float position) {
    if (curve.empty()) return nullptr;
    const auto above = std::ranges::lower_bound(curve, position, {}, &SplitCandidate::position);
    if (above == curve.begin()) return &*above;
    const auto below = std::prev(above);
    const bool lower = above == curve.end() || position - below->position < above->position - position;
    return lower ? &*below : &*above;
}

double cost_at(const CostChart& chart, float position) {
    const CellCosts& costs = *chart.cell.costs;
    if (costs.chosen && costs.chosen->axis == chart.axis && costs.chosen->position == position)
        return costs.chosen_cost;
    const std::vector<SplitCandidate>& curve = costs.curves[std::size_t(chart.axis)];
    const SplitCandidate* nearest = nearest_candidate(curve, position);
    if (!nearest) return costs.leaf_cost;
    if (nearest->position == position) return nearest->cost;
    const bool is_above = position > nearest->position;
    const std::ptrdiff_t below = nearest - curve.data() - (is_above ? 0 : 1);
    if (below < 0) return nearest->cost_before;
    if (below + 1 == std::ssize(curve)) return nearest->cost_after;
    const SplitCandidate &low = curve[std::size_t(below)], &high = curve[std::size_t(below + 1)];
    const double start = double(low.position);
    const double share = (double(position) - start) / (double(high.position) - start);
    return std::lerp(low.cost_after, high.cost_before, share);
}

CostAnswer draw_cost_chart(const CostChart& chart, ImVec2 size) {
    const std::vector<SplitCandidate>& curve = chart.cell.costs->curves[std::size_t(chart.axis)];
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(axis_names[chart.axis], size);
    Places::note(fmt::format("across {}", axis_names[chart.axis]));
    const float margin = chart.numbers ? theme::px(44) : theme::px(6);
    const Plot plot{chart,
                    {corner.x + margin, corner.y},
                    {corner.x + size.x - theme::px(6),
                     corner.y + size.y - 2 * ImGui::GetTextLineHeight() - theme::px(2 * tag_gap + 2)}};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(plot.low, plot.high, theme::sunken);
    draw_scales(list, plot);
    if (curve.empty()) {
        draw_centred(list, {(plot.low.x + plot.high.x) / 2, (plot.low.y + plot.high.y) / 2}, theme::dim_text,
                     "no plane");
        return {};
    }
    draw_leaf_cost(list, plot);
    draw_curve(list, plot);
    const std::vector<Tag> tags = tags_of(plot);
    const Mouse mouse = read_mouse(plot, curve, tags);
    draw_plane(list, plot, mouse.drags);
    draw_tags(list, plot, tags, mouse.drags ? nullptr : mouse.tag);
    note_tags(plot, tags);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) read_out(plot, curve, mouse.tag);
    return mouse.answer;
}

}  // namespace kd

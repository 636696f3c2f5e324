#include "app/window/state_file.h"

#include "app/json_values.h"
#include "app/window/exporting.h"
#include "renderer/io/file.h"

namespace kd {

namespace {

Json json_of(const std::optional<PixelReading>& reading) {
    if (!reading) return nullptr;
    Json result{{"x", reading->pixel.x}, {"y", reading->pixel.y}, {"scale", reading->scale}};
    for (std::size_t p = 0; p < pass_count; ++p) {
        const PassReading& ray = reading->passes[p];
        if (!ray.traced) continue;
        Json numbers{{"triangle", ray.hit.triangle},
                     {"t", json_number(ray.hit.t)},
                     {"exit", exit_reason_name(ray.counters.exit_reason)}};
        for (const CounterInfo& counter : counter_table())
            numbers[std::string(counter.name)] = ray.counters.*counter.field;
        result[json_key(ray_names[p])] = numbers;
    }
    return result;
}

Json messages_json(const EngineState& state) {
    Json list = Json::array();
    for (const Message& message : state.messages) list.push_back({{"error", message.error}, {"text", message.text}});
    return list;
}

}  // namespace

std::string state_json(const EngineState& state, const Edit& edit, const Rectangle& picture) {
    Json json = summary_json(state);
    json["window"] = {{"panels", edit.window.panels}, {"help", edit.window.help}};
    json["picture_area"] = {picture.x, picture.y, picture.width, picture.height};
    json["hovered"] = json_of(state.hovered);
    json["pinned"] = json_of(state.pinned);
    json["messages"] = messages_json(state);
    json["last_export"] = edit.last_export;
    return json_text(json);
}

void StateFile::update(const EngineState& state, const Edit& edit, const Rectangle& picture, bool visible_change) {
    if (path_.empty() || !visible_change || state.stale() || state.working()) return;
    const std::string text = state_json(state, edit, picture);
    if (text == written_) return;
    write_file(path_, text);
    written_ = text;
}

}  // namespace kd

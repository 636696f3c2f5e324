#include "app/session_reader.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

/// A value as people may find it again in their file.
std::string shown(const Json& value) {
    if (value.is_object()) return "{...}";
    if (value.is_array() && value.size() > 4) return "[...]";
    return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), 80);
}

}  // namespace

FieldReader::FieldReader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object())
        throw InputError(fmt::format("{}: {} is not an object with keys, {{...}}", place_, shown(json)));
}

const Json* FieldReader::find(const char* key) {
    known_.emplace_back(key);
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
}

std::string FieldReader::place_of(const std::string& key) const {
    return fmt::format("{}{}/{}", place_, place_.find(": /") == std::string::npos ? ": " : "", printable(key));
}

void FieldReader::refuse(const std::string& key, const std::string& why) const {
    throw InputError(fmt::format("{}: {}", place_of(key), printable(why, 1000)));
}

void FieldReader::refuse_value(const Json& found, const std::string& key, const std::string& wanted) const {
    refuse(key, fmt::format("{} is not {}", shown(found), wanted));
}

void FieldReader::refuse_others() const {
    for (const auto& [key, value] : json_.items())
        if (std::ranges::find(known_, key) == known_.end())
            refuse(key, "unknown key" + did_you_mean(key, known_) + "; leave it out");
}

bool FieldReader::bool_in(const Json& found, const std::string& key) const {
    if (!found.is_boolean()) refuse_value(found, key, "true or false");
    return found.get<bool>();
}

std::string FieldReader::text_in(const Json& found, const std::string& key) const {
    if (!found.is_string()) refuse_value(found, key, "a text in quotes");
    return found.get<std::string>();
}

std::vector<float> FieldReader::floats_in(const Json& found, const std::string& key, std::size_t count,
                                          const char* wanted) const {
    if (!found.is_array() || found.size() != count) refuse_value(found, key, wanted);
    std::vector<float> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(number_in(found[i], fmt::format("{}/{}", key, i), limits::any_number));
    return values;
}

void FieldReader::text(const char* key, std::string& value) {
    if (const Json* found = find(key)) value = text_in(*found, key);
}

void FieldReader::flag(const char* key, bool& value) {
    if (const Json* found = find(key)) value = bool_in(*found, key);
}

void FieldReader::opposite(const char* key, bool& value) {
    if (const Json* found = find(key)) value = !bool_in(*found, key);
}

void FieldReader::point(const char* key, Vec3& value) {
    const Json* found = find(key);
    if (!found) return;
    const std::vector<float> v = floats_in(*found, key, 3, "three numbers, [x, y, z]");
    value = {v[0], v[1], v[2]};
}

void FieldReader::node_bytes(const char* key, NodeEncoding& value) {
    const Json* found = find(key);
    if (!found) return;
    const auto known = choices::node_encodings();
    const auto match = [&](const NamedValue<NodeEncoding>& choice) { return *found == bytes_of(choice.value); };
    const auto wanted = std::ranges::find_if(known, match);
    if (wanted == known.end()) refuse_value(*found, key, "16 or 8, the bytes of a node");
    value = wanted->value;
}

void FieldReader::packet_rays(const char* key, int& value) {
    const Json* found = find(key);
    if (!found) return;
    for (const auto& [name, rays] : choices::packet_sizes())
        if (*found == rays || *found == name) {
            value = rays;
            return;
        }
    refuse_value(*found, key, "4, 8 or 16, the rays of a packet");
}

void FieldReader::set(const char* key, FeatureSet& value, const std::vector<NamedValue<Feature>>& choices) {
    const Json* found = find(key);
    if (!found) return;
    if (!found->is_array()) refuse_value(*found, key, "a list of names, [...]");
    value = {};
    for (std::size_t i = 0; i < found->size(); ++i)
        value.set(choice_in((*found)[i], fmt::format("{}/{}", key, i), choices), true);
}

void FieldReader::value_range(const char* key, HeatmapConfig& heat) {
    const Json* locked = find("locked");
    const bool stays = locked && bool_in(*locked, "locked");
    const Json* found = find(key);
    const char* wanted = "\"automatic\" or [LOW, HIGH] with LOW below HIGH";
    if (!found || *found == "automatic") {
        if (stays) refuse("locked", fmt::format("there is nothing to lock; {} must be [LOW, HIGH]", place_of(key)));
        if (found) heat.range_mode = RangeMode::automatic;
        return;
    }
    const std::vector<float> ends = floats_in(*found, key, 2, wanted);
    if (!(ends[0] < ends[1])) refuse_value(*found, key, wanted);
    heat.range_mode = stays ? RangeMode::locked : RangeMode::fixed;
    heat.range_min = ends[0];
    heat.range_max = ends[1];
}

void FieldReader::hand_splits(const char* key, std::vector<HandSplit>& value) {
    const Json* found = find(key);
    if (!found) return;
    if (!found->is_array()) refuse_value(*found, key, "a list of planes, [{...}, {...}]");
    value.clear();
    for (std::size_t i = 0; i < found->size(); ++i) {
        const std::string place = fmt::format("{}/{}", key, i);
        FieldReader inner((*found)[i], place_of(place));
        visit_hand_split(inner, value.emplace_back());
        inner.refuse_others();
        if (const auto fault = hand_split_fault(value, i)) refuse(place, *fault);
    }
}

void FieldReader::camera(const char* key, std::optional<Camera>& value) {
    const Json* found = find(key);
    if (!found) return;
    value.emplace();
    FieldReader inner(*found, place_of(key));
    visit_camera(inner, *value);
    inner.refuse_others();
    if (value->up == Vec3(0)) inner.refuse("up", "[0, 0, 0] is no direction");
    if (!(value->fov_y_degrees > limits::fov.low)) inner.refuse("fov", "the angle of view must be above 0");
    if (!is_valid(*value)) refuse(key, "eye and target must differ");
}

}  // namespace kd

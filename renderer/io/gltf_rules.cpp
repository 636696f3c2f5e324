#include "renderer/io/gltf_rules.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

namespace kd {

using nlohmann::json;

namespace {

enum class Kind {
    object,
    list,
    text,
    number,
    element,      // name of an accessor's element type
    whole,        // 0, 1, 2, ...
    whole_31bit,  // tinygltf keeps it in an int
    index,        // of an element of the top-level list `list`
    numbers,      // exactly `length` of them
};

struct Rule {
    std::string_view pattern;  // a JSON pointer; '*' stands for every element or member
    Kind kind;
    bool required = false;  // wherever its parent exists
    std::string_view list = {};
    std::size_t length = 0;
};

constexpr std::array<std::string_view, 7> element_types{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};

constexpr bool required = true;
constexpr bool optional = false;

constexpr Rule header_rules[] = {
    {"/asset", Kind::object, required},    {"/asset/version", Kind::text, required},
    {"/asset/minVersion", Kind::text},     {"/extensionsUsed", Kind::list},
    {"/extensionsUsed/*", Kind::text},     {"/extensionsRequired", Kind::list},
    {"/extensionsRequired/*", Kind::text},
};

// A container comes before what it holds, so that a rule only meets containers of the right type.
constexpr Rule content_rules[] = {
    {"/scenes", Kind::list},
    {"/scenes/*", Kind::object},
    {"/scene", Kind::index, optional, "scenes"},
    {"/scenes/*/nodes", Kind::list},
    {"/nodes", Kind::list},
    {"/nodes/*", Kind::object},
    {"/scenes/*/nodes/*", Kind::index, optional, "nodes"},
    {"/nodes/*/children", Kind::list},
    {"/nodes/*/children/*", Kind::index, optional, "nodes"},
    {"/nodes/*/matrix", Kind::numbers, optional, {}, 16},
    {"/nodes/*/translation", Kind::numbers, optional, {}, 3},
    {"/nodes/*/rotation", Kind::numbers, optional, {}, 4},
    {"/nodes/*/scale", Kind::numbers, optional, {}, 3},
    {"/meshes", Kind::list},
    {"/meshes/*", Kind::object},
    {"/nodes/*/mesh", Kind::index, optional, "meshes"},
    {"/cameras", Kind::list},
    {"/cameras/*", Kind::object},
    {"/nodes/*/camera", Kind::index, optional, "cameras"},
    {"/accessors", Kind::list},
    {"/accessors/*", Kind::object},
    {"/meshes/*/primitives", Kind::list, required},
    {"/meshes/*/primitives/*", Kind::object},
    {"/meshes/*/primitives/*/attributes", Kind::object, required},
    {"/meshes/*/primitives/*/attributes/*", Kind::index, optional, "accessors"},
    {"/meshes/*/primitives/*/indices", Kind::index, optional, "accessors"},
    {"/meshes/*/primitives/*/mode", Kind::whole_31bit},
    {"/meshes/*/primitives/*/material", Kind::whole_31bit},
    {"/buffers", Kind::list},
    {"/buffers/*", Kind::object},
    {"/buffers/*/byteLength", Kind::whole, required},
    {"/buffers/*/uri", Kind::text},
    {"/bufferViews", Kind::list},
    {"/bufferViews/*", Kind::object},
    {"/bufferViews/*/buffer", Kind::index, required, "buffers"},
    {"/bufferViews/*/byteOffset", Kind::whole},
    {"/bufferViews/*/byteLength", Kind::whole, required},
    {"/bufferViews/*/byteStride", Kind::whole},
    {"/accessors/*/bufferView", Kind::index, optional, "bufferViews"},
    {"/accessors/*/byteOffset", Kind::whole},
    {"/accessors/*/componentType", Kind::whole_31bit, required},
    {"/accessors/*/count", Kind::whole, required},
    {"/accessors/*/type", Kind::element, required},
    {"/accessors/*/sparse", Kind::object},
    {"/accessors/*/sparse/count", Kind::whole_31bit, required},
    {"/accessors/*/sparse/indices", Kind::object, required},
    {"/accessors/*/sparse/indices/bufferView", Kind::index, required, "bufferViews"},
    {"/accessors/*/sparse/indices/byteOffset", Kind::whole_31bit},
    {"/accessors/*/sparse/indices/componentType", Kind::whole_31bit, required},
    {"/accessors/*/sparse/values", Kind::object, required},
    {"/accessors/*/sparse/values/bufferView", Kind::index, required, "bufferViews"},
    {"/accessors/*/sparse/values/byteOffset", Kind::whole_31bit},
    {"/images", Kind::list},
    {"/images/*", Kind::object},
    {"/images/*/bufferView", Kind::index, optional, "bufferViews"},
    {"/images/*/uri", Kind::text},
    {"/textures", Kind::list},
    {"/textures/*", Kind::object},
    {"/samplers", Kind::list},
    {"/samplers/*", Kind::object},
    {"/skins", Kind::list},
    {"/skins/*", Kind::object},
    {"/skins/*/joints", Kind::list, required},
    {"/skins/*/joints/*", Kind::index, optional, "nodes"},
    {"/skins/*/inverseBindMatrices", Kind::index, optional, "accessors"},
    {"/nodes/*/skin", Kind::index, optional, "skins"},
    {"/nodes/*/weights", Kind::list},
    {"/nodes/*/weights/*", Kind::number},
    {"/meshes/*/weights", Kind::list},
    {"/meshes/*/weights/*", Kind::number},
    {"/meshes/*/primitives/*/targets", Kind::list},
    {"/meshes/*/primitives/*/targets/*", Kind::object},
    {"/meshes/*/primitives/*/targets/*/*", Kind::index, optional, "accessors"},
    {"/animations", Kind::list},
    {"/animations/*", Kind::object},
    {"/animations/*/samplers", Kind::list, required},
    {"/animations/*/samplers/*", Kind::object},
    {"/animations/*/samplers/*/input", Kind::index, required, "accessors"},
    {"/animations/*/samplers/*/output", Kind::index, required, "accessors"},
    {"/animations/*/samplers/*/interpolation", Kind::text},
    {"/animations/*/channels", Kind::list, required},
    {"/animations/*/channels/*", Kind::object},
    {"/animations/*/channels/*/sampler", Kind::whole_31bit, required},
    {"/animations/*/channels/*/target", Kind::object, required},
    {"/animations/*/channels/*/target/node", Kind::index, optional, "nodes"},
    {"/animations/*/channels/*/target/path", Kind::text, required},
    {"/materials", Kind::list},
    {"/materials/*", Kind::object},
    {"/materials/*/emissiveFactor", Kind::numbers, optional, {}, 3},
    {"/materials/*/pbrMetallicRoughness", Kind::object},
    {"/materials/*/pbrMetallicRoughness/baseColorFactor", Kind::numbers, optional, {}, 4},
    {"/materials/*/pbrMetallicRoughness/metallicFactor", Kind::number},
    {"/materials/*/pbrMetallicRoughness/roughnessFactor", Kind::number},
    {"/materials/*/pbrMetallicRoughness/baseColorTexture", Kind::object},
    {"/materials/*/pbrMetallicRoughness/metallicRoughnessTexture", Kind::object},
};

bool names_element(std::string_view name) { return std::ranges::find(element_types, name) != element_types.end(); }

/// What a value that breaks the rule must be; empty where it keeps it.
std::string complaint(const Rule& rule, const json& value, const json& gltf) {
    const auto demand = [](bool good, const char* text) { return std::string(good ? "" : text); };
    switch (rule.kind) {
        case Kind::object: return demand(value.is_object(), "must be an object");
        case Kind::list: return demand(value.is_array(), "must be a list");
        case Kind::text: return demand(value.is_string(), "must be text");
        case Kind::number: return demand(value.is_number(), "must be a number");
        case Kind::element:
            return demand(value.is_string() && names_element(value.get_ref<const std::string&>()),
                          "must be SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
        case Kind::whole: return demand(value.is_number_unsigned(), "must be a whole number, 0 or more");
        case Kind::whole_31bit:
            return demand(value.is_number_unsigned() &&
                              value.get<std::uint64_t>() <= std::uint64_t(std::numeric_limits<int>::max()),
                          "must be a whole number from 0 to 2147483647");
        case Kind::index: {
            const auto list = gltf.find(rule.list);
            const std::size_t count = list != gltf.end() && list->is_array() ? list->size() : 0;
            if (value.is_number_unsigned() && value.get<std::uint64_t>() < count) return "";
            return (value.is_number_integer() ? value.dump() : "this") + " is not one of the " + std::to_string(count) +
                   " " + std::string(rule.list);
        }
        case Kind::numbers: {
            bool good = value.is_array() && value.size() == rule.length;
            for (std::size_t i = 0; good && i < value.size(); ++i) good = value[i].is_number();
            return good ? "" : "must be a list of " + std::to_string(rule.length) + " numbers";
        }
    }
    return "";
}

/// Checks all values below `value` that the rest of the rule's pattern matches. Recurses once per part of a pattern.
void check_below(const GltfContext& context, const json& gltf, const Rule& rule, std::string_view rest,
                 const json& value, const std::string& pointer) {
    if (rest.empty()) {
        const std::string reason = complaint(rule, value, gltf);
        if (!reason.empty()) context.fail(pointer, reason);
        return;
    }
    const std::size_t end = std::min(rest.find('/', 1), rest.size());
    const std::string_view part = rest.substr(1, end - 1);
    const std::string_view after = rest.substr(end);
    if (part != "*") {
        if (!value.is_object()) return;
        const auto member = value.find(part);
        if (member != value.end()) {
            check_below(context, gltf, rule, after, *member, pointer_to(pointer, part));
        } else if (rule.required && after.empty()) {
            context.fail(pointer_to(pointer, part), "missing");
        }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            check_below(context, gltf, rule, after, value[i], pointer_to(pointer, i));
        }
    } else if (value.is_object()) {
        for (const auto& [key, member] : value.items()) {
            check_below(context, gltf, rule, after, member, pointer_to(pointer, key));
        }
    }
}

}  // namespace

void check_gltf_rules(const GltfContext& context, const json& gltf, GltfRules rules) {
    const std::span<const Rule> table =
        rules == GltfRules::header ? std::span<const Rule>(header_rules) : std::span<const Rule>(content_rules);
    for (const Rule& rule : table) check_below(context, gltf, rule, rule.pattern, gltf, "");
}

}  // namespace kd

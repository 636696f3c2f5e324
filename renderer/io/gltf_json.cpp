#include "renderer/io/gltf_json.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "renderer/io/gltf_rules.h"
#include "renderer/io/printable.h"

namespace kd {

using nlohmann::json;

namespace {

constexpr std::array<std::string_view, 5> supported_extensions{"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                                               "KHR_materials_pbrSpecularGlossiness",
                                                               "KHR_mesh_quantization", "KHR_texture_transform"};
constexpr int deepest_nesting = 256;

bool supported(std::string_view extension) {
    return std::ranges::find(supported_extensions, extension) != supported_extensions.end();
}

/// Before it is parsed: how deep it is nested, which costs stack, and how many values it can hold, which cost memory.
void check_extent(const GltfContext& context, std::string_view text) {
    int depth = 0;
    std::uint64_t values = 1;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
            continue;
        }
        if (c == '"') in_string = true;
        if (c == '[' || c == '{') ++depth;
        if (c == '[' || c == '{' || c == ',' || c == ':') ++values;
        if (c == ']' || c == '}') --depth;
        if (depth > deepest_nesting) context.fail("", "JSON nested deeper than " + std::to_string(deepest_nesting));
    }
    if (values > context.limits().json_values) {
        context.fail("", "about " + std::to_string(values) + " JSON values; the limit is " +
                             std::to_string(context.limits().json_values));
    }
}

/// "line 3, column 7" of the byte before `end`.
std::string place_of(std::string_view text, std::size_t end) {
    const std::string_view before = text.substr(0, end > 0 ? end - 1 : 0);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t line_begin = before.find_last_of('\n') + 1;  // npos + 1 is 0
    return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - line_begin + 1);
}

void check_version(const GltfContext& context, const json& asset) {
    const auto version = asset.at("version").get<std::string>();
    if (!version.starts_with("2.")) {
        context.fail("/asset/version", "'" + printable(version, 20) + "' is not supported; export as glTF 2.0");
    }
    const auto least = asset.find("minVersion");
    if (least != asset.end() && *least != "2.0") {
        context.fail("/asset/minVersion", "'" + printable(least->get<std::string>(), 20) +
                                              "' is not supported; this program reads glTF 2.0");
    }
}

void check_extensions(GltfContext& context, const json& gltf) {
    const json required = gltf.value("extensionsRequired", json::array());
    for (std::size_t i = 0; i < required.size(); ++i) {
        const auto name = required[i].get<std::string>();
        if (!supported(name)) {
            context.fail(pointer_to("/extensionsRequired", i),
                         "extension " + printable(name, 60) + " is not supported; export without it");
        }
    }
    for (const json& used : gltf.value("extensionsUsed", json::array())) {
        const auto name = used.get<std::string>();
        if (!supported(name)) context.note("ignored extension " + printable(name, 60));
    }
}

}  // namespace

json parse_gltf_json(const GltfContext& context, std::string_view text) {
    check_extent(context, text);
    try {
        json gltf = json::parse(text.begin(), text.end());
        if (!gltf.is_object()) context.fail("", "the JSON is not an object, so this is not glTF");
        return gltf;
    } catch (const json::parse_error& error) {
        context.fail("", place_of(text, error.byte) + ": not valid JSON, or the file is cut off");
    } catch (const json::out_of_range&) {
        context.fail("", "the JSON holds a number that is too large");
    }
}

void check_gltf_json(GltfContext& context, const json& gltf) {
    // Version and extensions come first: of a file that this program cannot know, nothing else can be said.
    check_gltf_rules(context, gltf, GltfRules::header);
    check_version(context, gltf.at("asset"));
    check_extensions(context, gltf);
    check_gltf_rules(context, gltf, GltfRules::content);
}

}  // namespace kd

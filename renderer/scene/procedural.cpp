#include "renderer/scene/procedural.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <utility>

#include "renderer/scene/procedural_table.h"

namespace kd {

namespace {

/// The size in `text`, what stands after ':' in `name`.
int parse_size(std::string_view name, std::string_view text, const ProceduralScene& entry) {
    const std::string remedy = fmt::format("try {}:{}", entry.name, entry.default_size);
    if (text.empty()) throw InputError(fmt::format("{}: size is missing; {}", name, remedy));
    int size = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (end != text.data() + text.size() || error == std::errc::invalid_argument)
        throw InputError(fmt::format("{}: size is not a whole number; {}", name, remedy));
    if (error == std::errc::result_out_of_range || size < entry.smallest_size || size > entry.largest_size)
        throw InputError(
            fmt::format("{}: size is not in {}..{}; {}", name, entry.smallest_size, entry.largest_size, remedy));
    return size;
}

}  // namespace

std::span<const ProceduralScene> procedural_scenes() {
#define KD_LIST_SCENE(name) name##_scene(),
    static const ProceduralScene table[] = {KD_PROCEDURAL_SCENES(KD_LIST_SCENE)};
#undef KD_LIST_SCENE
    return table;
}

const ProceduralScene* find_procedural(std::string_view name) {
    const auto entry = std::ranges::find(procedural_scenes(), name.substr(0, name.find(':')), &ProceduralScene::name);
    return entry == procedural_scenes().end() ? nullptr : &*entry;
}

int size_of(const ProceduralScene& entry, std::string_view name) {
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos) return entry.default_size;
    if (entry.default_size == 0)
        throw InputError(fmt::format("{}: this scene takes no size; try {}", name, entry.name));
    return parse_size(name, name.substr(colon + 1), entry);
}

std::optional<Scene> make_procedural(std::string_view name, unsigned seed) {
    const ProceduralScene* entry = find_procedural(name);
    if (!entry) return std::nullopt;

    const int size = size_of(*entry, name);
    Scene scene = entry->make(size, seed);
    scene.name = entry->default_size == 0 ? std::string(entry->name) : fmt::format("{}:{}", entry->name, size);
    return scene;
}

}  // namespace kd

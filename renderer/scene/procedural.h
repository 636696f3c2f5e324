// Scenes made by the program, by name: "ball:9000", "rooms", ... Deterministic for a name and a seed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "renderer/geometry/input_error.h"
#include "renderer/scene/scene.h"

namespace kd {

struct ProceduralScene {
    std::string_view name;  // "ball"
    int default_size;       // N where none is given; 0 = the scene takes no size
    int smallest_size;      // N must lie in smallest_size..largest_size
    int largest_size;
    std::string_view summary;  // one sentence
    Scene (*make)(int size, unsigned seed);
    bool seeded = false;  // another seed makes another scene
};

/// All of them, in the order they are listed to people.
[[nodiscard]] std::span<const ProceduralScene> procedural_scenes();

/// The entry that `name` ("ball:9000") belongs to by what stands before ':'; null where there is none.
[[nodiscard]] const ProceduralScene* find_procedural(std::string_view name);

/// The size that `name` ("ball:9000") asks this scene for; 0 where it takes none. InputError as make_procedural().
[[nodiscard]] int size_of(const ProceduralScene& entry, std::string_view name);

/// The scene called `name` ("ball:9000"); nothing where the name before ':' is not procedural.
/// Throws InputError for a size that is missing, not a number or out of range.
[[nodiscard]] std::optional<Scene> make_procedural(std::string_view name, unsigned seed = 1);

}  // namespace kd

// How much a glTF file may ask for. Every limit is checked by numbers in the file, before memory is taken for them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace kd {

struct GltfLimits {
    std::uint64_t json_values = 16'000'000;                     // numbers, texts, lists, objects; about 4 GiB decoded
    std::uint64_t buffer_bytes = std::uint64_t(2) << 30;        // all buffers together
    std::uint64_t image_file_bytes = std::uint64_t(256) << 20;  // one image, encoded
    std::uint64_t image_bytes = std::uint64_t(1) << 30;         // all images, encoded
    std::uint64_t image_pixels = std::uint64_t(64) << 20;       // one image, decoded: 256 MiB
    std::uint64_t all_image_pixels = std::uint64_t(256) << 20;  // all images that are shown
    std::uint64_t triangles = 50'000'000;                       // after instancing
    std::uint64_t vertices = 50'000'000;                        // before it
    std::uint64_t instances = 5'000'000;                        // of primitives
    std::uint64_t deformed = 100'000'000;   // vertices of deformed meshes, again for each target and set of joints
    std::uint64_t key_values = 50'000'000;  // of all animations
    std::size_t lights = 64;                // more are ignored and counted
    std::size_t notes = 100;                // more are only counted
};

}  // namespace kd

// The binary container of glTF, GLB: a header, a JSON chunk, and at most one binary chunk.
#pragma once

#include <cstddef>
#include <string_view>

#include "renderer/io/gltf_context.h"

namespace kd {

/// The JSON text of a file, and what comes with it. Views into the file's bytes.
struct GltfText {
    std::string_view json;
    std::string_view container;   // the GLB without trailing bytes; empty for a .gltf
    std::size_t binary_size = 0;  // bytes of the binary chunk

    [[nodiscard]] bool is_binary() const { return !container.empty(); }
};

/// Tells GLB from JSON by the first four bytes and checks every length of a GLB against the bytes that are there.
/// InputError, also for what was `named_glb` and is neither. Trailing bytes are cut off with a note.
[[nodiscard]] GltfText open_gltf(GltfContext& context, std::string_view bytes, bool named_glb);

}  // namespace kd

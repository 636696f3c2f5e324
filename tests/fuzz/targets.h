// What is fuzzed: one function per format that takes any bytes. Each returns where the bytes were read or refused as
// they should be, and throws std::logic_error where a promise is broken; a sanitizer ends the program for all else.
#pragma once

#include <string_view>

namespace kd::fuzz {

/// A .gltf or .glb file: decoded under small limits, flattened, and built into a tree by every builder.
void gltf(std::string_view bytes);

/// A table of rays: what can be read must come back bit for bit from the text written for it.
void rays_csv(std::string_view bytes);

/// A session file: what can be read must come back bit for bit from the text written for it.
void session(std::string_view bytes);

}  // namespace kd::fuzz

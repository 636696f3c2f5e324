// Reading extension objects, which tinygltf keeps as trees of values.
#pragma once

#include <optional>
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace kd {

/// The extension object `name`; nullptr where it is absent or not an object.
[[nodiscard]] const tinygltf::Value* find_extension(const tinygltf::ExtensionMap& extensions, const std::string& name);
/// The member object `name`; nullptr where it is absent or not an object.
[[nodiscard]] const tinygltf::Value* find_object(const tinygltf::Value& object, const std::string& name);
/// The member number `name`, or `otherwise`.
[[nodiscard]] double number_or(const tinygltf::Value& object, const std::string& name, double otherwise);
/// The member `name` as an index, 0 or more; nothing where it is absent or no such number.
[[nodiscard]] std::optional<int> find_index(const tinygltf::Value& object, const std::string& name);
/// The member list `name` of as many numbers as `otherwise` has, or `otherwise`.
[[nodiscard]] std::vector<double> numbers_or(const tinygltf::Value& object, const std::string& name,
                                             std::vector<double> otherwise);

}  // namespace kd

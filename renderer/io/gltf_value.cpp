#include "renderer/io/gltf_value.h"

namespace kd {

const tinygltf::Value* find_extension(const tinygltf::ExtensionMap& extensions, const std::string& name) {
    const auto found = extensions.find(name);
    return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

const tinygltf::Value* find_object(const tinygltf::Value& object, const std::string& name) {
    const tinygltf::Value& member = object.Get(name);
    return member.IsObject() ? &member : nullptr;
}

double number_or(const tinygltf::Value& object, const std::string& name, double otherwise) {
    const tinygltf::Value& member = object.Get(name);
    return member.IsNumber() ? member.GetNumberAsDouble() : otherwise;
}

std::optional<int> find_index(const tinygltf::Value& object, const std::string& name) {
    const tinygltf::Value& member = object.Get(name);
    if (!member.IsInt() || member.Get<int>() < 0) return std::nullopt;
    return member.Get<int>();
}

std::vector<double> numbers_or(const tinygltf::Value& object, const std::string& name, std::vector<double> otherwise) {
    const tinygltf::Value& member = object.Get(name);
    if (member.ArrayLen() != otherwise.size()) return otherwise;
    std::vector<double> numbers;
    for (int i = 0; i < static_cast<int>(member.ArrayLen()); ++i) {
        if (!member.Get(i).IsNumber()) return otherwise;
        numbers.push_back(member.Get(i).GetNumberAsDouble());
    }
    return numbers;
}

}  // namespace kd

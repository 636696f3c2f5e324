#include "renderer/io/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "renderer/io/gltf_accessor.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

constexpr const char* channel_noun = "animation channel";

RigNode rig_node(const PlacedNode& placed, const tinygltf::Node& node) {
    RigNode found{.parent = placed.parent, .matrix = placed.to_parent};
    const std::vector<double>&t = node.translation, &r = node.rotation, &s = node.scale;
    if (t.size() == 3) found.translation = {t[0], t[1], t[2]};
    if (s.size() == 3) found.scale = {s[0], s[1], s[2]};
    if (r.size() == 4) {
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        const double length = glm::length(rotation);
        if (length > 0.0 && std::isfinite(length)) found.rotation = rotation / length;
    }
    return found;
}

std::optional<RigPath> path_called(const std::string& name) {
    if (name == "translation") return RigPath::translation;
    if (name == "rotation") return RigPath::rotation;
    if (name == "scale") return RigPath::scale;
    if (name == "weights") return RigPath::weights;
    return std::nullopt;
}

std::optional<Interpolation> interpolation_called(const std::string& name) {
    if (name == "STEP") return Interpolation::step;
    if (name == "LINEAR" || name.empty()) return Interpolation::linear;
    if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
    return std::nullopt;
}

bool all_finite(const std::vector<float>& values) {
    return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

/// Finite, from 0 on, each later than the one before.
bool are_times(const std::vector<float>& times) {
    return all_finite(times) && times.front() >= 0.0f &&
           std::ranges::adjacent_find(times, [](float a, float b) { return !(a < b); }) == times.end();
}

class ChannelReader {
  public:
    ChannelReader(GltfContext& context, const tinygltf::Model& model) : context_(context), model_(model) {}

    /// Nothing, and a note, where it cannot be used.
    std::optional<RigChannel> read(const tinygltf::Animation& animation, const tinygltf::AnimationChannel& channel,
                                   std::size_t node) {
        const std::optional<RigPath> path = path_called(channel.target_path);
        if (!path) return ignored(", which move what glTF 2.0 does not name");
        if (std::size_t(channel.sampler) >= animation.samplers.size()) return ignored(", whose sampler is missing");
        const tinygltf::AnimationSampler& sampler = animation.samplers[std::size_t(channel.sampler)];
        const std::optional<Interpolation> way = interpolation_called(sampler.interpolation);
        if (!way) return ignored(", whose interpolation is unknown");
        const std::string misfit = why_unfit(sampler, *path, *way);
        if (!misfit.empty()) return ignored(misfit);
        charge(accessor(sampler.input));
        charge(accessor(sampler.output));

        RigChannel read{.node = node, .path = *path, .keys = {}};
        read.keys.interpolation = *way;
        read.keys.times = read_floats(context_, model_, sampler.input);
        read.keys.values = read_floats(context_, model_, sampler.output);
        const std::size_t each = *way == Interpolation::cubic_spline ? 3 : 1;
        read.keys.width = read.keys.values.size() / (read.keys.times.size() * each);
        if (!are_times(read.keys.times)) return ignored(", whose times do not ascend from 0 on");
        if (!all_finite(read.keys.values)) return ignored(", whose values are not finite");
        return read;
    }

  private:
    std::optional<RigChannel> ignored(const std::string& why) {
        context_.count("ignored", channel_noun, why);
        return std::nullopt;
    }

    [[nodiscard]] const tinygltf::Accessor& accessor(int index) const { return model_.accessors[std::size_t(index)]; }

    /// Of types and counts alone; empty where they fit.
    [[nodiscard]] std::string why_unfit(const tinygltf::AnimationSampler& sampler, RigPath path,
                                        Interpolation way) const {
        const tinygltf::Accessor &in = accessor(sampler.input), &out = accessor(sampler.output);
        if (in.type != TINYGLTF_TYPE_SCALAR || in.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
            return ", whose times are not SCALAR of float";
        const int type = path == RigPath::weights    ? TINYGLTF_TYPE_SCALAR
                         : path == RigPath::rotation ? TINYGLTF_TYPE_VEC4
                                                     : TINYGLTF_TYPE_VEC3;
        const std::uint64_t keys = in.count * (way == Interpolation::cubic_spline ? 3 : 1);
        const bool whole = path == RigPath::weights ? out.count >= keys && out.count % keys == 0 : out.count == keys;
        return out.type == type && whole ? "" : ", whose values do not go with their times";
    }

    /// Before it is read. Cut to just above the limit, so that no product or sum comes near 2^64.
    void charge(const tinygltf::Accessor& read) {
        values_ += std::min<std::uint64_t>(read.count, context_.limits().key_values + 1) * component_count(read);
        if (values_ > context_.limits().key_values)
            context_.fail("/animations", "more than " + std::to_string(context_.limits().key_values) +
                                             " values of key frames; the limit is that");
    }

    GltfContext& context_;
    const tinygltf::Model& model_;
    std::uint64_t values_ = 0;
};

}  // namespace

Rig read_rig(GltfContext& context, const tinygltf::Model& model, const std::vector<PlacedNode>& nodes) {
    Rig rig;
    for (const PlacedNode& placed : nodes) rig.nodes.push_back(rig_node(placed, model.nodes[placed.node]));
    const std::vector<int> place = places_of(nodes, model);
    ChannelReader reader(context, model);
    for (const tinygltf::Animation& animation : model.animations) {
        for (const tinygltf::AnimationChannel& channel : animation.channels) {
            // Without a node, or with one that the scene does not show, it moves nothing.
            const int node = channel.target_node < 0 ? -1 : place[std::size_t(channel.target_node)];
            if (node < 0) continue;
            const bool fixed = !model.nodes[std::size_t(channel.target_node)].matrix.empty();
            if (fixed && channel.target_path != "weights") {
                context.count("ignored", channel_noun, ", whose node has a matrix");
                continue;
            }
            if (std::optional<RigChannel> read = reader.read(animation, channel, std::size_t(node)))
                rig.channels.push_back(std::move(*read));
        }
    }
    return rig;
}

}  // namespace kd

#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMaxSkins = 4'096;
constexpr std::size_t kMaxJoints = 4'096;
constexpr std::size_t kMaxAnimations = 1'024;

/// The joints as the model's nodes; empty, with a fault, when one is none of the scene's.
std::vector<std::uint32_t> joints_of(GltfReader& reader,
                                     const Json& source,
                                     const std::string& where) {
    std::vector<std::uint32_t> joints;
    const Json& list = reader.array(source, "joints", where);
    if (list.size() > kMaxJoints) {
        reader.fail("{} has {} joints; at most {} are read", where, list.size(), kMaxJoints);
    }
    for (const Json& entry : list) {
        if (reader.failed()) return {};
        const std::size_t node =
            entry.is_number_unsigned() ? entry.get<std::size_t>() : ~std::size_t{0};
        if (node >= reader.node_places.size()) {
            reader.fail(
                "{}.joints names node {} of {}", where, entry.dump(), reader.node_places.size());
        } else if (!reader.node_places[node]) {
            reader.fail("{}.joints names node {}, which the scene does not hold", where, node);
        } else {
            joints.push_back(*reader.node_places[node]);
        }
    }
    return joints;
}

/// Numbers of an accessor that a sampler or skin names; empty with a fault.
std::vector<float> numbers_of(GltfReader& reader,
                              const Json& source,
                              const char* key,
                              const std::string& where,
                              std::string_view type = {}) {
    const auto number = reader.index(source, key, where, reader.accessors.size());
    if (reader.failed()) return {};
    if (!number) {
        reader.fail("{}.{} is missing", where, key);
        return {};
    }
    const GltfAccessor& accessor = reader.accessors[*number];
    const bool fits = type.empty() || accessor.type == type;
    if (!fits || (accessor.component != 5126 && !accessor.normalized)) {
        reader.fail("{}.{}: {} of component type {} is not read",
                    where,
                    key,
                    accessor.type,
                    accessor.component);
        return {};
    }
    std::vector<float> values = floats_of(reader, accessor);
    if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); })) {
        reader.fail("{}.{} holds numbers that are not finite", where, key);
    }
    return values;
}

/// How many numbers a key of this path has; 0: not known here.
std::size_t width_of(const GltfReader& reader, ChannelPath path, const ModelNode& node) {
    switch (path) {
        case ChannelPath::Translation:
        case ChannelPath::Scale:
            return 3;
        case ChannelPath::Rotation:
            return 4;
        case ChannelPath::MorphWeights:
            return node.meshes.empty() ? 0
                                       : reader.model.meshes[node.meshes.front()].targets.size();
    }
    return 0;
}

std::optional<ChannelPath> path_of(std::string_view text) {
    if (text == "translation") return ChannelPath::Translation;
    if (text == "rotation") return ChannelPath::Rotation;
    if (text == "scale") return ChannelPath::Scale;
    if (text == "weights") return ChannelPath::MorphWeights;
    return std::nullopt;
}

Interpolation interpolation_of(GltfReader& reader, const Json& sampler, const std::string& where) {
    const std::string text = reader.text(sampler, "interpolation", where);
    if (text == "STEP") return Interpolation::Step;
    if (text == "CUBICSPLINE") return Interpolation::CubicSpline;
    if (!text.empty() && text != "LINEAR") {
        reader.fail("{}.interpolation is \"{}\"", where, text);
    }
    return Interpolation::Linear;
}

void check_times(GltfReader& reader, const AnimationChannel& channel, const std::string& where) {
    for (std::size_t i = 0; i < channel.times_s.size(); ++i) {
        const bool rises = i == 0 || channel.times_s[i] > channel.times_s[i - 1];
        if (channel.times_s[i] < 0.0F || !rises) {
            reader.fail(
                "{}.input: times must rise from 0; number {} is {}", where, i, channel.times_s[i]);
            return;
        }
    }
}

/// The keys of a channel; a fault of the file leaves them without use.
void read_keys(GltfReader& reader,
               const Json& sampler,
               const std::string& where,
               AnimationChannel& channel) {
    channel.interpolation = interpolation_of(reader, sampler, where);
    channel.times_s = numbers_of(reader, sampler, "input", where, "SCALAR");
    channel.values = numbers_of(reader, sampler, "output", where);
    if (reader.failed()) return;
    check_times(reader, channel, where);
    const std::size_t width = width_of(reader, channel.path, reader.model.nodes[channel.node]);
    const std::size_t groups = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
    if (channel.values.size() != channel.times_s.size() * groups * width) {
        reader.fail("{} has {} times, and {} numbers where {} belong",
                    where,
                    channel.times_s.size(),
                    channel.values.size(),
                    channel.times_s.size() * groups * width);
    }
}

void read_channel(GltfReader& reader,
                  const Json& source,
                  const Json& samplers,
                  const std::string& where,
                  const std::string& sampler_where,
                  ModelAnimation& animation) {
    if (!source.is_object()) {
        reader.fail("{} is not an object", where);
        return;
    }
    const auto sampler = reader.index(source, "sampler", where, samplers.size());
    const auto found = source.find("target");
    if (found == source.end() || !found->is_object()) {
        reader.fail("{}.target is missing or not an object", where);
        return;
    }
    const Json& target = *found;
    const std::optional<ChannelPath> path = path_of(reader.text(target, "path", where + ".target"));
    const auto node = reader.index(target, "node", where + ".target", reader.node_places.size());
    if (reader.failed()) return;
    // Channels may be there for extensions, or for nodes that the scene does not show.
    if (!sampler || !path || !node || !reader.node_places[*node]) return;
    const std::string place = fmt::format("{}[{}]", sampler_where, *sampler);
    if (!samplers[*sampler].is_object()) {
        reader.fail("{} is not an object", place);
        return;
    }
    AnimationChannel channel{.node = *reader.node_places[*node], .path = *path};
    if (width_of(reader, channel.path, reader.model.nodes[channel.node]) == 0) return;
    read_keys(reader, samplers[*sampler], place, channel);
    if (reader.failed()) return;
    animation.duration_s = std::max(animation.duration_s, channel.times_s.back());
    animation.channels.push_back(std::move(channel));
}

}  // namespace

void read_skins(GltfReader& reader) {
    const Json& list = reader.objects("skins", kMaxSkins);
    for (std::size_t i = 0; i < list.size() && !reader.failed(); ++i) {
        const std::string where = fmt::format("skins[{}]", i);
        ModelSkin skin{.joints = joints_of(reader, list[i], where)};
        if (reader.failed()) return;
        skin.joint_from_mesh.assign(skin.joints.size(), Mat4f{1.0F});
        if (list[i].contains("inverseBindMatrices")) {
            const std::vector<float> numbers =
                numbers_of(reader, list[i], "inverseBindMatrices", where, "MAT4");
            if (!reader.failed() && numbers.size() < skin.joints.size() * 16) {
                reader.fail("{}.inverseBindMatrices has {} matrices for {} joints",
                            where,
                            numbers.size() / 16,
                            skin.joints.size());
            }
            if (reader.failed()) return;
            for (std::size_t k = 0; k < skin.joints.size(); ++k) {
                skin.joint_from_mesh[k] = glm::make_mat4(&numbers[k * 16]);
            }
        }
        reader.model.skins.push_back(std::move(skin));
    }
}

void read_animations(GltfReader& reader) {
    const Json& list = reader.objects("animations", kMaxAnimations);
    std::size_t channel_count = 0;
    for (std::size_t i = 0; i < list.size() && !reader.failed(); ++i) {
        const std::string where = fmt::format("animations[{}]", i);
        ModelAnimation animation{.name = reader.text(list[i], "name", where)};
        if (animation.name.empty()) animation.name = fmt::format("animation {}", i + 1);
        const Json& channels = reader.array(list[i], "channels", where);
        const Json& samplers = reader.array(list[i], "samplers", where);
        channel_count += channels.size();
        if (channel_count > limits::kModelAccessors) {
            reader.fail("its animations have more than {} channels", limits::kModelAccessors);
            return;
        }
        for (std::size_t k = 0; k < channels.size() && !reader.failed(); ++k) {
            read_channel(reader,
                         channels[k],
                         samplers,
                         fmt::format("{}.channels[{}]", where, k),
                         where + ".samplers",
                         animation);
        }
        if (reader.failed()) {
            log_warning("model {}: animation \"{}\" is left out: {}",
                        reader.name,
                        animation.name,
                        std::exchange(reader.fault, {}));
            continue;
        }
        if (!animation.channels.empty()) reader.model.animations.push_back(std::move(animation));
    }
}

}  // namespace plumbline::assets

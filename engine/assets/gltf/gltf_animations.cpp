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

/// The joints as the model's nodes.
std::vector<std::uint32_t> joints_of(const GltfReader& reader, const GltfObject& source) {
    const std::string& where = source.where;
    std::vector<std::uint32_t> joints;
    const Json& list = source.array("joints");
    if (list.size() > kMaxJoints) {
        fail("{} has {} joints; at most {} are read", where, list.size(), kMaxJoints);
    }
    for (const Json& entry : list) {
        const std::size_t node =
            entry.is_number_unsigned() ? entry.get<std::size_t>() : ~std::size_t{0};
        if (node >= reader.node_places.size()) {
            fail("{}.joints names node {} of {}", where, entry.dump(), reader.node_places.size());
        }
        if (!reader.node_places[node]) {
            fail("{}.joints names node {}, which the scene does not hold", where, node);
        }
        joints.push_back(*reader.node_places[node]);
    }
    return joints;
}

/// Numbers of an accessor that a sampler or skin names.
std::vector<float> numbers_of(GltfReader& reader,
                              const GltfObject& source,
                              const char* key,
                              std::string_view type = {}) {
    const std::string& where = source.where;
    const auto number = source.index(key, reader.accessors.size());
    if (!number) fail("{}.{} is missing", where, key);
    const GltfAccessor& accessor = reader.accessors[*number];
    const bool fits = type.empty() || accessor.type == type;
    if (!fits || (accessor.component != 5126 && !accessor.normalized)) {
        fail("{}.{}: {} of component type {} is not read",
             where,
             key,
             accessor.type,
             accessor.component);
    }
    std::vector<float> values = floats_of(reader, accessor);
    if (!std::ranges::all_of(values, [](float value) { return std::isfinite(value); })) {
        fail("{}.{} holds numbers that are not finite", where, key);
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

Interpolation interpolation_of(const GltfObject& sampler) {
    const std::string text = sampler.text("interpolation");
    if (text == "STEP") return Interpolation::Step;
    if (text == "CUBICSPLINE") return Interpolation::CubicSpline;
    if (!text.empty() && text != "LINEAR") {
        fail("{}.interpolation is \"{}\"", sampler.where, text);
    }
    return Interpolation::Linear;
}

void check_times(const std::vector<float>& times_s, const std::string& where) {
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        const bool rises = i == 0 || times_s[i] > times_s[i - 1];
        if (times_s[i] < 0.0F || !rises) {
            fail("{}.input: times must rise from 0; number {} is {}", where, i, times_s[i]);
        }
    }
}

/// The keys of a channel.
void read_keys(GltfReader& reader, const GltfObject& sampler, AnimationChannel& channel) {
    channel.interpolation = interpolation_of(sampler);
    channel.times_s = numbers_of(reader, sampler, "input", "SCALAR");
    channel.values = numbers_of(reader, sampler, "output");
    check_times(channel.times_s, sampler.where);
    const std::size_t width = width_of(reader, channel.path, reader.model.nodes[channel.node]);
    const std::size_t groups = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
    if (channel.values.size() != channel.times_s.size() * groups * width) {
        fail("{} has {} times, and {} numbers where {} belong",
             sampler.where,
             channel.times_s.size(),
             channel.values.size(),
             channel.times_s.size() * groups * width);
    }
}

void read_channel(GltfReader& reader,
                  const GltfObject& source,
                  const Json& samplers,
                  const std::string& samplers_where,
                  ModelAnimation& animation) {
    const auto sampler = source.index("sampler", samplers.size());
    const auto found = source.json.find("target");
    if (found == source.json.end() || !found->is_object()) {
        fail("{}.target is missing or not an object", source.where);
    }
    const GltfObject target{.json = *found, .where = source.where + ".target"};
    const std::optional<ChannelPath> path = path_of(target.text("path"));
    const auto node = target.index("node", reader.node_places.size());
    // Channels may be there for extensions, or for nodes that the scene does not show.
    if (!sampler || !path || !node || !reader.node_places[*node]) return;
    const GltfObject keys = object_at(samplers, *sampler, samplers_where);
    AnimationChannel channel{.node = *reader.node_places[*node], .path = *path};
    if (width_of(reader, channel.path, reader.model.nodes[channel.node]) == 0) return;
    read_keys(reader, keys, channel);
    animation.duration_s = std::max(animation.duration_s, channel.times_s.back());
    animation.channels.push_back(std::move(channel));
}

void read_animation(GltfReader& reader, const GltfObject& source, ModelAnimation& animation) {
    if (std::string name = source.text("name"); !name.empty()) animation.name = std::move(name);
    const Json& channels = source.array("channels");
    const Json& samplers = source.array("samplers");
    for (std::size_t k = 0; k < channels.size(); ++k) {
        read_channel(reader,
                     object_at(channels, k, source.where + ".channels"),
                     samplers,
                     source.where + ".samplers",
                     animation);
    }
}

}  // namespace

void read_skins(GltfReader& reader) {
    for (const GltfObject& source : reader.objects("skins", kMaxSkins)) {
        ModelSkin skin{.joints = joints_of(reader, source)};
        const std::size_t count = skin.joints.size();
        skin.joint_from_mesh.assign(count, Mat4f{1.0F});
        if (source.json.contains("inverseBindMatrices")) {
            const std::vector<float> numbers =
                numbers_of(reader, source, "inverseBindMatrices", "MAT4");
            if (numbers.size() < count * 16) {
                fail("{}.inverseBindMatrices has {} matrices for {} joints",
                     source.where,
                     numbers.size() / 16,
                     count);
            }
            for (std::size_t k = 0; k < count; ++k) {
                skin.joint_from_mesh[k] = glm::make_mat4(&numbers[k * 16]);
            }
        }
        reader.model.skins.push_back(std::move(skin));
    }
}

void read_animations(GltfReader& reader) {
    const std::vector<GltfObject> list = reader.objects("animations", kMaxAnimations);
    std::size_t channel_count = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto channels = list[i].json.find("channels");
        if (channels != list[i].json.end() && channels->is_array())
            channel_count += channels->size();
        if (channel_count > limits::kModelAccessors) {
            fail("its animations have more than {} channels", limits::kModelAccessors);
        }
        ModelAnimation animation{.name = fmt::format("animation {}", i + 1)};
        try {
            read_animation(reader, list[i], animation);
        } catch (const ModelFault& fault) {
            log_warning("model {}: animation \"{}\" is left out: {}",
                        reader.name,
                        animation.name,
                        fault.words);
            continue;
        }
        if (!animation.channels.empty()) reader.model.animations.push_back(std::move(animation));
    }
}

}  // namespace plumbline::assets

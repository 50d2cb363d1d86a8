#include "engine/assets/model/model_pose.h"

#include <algorithm>
#include <cmath>

namespace plumbline::assets {

Mat4f matrix_of(const NodeTransform& place) {
    Mat4f matrix = glm::mat4_cast(place.rotation);
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= place.scale[axis];
    matrix[3] = Vec4f{place.translation, 1.0F};
    return matrix;
}

namespace {

std::size_t numbers_per_key(const AnimationChannel& channel) {
    const std::size_t groups = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
    return channel.values.size() / channel.times_s.size() / groups;
}

/// The two keys around an instant.
struct KeySpan {
    std::size_t before{0};
    std::size_t after{0};
    float share{0.0F};  ///< of the way between them
    float length_s{0.0F};
};

KeySpan span_at(const std::vector<float>& times_s, float time_s) {
    if (time_s <= times_s.front()) return {};
    const auto next = std::upper_bound(times_s.begin(), times_s.end(), time_s);
    const auto after = static_cast<std::size_t>(next - times_s.begin());
    if (after == times_s.size()) return {.before = after - 1, .after = after - 1};
    const float length_s = times_s[after] - times_s[after - 1];
    return {.before = after - 1,
            .after = after,
            .share = (time_s - times_s[after - 1]) / length_s,
            .length_s = length_s};
}

float cubic(const AnimationChannel& channel,
            const KeySpan& span,
            std::size_t width,
            std::size_t i) {
    const auto value = [&](std::size_t key, std::size_t group) {
        return channel.values[(key * 3 + group) * width + i];
    };
    const float t = span.share;
    const float t2 = t * t;
    const float t3 = t2 * t;
    return value(span.before, 1) * (2 * t3 - 3 * t2 + 1) +
           value(span.before, 2) * span.length_s * (t3 - 2 * t2 + t) +
           value(span.after, 1) * (3 * t2 - 2 * t3) +
           value(span.after, 0) * span.length_s * (t3 - t2);
}

/// The channel's numbers at an instant; rotations are turned the short way round, and unit.
std::vector<float> sampled(const AnimationChannel& channel, float time_s) {
    const std::size_t width = numbers_per_key(channel);
    const KeySpan span = span_at(channel.times_s, time_s);
    const auto plain = [&](std::size_t key, std::size_t i) {
        const bool spline = channel.interpolation == Interpolation::CubicSpline;
        return channel.values[(spline ? key * 3 + 1 : key) * width + i];
    };
    std::vector<float> values(width);
    const bool blends = span.after != span.before;
    const bool turns = channel.path == ChannelPath::Rotation;
    if (turns && blends && channel.interpolation == Interpolation::Linear) {
        const auto turn = [&](std::size_t key) {
            return Quatf{plain(key, 3), plain(key, 0), plain(key, 1), plain(key, 2)};
        };
        const Quatf at = portable_slerp(turn(span.before), turn(span.after), span.share);
        return {at.x, at.y, at.z, at.w};
    }
    for (std::size_t i = 0; i < width; ++i) {
        if (!blends || channel.interpolation == Interpolation::Step) {
            values[i] = plain(span.before, i);
        } else if (channel.interpolation == Interpolation::CubicSpline) {
            values[i] = cubic(channel, span, width, i);
        } else {
            values[i] =
                plain(span.before, i) * (1 - span.share) + plain(span.after, i) * span.share;
        }
    }
    return values;
}

void apply(const AnimationChannel& channel,
           float time_s,
           NodeTransform& place,
           std::vector<float>& morph_weights) {
    std::vector<float> values = sampled(channel, time_s);
    switch (channel.path) {
        case ChannelPath::Translation:
            place.translation = {values[0], values[1], values[2]};
            return;
        case ChannelPath::Scale:
            place.scale = {values[0], values[1], values[2]};
            return;
        case ChannelPath::Rotation: {
            const Quatf turn{values[3], values[0], values[1], values[2]};
            if (glm::length(turn) > 1e-6F) place.rotation = glm::normalize(turn);
            return;
        }
        case ChannelPath::MorphWeights:
            morph_weights = std::move(values);
            return;
    }
}

ModelPose pose_of(const ModelData& model, const ModelAnimation* animation, float time_s) {
    const std::size_t count = model.nodes.size();
    ModelPose pose{.model_from_node = std::vector<Mat4f>(count),
                   .morph_weights = std::vector<std::vector<float>>(count)};
    std::vector<NodeTransform> places(count);
    std::vector<bool> moved(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        places[i] = model.nodes[i].rest;
        pose.morph_weights[i] = model.nodes[i].morph_weights;
    }
    if (animation != nullptr) {
        const float at_s = std::clamp(time_s, 0.0F, animation->duration_s);
        for (const AnimationChannel& channel : animation->channels) {
            apply(channel, at_s, places[channel.node], pose.morph_weights[channel.node]);
            if (channel.path != ChannelPath::MorphWeights) moved[channel.node] = true;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const ModelNode& node = model.nodes[i];
        const Mat4f local = moved[i] ? matrix_of(places[i]) : node.parent_from_node;
        pose.model_from_node[i] = node.parent ? pose.model_from_node[*node.parent] * local : local;
    }
    return pose;
}

}  // namespace

ModelPose rest_pose(const ModelData& model) {
    return pose_of(model, nullptr, 0.0F);
}

ModelPose pose_at(const ModelData& model, const ModelAnimation& animation, float time_s) {
    return pose_of(model, &animation, time_s);
}

ModelParts parts_of(const ModelData& model) {
    std::vector<bool> moves(model.nodes.size(), false);
    std::vector<bool> morphs(model.nodes.size(), false);
    for (const ModelAnimation& animation : model.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            auto& list = channel.path == ChannelPath::MorphWeights ? morphs : moves;
            list[channel.node] = true;
        }
    }
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const std::optional<std::uint32_t> parent = model.nodes[i].parent;
        if (parent && moves[*parent]) moves[i] = true;
    }
    ModelParts parts;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const ModelNode& node = model.nodes[i];
        bool bends = false;
        if (node.skin) {
            for (const std::uint32_t joint : model.skins[*node.skin].joints) {
                bends = bends || moves[joint];
            }
        }
        for (const std::uint32_t mesh : node.meshes) {
            const bool deforms = (bends && !model.meshes[mesh].influences.empty()) ||
                                 (morphs[i] && !model.meshes[mesh].targets.empty());
            // What bones carry does not follow its own node.
            const bool carried = node.skin && !model.meshes[mesh].influences.empty();
            const ModelPart part{
                .node = static_cast<std::uint32_t>(i), .mesh = mesh, .deforms = deforms};
            (deforms || (moves[i] && !carried) ? parts.moving : parts.still).push_back(part);
        }
    }
    return parts;
}

}  // namespace plumbline::assets

#include "engine/scene/build/model_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace plumbline::scene {
namespace {

constexpr Real kThinnest_m = 0.01_r;  // flat things are this thick

Mat3 stretched(const Mat4f& model_from_node, const Vec3& scale) {
    Mat3 axes(model_from_node);
    for (int i = 0; i < 3; ++i) axes[i] *= scale;
    return axes;
}

/// The rotation that the axes have once stretch and shear are taken out.
Mat3 turn_of(const Mat3& axes) {
    const Vec3 x = normalize_or(axes[0], Vec3{1, 0, 0});
    const Vec3 any = std::abs(x.y) < 0.9_r ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 y = normalize_or(axes[1] - x * glm::dot(axes[1], x),
                                glm::normalize(any - x * glm::dot(any, x)));
    return {x, y, glm::cross(x, y)};
}

/// Points by node, each in its node's frame.
struct NodePoints {
    std::vector<Vec3> points;
    bool as_box{false};  ///< of a bone
};

void add_bones(const assets::ModelData& model,
               const assets::ModelMesh& mesh,
               const assets::ModelSkin& skin,
               std::map<std::uint32_t, NodePoints>& nodes) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const assets::JointInfluence& pull = mesh.influences[i];
        const auto strongest = std::ranges::max_element(pull.weights) - pull.weights.begin();
        const std::uint16_t joint = pull.joints[static_cast<std::size_t>(strongest)];
        if (joint >= skin.joints.size() || skin.joints[joint] >= model.nodes.size()) continue;
        const Vec4f at = skin.joint_from_mesh[joint] * Vec4f(mesh.vertices[i].position_body, 1.0F);
        NodePoints& node = nodes[skin.joints[joint]];
        node.points.emplace_back(at.x, at.y, at.z);
        node.as_box = true;
    }
}

struct Extent {
    Vec3 low;
    Vec3 high;
    bool is_flat() const { return glm::any(glm::lessThan(high - low, Vec3{kThinnest_m})); }
};

Extent extent_of(const std::vector<Vec3>& points) {
    Extent extent{points.front(), points.front()};
    for (const Vec3& point : points) {
        extent.low = glm::min(extent.low, point);
        extent.high = glm::max(extent.high, point);
    }
    return extent;
}

/// The corners of its box, which is nowhere thinner than kThinnest_m.
std::vector<Vec3> corners_of(const Extent& extent) {
    const Vec3 missing = glm::max(Vec3{kThinnest_m} - (extent.high - extent.low), Vec3{0}) * 0.5_r;
    const Vec3 low = extent.low - missing;
    const Vec3 high = extent.high + missing;
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) != 0 ? high.x : low.x,
                             (i & 2) != 0 ? high.y : low.y,
                             (i & 4) != 0 ? high.z : low.z);
    return corners;
}

}  // namespace

std::vector<PartShape> part_shapes_of(const assets::MovingModel& model, const Vec3& scale) {
    std::map<std::uint32_t, NodePoints> nodes;
    for (const assets::ModelPart& part : model.parts) {
        const assets::ModelMesh& mesh = model.data.meshes[part.mesh];
        const auto& skin = model.data.nodes[part.node].skin;
        if (skin && !mesh.influences.empty()) {
            add_bones(model.data, mesh, model.data.skins[*skin], nodes);
            continue;
        }
        for (const assets::Vertex& vertex : mesh.vertices)
            nodes[part.node].points.emplace_back(vertex.position_body);
    }
    const assets::ModelPose rest = assets::rest_pose(model.data);
    std::vector<PartShape> shapes;
    for (const auto& [node, found] : nodes) {
        const Mat3 axes = stretched(rest.model_from_node[node], scale);
        const Mat3 part_from_node = glm::transpose(turn_of(axes)) * axes;
        std::vector<Vec3> points;
        for (const Vec3& point : found.points) points.push_back(part_from_node * point);
        const Extent extent = extent_of(points);
        if (found.as_box || extent.is_flat()) points = corners_of(extent);
        std::string name = model.data.nodes[node].name;
        if (name.empty() || std::ranges::find(shapes, name, &PartShape::name) != shapes.end())
            name += fmt::format("{}", node);
        shapes.push_back(
            {.node = node, .name = std::move(name), .hull = {.points_m = std::move(points)}});
    }
    return shapes;
}

Pose part_pose(const Mat4f& model_from_node, const Vec3& scale, const Pose& world_from_body) {
    const Vec3f place(model_from_node[3]);
    const Quat turn = glm::quat_cast(turn_of(stretched(model_from_node, scale)));
    return compose(world_from_body, {.position = Vec3(place) * scale, .orientation = turn});
}

}  // namespace plumbline::scene

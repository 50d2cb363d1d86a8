// What PLY and STL have in common: one mesh, and z up. Private to engine/assets.
#pragma once

#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/math.h"

#include <utility>

namespace plumbline::assets {

/// A model of one node, turned so that the file's +Z becomes our +Y.
inline ModelData model_with_z_up(ModelMesh mesh, bool has_colors) {
    ModelNode node{.name = mesh.name, .meshes = {0}};
    node.rest.rotation = portable_angle_axis(radians_from_degrees(-90.0F), Vec3f{1, 0, 0});
    // Exact, where the quaternion would round.
    node.parent_from_node = Mat4f{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}};
    ModelData model;
    model.nodes.push_back(std::move(node));
    model.materials.push_back({.name = "default", .vertex_colors = has_colors});
    model.meshes.push_back(std::move(mesh));
    return model;
}

}  // namespace plumbline::assets

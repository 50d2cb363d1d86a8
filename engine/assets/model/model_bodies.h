// Where the bodies of a model with physics are, and what is seen of each.
#pragma once

#include "engine/assets/model_data.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::assets {

/// Where a node stands at rest: model_from_node is a turn and a shift after the stretch.
struct NodePlace {
    Vec3d position_m{0, 0, 0};
    Quatd turn{1, 0, 0, 0};   ///< unit
    glm::dmat3 stretch{1.0};  ///< identity, exactly, where nothing is scaled
};

/// By node.
std::vector<NodePlace> node_places(const ModelData& model);

/// By node: which of ModelPhysics::motions moves it; as many as there are motions where none does.
std::vector<std::size_t> bodies_of_nodes(const ModelData& model);

/// What each motion moves, in the frame of its place; last what none moves, in the model's. Empty where nothing is
/// seen. `name`: as in merged_mesh.
std::vector<MeshData> body_meshes(const ModelData& model, const std::string& name);

}  // namespace plumbline::assets

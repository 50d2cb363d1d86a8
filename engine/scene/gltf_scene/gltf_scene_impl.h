// What the readers of glTF files with physics share. Internal to the scene module.
#pragma once

#include "engine/assets/model/model_bodies.h"
#include "engine/assets/model_data.h"
#include "engine/scene/formats/scene_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {

/// A model with physics on its way to a scene.
struct GltfScene {
    const assets::ModelData& model;
    const SourceLocation& location;
    FaultList& faults;
    SceneDescription& scene;
    std::vector<assets::NodePlace> places{};  ///< by node
    std::vector<std::size_t> bodies{};        ///< by node, see bodies_of_nodes
    std::vector<std::string>
        entities{};  ///< by node: the entity whose body or collider it is; empty: none

    bool moves(std::uint32_t node) const { return bodies[node] < model.physics.motions.size(); }
    /// What messages call a node.
    std::string called(std::uint32_t node) const;
    template <class... Parts>
    void warn(std::uint32_t node, fmt::format_string<Parts...> message, Parts&&... parts) const {
        faults.warning(location, called(node), message, std::forward<Parts>(parts)...);
    }
};

inline Pose pose_of(const assets::NodePlace& place) {
    return {.position = Vec3(place.position_m), .orientation = Quat(place.turn)};
}

// --- gltf_shapes.cpp
/// A collider in the frame of `body`, a place without its stretch. `solid`: of a body that moves, so that a mesh becomes
/// its hull.
physics::CompoundChild shape_of_collider(const GltfScene& gltf,
                                         const assets::ModelCollider& collider,
                                         const assets::NodePlace& body,
                                         bool solid);

// --- gltf_bodies.cpp
/// Entities of motions, of colliders that stand, of triggers and of what is only seen.
void add_gltf_bodies(GltfScene& gltf, const VisualDescription& visual);

// --- gltf_joints.cpp
void add_gltf_joints(GltfScene& gltf);

// --- gltf_extras.cpp
/// JSON that our exporter wrote, as the tables of a scene file; a fault is an error at the location.
std::optional<TomlNode> table_of_extras(const std::string& json,
                                        const SourceLocation& location,
                                        FaultList& faults);

}  // namespace plumbline::scene

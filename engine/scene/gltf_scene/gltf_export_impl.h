// The parts of the glTF exporter. Internal to the scene module.
#pragma once

#include "engine/physics/world_copy.h"
#include "engine/scene/gltf_scene/gltf_writer_impl.h"
#include "engine/scene/simulation.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace plumbline::scene {

inline nlohmann::json gltf_numbers(const Vec3& v) {
    return {v.x, v.y, v.z};
}
inline nlohmann::json gltf_numbers(const Quat& q) {
    return {q.x, q.y, q.z, q.w};
}
/// Nothing for what glTF takes as given.
inline void put_pose(nlohmann::json& node, const Pose& parent_from_node) {
    if (parent_from_node.position != Vec3{0, 0, 0})
        node["translation"] = gltf_numbers(parent_from_node.position);
    if (parent_from_node.orientation != Quat{1, 0, 0, 0})
        node["rotation"] = gltf_numbers(parent_from_node.orientation);
}

inline constexpr const char* kGltfBodies = "KHR_physics_rigid_bodies";
inline constexpr const char* kGltfShapes = "KHR_implicit_shapes";

struct GltfOutput {
    Simulation& simulation;
    GltfWriter writer;
    std::vector<std::string> notes{};
    std::map<physics::BodyId, std::size_t> nodes{};  ///< of bodies

    nlohmann::json& node(std::size_t number) { return writer.json["nodes"][number]; }
    nlohmann::json& physics() { return writer.json["extensions"][kGltfBodies]; }
    void add_child(std::size_t parent, nlohmann::json child) {
        const std::size_t number = writer.add_node(std::move(child));
        node(parent)["children"].push_back(number);
    }
    void note(std::string text);  ///< each once
};

// --- gltf_export_bodies.cpp
/// Motion and colliders of the body that an entity's node stands for.
void write_body(GltfOutput& out, const physics::BodyCopy& body, std::size_t node);
/// The geometry of a collider or a trigger.
nlohmann::json geometry_of(GltfOutput& out, const physics::ShapeDef& shape);

// --- gltf_export_joints.cpp
void write_joints(GltfOutput& out);

}  // namespace plumbline::scene

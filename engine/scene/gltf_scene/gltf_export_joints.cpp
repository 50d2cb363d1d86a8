// Joints as sums of limits.
#include "engine/assets/model_physics.h"
#include "engine/scene/gltf_scene/gltf_export_impl.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::scene {
namespace {

using Json = nlohmann::json;
using physics::JointDef;

Json limit(const char* axes, Json numbers, Real min, Real max) {
    return {{axes, std::move(numbers)}, {"min", min}, {"max", max}};
}
Json locked(const char* axes, Json numbers) {
    return limit(axes, std::move(numbers), Real{0}, Real{0});
}

/// The turn that takes +X to a direction.
Quat turn_to(const Vec3& axis) {
    const Vec3 x = glm::normalize(axis);
    const Vec3 any = std::abs(x.y) < 0.9_r ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 z = glm::normalize(glm::cross(x, any));
    return glm::normalize(glm::quat_cast(Mat3{x, glm::cross(z, x), z}));
}

Json distance_limit(const JointDef& def) {
    const Real rest_m =
        def.rest_length_m.value_or(glm::distance(def.anchor_a_world, def.anchor_b_world));
    Json all = limit("linearAxes",
                     {0, 1, 2},
                     def.limits ? (*def.limits)[0] : rest_m,
                     def.limits ? (*def.limits)[1] : rest_m);
    if (def.kind != JointKind::Spring) return all;
    all["min"] = all["max"] = rest_m;
    all["stiffness"] = def.stiffness_Npm;
    all["damping"] = def.damping_Nspm;
    return all;
}

/// The axis is +X of the frames. Of the connected node, which hangs on `a`, against the joint's.
Json description_of(const JointDef& def) {
    Json limits = Json::array();
    Json drives = Json::array();
    const auto drive = [&](const char* type) {
        if (!def.motor) return;
        const physics::JointMotor& motor = *def.motor;
        const bool gives_way = motor.stiffness > 0 || motor.damping > 0;
        drives.push_back(
            {{"type", type},
             {"mode", motor.by_mass ? "acceleration" : "force"},
             {"axis", 0},
             {"maxForce", motor.max},
             {"velocityTarget", motor.target},
             {"damping", gives_way ? static_cast<double>(motor.damping) : assets::kHardDrive}});
        if (motor.stiffness > 0) {
            drives.back()["stiffness"] = motor.stiffness;
            drives.back()["positionTarget"] = motor.position;
        }
    };
    const auto range = [&](const char* axes, const std::array<Real, 2>& bounds) {
        limits.push_back(limit(axes, {0}, bounds[0], bounds[1]));
    };
    if (def.kind == JointKind::Distance || def.kind == JointKind::Spring) {
        limits.push_back(distance_limit(def));
    } else if (def.kind == JointKind::Slider) {
        limits.push_back(locked("linearAxes", {1, 2}));
        limits.push_back(locked("angularAxes", {0, 1, 2}));
        if (def.limits) range("linearAxes", *def.limits);
        drive("linear");
    } else {
        limits.push_back(locked("linearAxes", {0, 1, 2}));
    }
    if (def.kind == JointKind::Fixed) limits.push_back(locked("angularAxes", {0, 1, 2}));
    if (def.kind == JointKind::Hinge) {
        limits.push_back(locked("angularAxes", {1, 2}));
        if (def.limits) range("angularAxes", *def.limits);
        drive("angular");
    }
    if (def.kind == JointKind::Cone) {
        const Real widest =
            def.limits ? std::max(std::abs((*def.limits)[0]), std::abs((*def.limits)[1])) : Real{0};
        if (def.limits) limits.push_back(limit("angularAxes", {1, 2}, Real{0}, widest));
        if (def.twist_limits) range("angularAxes", *def.twist_limits);
    }
    Json description{{"limits", std::move(limits)}};
    if (!drives.empty()) description["drives"] = std::move(drives);
    return description;
}

/// For our reader alone.
Json traits_of(const JointDef& def, const SceneJoint& joint) {
    Json traits = Json::object();
    if (def.break_N > 0) traits["break_N"] = def.break_N;
    if (joint.bar_m > 0) traits["bar_m"] = joint.bar_m;
    if (joint.creak > 0) traits["creak"] = joint.creak;
    return traits;
}

}  // namespace

void write_joints(GltfOutput& out) {
    const physics::PhysicsWorld& world = out.simulation.physics;
    for (const SceneJoint& joint : out.simulation.joints()) {
        if (!world.contains(joint.joint) || !out.nodes.contains(joint.a)) continue;
        const physics::JointView view = world.joint(joint.joint);
        if (view.state.broken) continue;
        const JointDef& def = view.def;
        const Quat world_from_frame = turn_to(def.axis_world);
        Json& joints = out.physics()["physicsJoints"];
        joints.push_back(description_of(def));
        const std::size_t number = joints.size() - 1;
        Json connected{{"name", joint.name + " a"}};
        put_pose(connected,
                 {joint.anchor_a_body,
                  glm::normalize(glm::conjugate(joint.world_from_a) * world_from_frame)});
        out.add_child(out.nodes.at(joint.a), std::move(connected));
        const std::size_t end = out.writer.json["nodes"].size() - 1;
        Json own{{"name", joint.name},
                 {"extensions",
                  {{kGltfBodies,
                    {{"joint",
                      {{"connectedNode", end},
                       {"joint", number},
                       {"enableCollision", def.collide}}}}}}}};
        if (Json traits = traits_of(def, joint); !traits.empty())
            own["extras"]["plumbline"]["joint"] = std::move(traits);
        put_pose(own,
                 {joint.anchor_b_body,
                  glm::normalize(glm::conjugate(joint.world_from_b) * world_from_frame)});
        const auto b = out.nodes.find(def.b);
        if (b == out.nodes.end()) {
            out.writer.add_node(std::move(own));
        } else {
            out.add_child(b->second, std::move(own));
        }
    }
}

}  // namespace plumbline::scene

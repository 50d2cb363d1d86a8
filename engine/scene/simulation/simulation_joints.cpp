// The joints of a running scene: made from their descriptions, reported when they break.
#include "engine/scene/simulation.h"

#include <fmt/format.h>

namespace plumbline::scene {

Result<physics::BodyId> Simulation::end_of_joint(const std::string& name) const {
    const ecs::Entity entity = find(name);
    const BodyRef* ref = entity ? registry.find<BodyRef>(entity) : nullptr;
    if (ref != nullptr) return ref->body;
    return Error{fmt::format("\"{}\" has no body to hold on to", name), ExitCode::Refused};
}

Result<physics::BodyId> Simulation::holder_of(const std::string& name,
                                              const std::string& held,
                                              const SourceLocation& location) const {
    if (name.empty()) return physics::BodyId{};
    Result<physics::BodyId> holder = end_of_joint(name);
    if (holder) return holder;
    return Error{fmt::format("{}: {}: {}", to_string(location), held, holder.error().message),
                 ExitCode::Refused};
}

namespace {

/// No body: the world.
Quat turn_of(const physics::PhysicsWorld& physics, physics::BodyId body) {
    if (!physics.contains(body)) return {1, 0, 0, 0};
    return physics.state(body).world_from_body.orientation;
}

}  // namespace

Result<Done> Simulation::add_joint(const JointDescription& description) {
    const auto refuse = [&description](const std::string& why) {
        return Error{
            fmt::format("{}: joint {}: {}", to_string(description.location), description.name, why),
            ExitCode::Refused};
    };
    const Result<physics::BodyId> a = end_of_joint(description.a);
    if (!a) return refuse(a.error().message);
    Result<physics::BodyId> b = physics::BodyId{};
    if (description.b != "world") b = end_of_joint(description.b);
    if (!b) return refuse(b.error().message);

    const Result<physics::JointId> made =
        physics.create_joint({.kind = description.kind,
                              .a = *a,
                              .b = *b,
                              .anchor_a_world = description.anchor_a_m,
                              .anchor_b_world = description.anchor_b_m,
                              .axis_world = description.axis,
                              .limits = description.limits,
                              .twist_limits = description.twist,
                              .motor = description.motor,
                              .stiffness_Npm = description.stiffness_Npm,
                              .damping_Nspm = description.damping_Nspm,
                              .rest_length_m = description.rest_length_m,
                              .collide = description.collide,
                              .break_N = description.break_N,
                              .user = bodies_.joints.size()});
    if (!made) return refuse(made.error().message);
    bodies_.joints.push_back({.name = description.name,
                              .joint = *made,
                              .a = *a,
                              .anchor_a_body = anchor_in(*a, description.anchor_a_m),
                              .anchor_b_body = anchor_in(*b, description.anchor_b_m),
                              .world_from_a = turn_of(physics, *a),
                              .world_from_b = turn_of(physics, *b),
                              .creak = description.creak,
                              .bar_m = description.bar_m,
                              .location = description.location});
    return Done{};
}

/// What the game joins carries marks of its own.
std::string Simulation::name_of_joint(physics::JointId joint) const {
    const std::uint64_t mark = physics.joint(joint).def.user;
    if (mark < bodies_.joints.size() && bodies_.joints[mark].joint == joint)
        return "joint " + bodies_.joints[mark].name;
    for (std::size_t i = 0; i < bodies_.ropes.size(); ++i) {
        if (mark == mark_of_rope(i)) return "rope " + bodies_.ropes[i].name;
    }
    for (const Vehicle& vehicle : bodies_.vehicles) {
        if (mark == mark_of_vehicle(static_cast<std::size_t>(&vehicle - bodies_.vehicles.data())))
            return "vehicle " + vehicle.name;
    }
    return "joint of the game";
}

void Simulation::report_broken_joints() {
    for (const physics::JointId joint : physics.report().broken_joints) {
        const physics::JointDef& def = physics.joint(joint).def;
        warnings.push_back(fmt::format("{} broke at {:.3f} s: {:.0f} N > {:.0f} N",
                                       name_of_joint(joint),
                                       time_s(),
                                       physics.joint(joint).state.force_N,
                                       def.break_N));
    }
}

}  // namespace plumbline::scene

#include "engine/study/gallery/case_events.h"

#include "engine/physics/totals.h"

#include <cmath>
#include <limits>

namespace plumbline::study {
namespace {

using scene::CaseEventKind;
using scene::HardCaseEvent;

void do_to_body(scene::Simulation& simulation, ecs::Entity entity, const HardCaseEvent& event) {
    physics::PhysicsWorld& physics = simulation.physics;
    const physics::BodyId body = simulation.registry.get<scene::BodyRef>(entity).body;
    const Pose pose = physics.state(body).world_from_body;
    switch (event.kind) {
        case CaseEventKind::Teleport:
            physics.set_pose(body, {event.value, pose.orientation});
            break;
        case CaseEventKind::Velocity:
            physics.set_velocity(body, event.value, event.angular_velocity_radps);
            break;
        case CaseEventKind::Force:
            physics.apply_force(body, event.value, pose.position + event.point_m);
            break;
        case CaseEventKind::Impulse:
            physics.apply_impulse(body, event.value, pose.position + event.point_m);
            break;
        case CaseEventKind::Remove:
            simulation.registry.destroy(entity);
            break;
        case CaseEventKind::NotFinite:
            physics.set_velocity(body, Vec3{std::numeric_limits<Real>::quiet_NaN(), 0, 0}, {});
            break;
        case CaseEventKind::Gravity:
        case CaseEventKind::MotorOff:
            break;
    }
}

void do_event(scene::Simulation& simulation, const HardCaseEvent& event) {
    if (event.kind == CaseEventKind::Gravity) {
        physics::WorldDef def = simulation.physics.def();
        def.gravity_mps2 = event.value;
        simulation.set_accuracy(def);
        return;
    }
    if (event.kind == CaseEventKind::MotorOff) {
        for (const scene::SceneJoint& joint : simulation.joints()) {
            if (joint.name == event.of && simulation.physics.contains(joint.joint))
                simulation.physics.set_joint_motor(joint.joint, std::nullopt);
        }
        return;
    }
    const ecs::Entity entity = simulation.find(event.of);
    const auto* ref = simulation.registry.alive(entity)
                          ? simulation.registry.find<scene::BodyRef>(entity)
                          : nullptr;
    if (ref != nullptr && simulation.physics.contains(ref->body))
        do_to_body(simulation, entity, event);
}

void do_what_is_due(scene::Simulation& simulation) {
    for (const HardCaseEvent& event : simulation.description().hard_case->events) {
        const std::uint64_t now = simulation.steps();
        const std::uint64_t first = simulation.step_at(event.at_s);
        if (now < first) break;  // they are in order of time
        // step_at() puts what lies before the last change of rate or time there.
        const bool is_past = event.at_s < simulation.time_s() - simulation.step_s() / 2;
        const bool begins = now == first && !is_past;
        const bool lasts = event.kind == CaseEventKind::Force &&
                           now < simulation.step_at(event.at_s + event.duration_s);
        if (!begins && !lasts) continue;
        const double before_J = physics::energy(simulation.physics).total_J();
        do_event(simulation, event);
        const double added_J = physics::energy(simulation.physics).total_J() - before_J;
        if (std::isfinite(added_J)) simulation.added_energy_J += added_J;
    }
}

}  // namespace

void play_case_events(scene::Simulation& simulation) {
    const std::optional<scene::HardCase>& hard = simulation.description().hard_case;
    if (hard && !hard->events.empty()) simulation.before_step = do_what_is_due;
}

}  // namespace plumbline::study

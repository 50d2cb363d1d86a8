// What [[hard_case.event]] does to a scene while it runs.
#include "engine/scene/simulation.h"

#include <cmath>
#include <limits>

namespace plumbline::scene {

void Simulation::run_events() {
    if (!description_.hard_case) return;
    for (const HardCaseEvent& event : description_.hard_case->events) {
        const std::uint64_t first = step_at(event.at_s);
        if (steps_ < first) break;  // they are in order of time
        const bool lasts = event.kind == CaseEventKind::Force &&
                           steps_ < std::max(first + 1, step_at(event.at_s + event.for_s));
        if (steps_ > first && !lasts) continue;
        const auto energy_J = [this] {
            const physics::Energy energy = physics.energy();
            return energy.kinetic_J + energy.potential_J;
        };
        const double before_J = energy_J();
        do_event(event);
        const double added_J = energy_J() - before_J;
        if (std::isfinite(added_J)) event_energy_J_ += added_J;
    }
}

void Simulation::do_event(const HardCaseEvent& event) {
    if (event.kind == CaseEventKind::Gravity) {
        physics::WorldDef def = physics.def();
        def.gravity_mps2 = event.value;
        set_accuracy(def);
        return;
    }
    if (event.kind == CaseEventKind::MotorOff) {
        for (const SceneJoint& joint : joints_) {
            if (joint.name == event.of && physics.contains(joint.joint))
                physics.set_joint_motor(joint.joint, std::nullopt);
        }
        return;
    }
    const ecs::Entity entity = find(event.of);
    const BodyRef* ref = registry.alive(entity) ? registry.find<BodyRef>(entity) : nullptr;
    if (ref == nullptr || !physics.contains(ref->body)) return;
    const physics::BodyId body = ref->body;
    const Pose pose = physics.state(body).world_from_body;
    switch (event.kind) {
        case CaseEventKind::Teleport:
            physics.set_pose(body, {event.value, pose.orientation});
            break;
        case CaseEventKind::Velocity:
            physics.set_velocity(body, event.value, event.spin_radps);
            break;
        case CaseEventKind::Force:
            physics.apply_force_at(body, event.value, pose.position + event.point_m);
            break;
        case CaseEventKind::Impulse:
            physics.apply_impulse_at(body, event.value, pose.position + event.point_m);
            break;
        case CaseEventKind::Remove:
            registry.destroy(entity);
            forget_destroyed();
            break;
        case CaseEventKind::NotFinite:
            physics.set_velocity(body, Vec3{std::numeric_limits<Real>::quiet_NaN(), 0, 0}, {});
            break;
        case CaseEventKind::Gravity:
        case CaseEventKind::MotorOff:
            break;
    }
}

}  // namespace plumbline::scene

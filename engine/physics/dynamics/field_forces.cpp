#include "engine/physics/dynamics/field_forces.h"

#include "engine/physics/dynamics/rotation.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// The change of spin by an angular impulse about the centre of mass.
Vec3d spun_up_by(const BodyInField& body, const Vec3d& angular_impulse_Nms) {
    return body.world_from_mass *
           ((glm::conjugate(body.world_from_mass) * angular_impulse_Nms) / body.inertia_kgm2);
}

BodyInField in_the_middle(const SolverBody& body, BodyId id, double h) {
    const Quatd now = Quatd(body.delta_rotation) * body.start_orientation;
    const Vec3d v(body.velocity_mps);
    const Vec3d spin(body.spin_radps);
    return {.id = id,
            .center_m = body.start_position_m + Vec3d(body.delta_position_m) + v * (h / 2),
            .world_from_mass = glm::normalize(turn_by(spin, h / 2) * now),
            .velocity_mps = v + 0.5 * Vec3d(body.velocity_increment_mps),
            .gain_mps = Vec3d(body.velocity_increment_mps),
            .spin_radps = spin + 0.5 * Vec3d(body.spin_increment_radps),
            .mass_kg = body.mass_kg(),
            .inertia_kgm2 = body.inertia_kgm2};
}

}  // namespace

std::uint32_t field_mask(std::span<ForceField* const> fields, BodyId id) {
    std::uint32_t mask = 0;
    const std::size_t count = std::min(fields.size(), kMostFields);
    for (std::size_t i = 0; i < count; ++i) mask |= (fields[i]->acts_on(id) ? 1U : 0U) << i;
    return mask;
}

void act_on_all(std::span<ForceField* const> fields,
                std::span<BodyInField* const> bodies,
                std::span<const std::uint32_t> masks,
                const FieldTime& time) {
    std::vector<BodyInField*> acted_on;
    std::vector<BodyInField> before;
    for (std::size_t field = 0; field < std::min(fields.size(), kMostFields); ++field) {
        acted_on.clear();
        before.clear();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if ((masks[i] >> field & 1U) == 0) continue;
            acted_on.push_back(bodies[i]);
            before.push_back(*bodies[i]);
        }
        if (acted_on.empty()) continue;
        fields[field]->act(acted_on, time);
        for (std::size_t i = 0; i < acted_on.size(); ++i) {
            BodyInField& body = *acted_on[i];
            const Vec3d gain_mps = (body.impulse_Ns - before[i].impulse_Ns) / body.mass_kg;
            body.gain_mps += gain_mps;
            body.velocity_mps += 0.5 * gain_mps;
            body.spin_radps +=
                0.5 * spun_up_by(body, body.angular_impulse_Nms - before[i].angular_impulse_Nms);
        }
    }
}

void FieldForces::begin_island(std::span<ForceField* const> fields) {
    fields_ = fields;
    members_.clear();
    work_ = {};
}

void FieldForces::add(std::uint32_t body, BodyId id, std::uint32_t mask) {
    members_.push_back({.body = body, .mask = mask, .state = {.id = id}});
}

void FieldForces::push(std::span<SolverBody> bodies, const FieldTime& time) {
    states_.clear();
    masks_.clear();
    for (Member& member : members_) {
        member.state = in_the_middle(bodies[member.body], member.state.id, time.h_s);
        states_.push_back(&member.state);
        masks_.push_back(member.mask);
    }
    act_on_all(fields_, states_, masks_, time);
    for (const Member& member : members_) {
        SolverBody& body = bodies[member.body];
        body.velocity_increment_mps += Vec3(member.state.impulse_Ns / member.state.mass_kg);
        body.spin_increment_radps +=
            Vec3(spun_up_by(member.state, member.state.angular_impulse_Nms));
    }
}

void FieldForces::count(std::span<const SolverBody> bodies) {
    for (const Member& member : members_) {
        const SolverBody& body = bodies[member.body];
        const Vec3d v = Vec3d(body.velocity_mps) - 0.5 * Vec3d(body.velocity_increment_mps);
        const Vec3d spin = Vec3d(body.spin_radps) - 0.5 * Vec3d(body.spin_increment_radps);
        work_.work_J +=
            glm::dot(member.state.impulse_Ns, v) + glm::dot(member.state.angular_impulse_Nms, spin);
        work_.impulse_Ns += member.state.impulse_Ns;
    }
}

}  // namespace plumbline::physics

#include "engine/physics/surface_contacts.h"

#include "engine/physics/dynamics/rotation.h"
#include "engine/physics/medium.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/query.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// What has sunk in comes out at this share a second, and no faster than so.
constexpr double kOut_per_s = 20;
constexpr double kOut_mps = 0.5;
/// A place presses on a point that has at least so much of its weight.
constexpr double kPresses = 0.4;
constexpr int kContactSweeps = 2;
/// Looked for beyond what moves there within the sub-step.
constexpr double kReach_m = 0.005;

Vec3d mean_of(std::span<const Vec3d> values, const SurfacePlace& place) {
    Vec3d mean{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) mean += place.weights[i] * values[place.points[i]];
    return mean;
}

/// Of the place against the body.
Vec3d velocity_of(const PointBody& body,
                  const NearBody& near,
                  const SurfacePlace& place,
                  const Vec3d& arm_m) {
    const NearMotion& motion = near.motion();
    return mean_of(body.velocities_mps(), place) - motion.velocity_mps -
           glm::cross(motion.spin_radps, arm_m);
}

}  // namespace

double wanted_opening_mps(double gap_m, double h) {
    return gap_m > 0 ? -gap_m / h : std::min(-gap_m * kOut_per_s, kOut_mps);
}

void NearMotion::start(BodyInField* body, double seconds) {
    state = body;
    inverse_mass = 0;
    inverse_inertia = {0, 0, 0};
    falls = false;
    pushed_Ns = {0, 0, 0};
    if (body == nullptr) return;
    velocity_mps = body->velocity_mps - 0.5 * body->gain_mps;
    start_mps = velocity_mps;
    spin_radps = body->spin_radps;
    center_m = body->center_m - velocity_mps * (seconds / 2);
    world_from_mass = glm::normalize(turn_by(spin_radps, -seconds / 2) * body->world_from_mass);
}

void NearMotion::give_way(double share) {
    inverse_mass = share / state->mass_kg;
    inverse_inertia = share / state->inertia_kgm2;
    falls = share > 0.5;
}

void NearMotion::push(const Vec3d& impulse_Ns, const Vec3d& arm_m) {
    if (state == nullptr) return;
    const Vec3d turn_Nms = glm::cross(arm_m, impulse_Ns);
    velocity_mps += impulse_Ns * inverse_mass;
    pushed_Ns += impulse_Ns;
    spin_radps +=
        world_from_mass * (inverse_inertia * (glm::conjugate(world_from_mass) * turn_Nms));
    state->impulse_Ns += impulse_Ns;
    state->angular_impulse_Nms += turn_Nms;
}

void NearMotion::move(double h) {
    center_m += velocity_mps * h;
    world_from_mass = glm::normalize(turn_by(spin_radps, h) * world_from_mass);
}

void SurfaceContacts::find(const PhysicsWorld& world,
                           const PointBody& body,
                           std::span<const NearBody> near,
                           double thickness_m,
                           double seconds) {
    contacts_.clear();
    const PointBounds bounds = bounds_of(body.positions_m());
    const double moved_most_m = fastest_mps(body.velocities_mps()) * seconds;
    for (std::uint32_t i = 0; i < near.size(); ++i) {
        if (!near[i].touches || !world.contains(near[i].id)) continue;
        const NearMotion& motion = near[i].motion();
        const double reach_m = thickness_m + glm::length(motion.velocity_mps) * seconds + kReach_m;
        const double most_m = reach_m + thickness_m / 2 + moved_most_m;
        const BallSearch search(world,
                                near[i].id,
                                {motion.center_m, motion.world_from_mass},
                                bounds.low_m - most_m,
                                bounds.high_m + most_m);
        if (search.finds_nothing()) continue;
        const auto [places, is_new] = places_.try_emplace(near[i].places);
        if (is_new) places->second = body.places(near[i].places);
        for (const SurfacePlace& place : places->second) {
            const double moved_m = glm::length(mean_of(body.velocities_mps(), place)) * seconds;
            const auto touch = search.nearest(
                mean_of(body.positions_m(), place), thickness_m / 2, reach_m + moved_m);
            if (!touch) continue;
            contacts_.push_back({.near = i,
                                 .place = place,
                                 .normal = touch->normal,
                                 .arm_m = touch->on_body_m - motion.center_m,
                                 .gap_m = touch->distance_m});
        }
    }
}

void SurfaceContacts::solve(PointBody& body, std::span<NearBody> near, double h) {
    for (Contact& contact : contacts_) {
        contact.pressed_Ns = 0;
        contact.rubbed_Ns = {0, 0, 0};
    }
    for (int sweep = 0; sweep < kContactSweeps; ++sweep) {
        for (Contact& contact : contacts_) solve_one(contact, body, near[contact.near], h);
    }
    for (const Contact& contact : contacts_) {
        if (contact.pressed_Ns == 0) continue;
        for (std::size_t i = 0; i < 4; ++i) {
            if (contact.place.weights[i] > kPresses)
                body.press(contact.place.points[i],
                           contact.normal,
                           near[contact.near].motion().inverse_mass);
        }
    }
}

void SurfaceContacts::follow(const PointBody& body, std::span<const NearBody> near, double h) {
    for (Contact& contact : contacts_)
        contact.gap_m +=
            h * glm::dot(contact.normal,
                         velocity_of(body, near[contact.near], contact.place, contact.arm_m));
}

void SurfaceContacts::solve_one(Contact& contact, PointBody& body, NearBody& near, double h) {
    const Vec3d relative = velocity_of(body, near, contact.place, contact.arm_m);
    const double opening = glm::dot(contact.normal, relative);
    const double wanted = wanted_opening_mps(contact.gap_m, h);
    if (opening >= wanted && contact.pressed_Ns == 0) return;
    const NearMotion& motion = near.motion();
    double inverse_mass = motion.inverse_mass;
    for (std::size_t i = 0; i < 4; ++i)
        inverse_mass += contact.place.weights[i] * contact.place.weights[i] *
                        body.inverse_mass(contact.place.points[i]);
    const auto along = [&](const Vec3d& direction) {
        const Vec3d turn =
            glm::conjugate(motion.world_from_mass) * glm::cross(contact.arm_m, direction);
        return inverse_mass + glm::dot(turn, motion.inverse_inertia * turn);
    };
    const double normal_weight = along(contact.normal);
    if (!(normal_weight > 0)) return;
    const double pressed = std::max(contact.pressed_Ns + (wanted - opening) / normal_weight, 0.0);
    Vec3d impulse = contact.normal * (pressed - contact.pressed_Ns);
    contact.pressed_Ns = pressed;
    const Vec3d carried =
        Vec3d(near.belt.velocity_mps) + glm::cross(Vec3d(near.belt.spin_radps), contact.arm_m);
    const Vec3d slip = relative - carried;
    const Vec3d sliding = slip - contact.normal * glm::dot(contact.normal, slip);
    const double speed = glm::length(sliding);
    if (speed > 0) {
        Vec3d rubbed = contact.rubbed_Ns - sliding / along(sliding / speed);
        const double most = near.friction * pressed;
        const double size = glm::length(rubbed);
        if (size > most) rubbed *= most / size;
        impulse += rubbed - contact.rubbed_Ns;
        contact.rubbed_Ns = rubbed;
    }
    for (std::size_t i = 0; i < 4; ++i)
        body.change_velocity(
            contact.place.points[i],
            impulse * (contact.place.weights[i] * body.inverse_mass(contact.place.points[i])));
    near.push(-impulse, contact.arm_m);
}

}  // namespace plumbline::physics

#include "engine/study/scenarios/world/framed_world.h"

#include <cmath>

namespace plumbline::study {

using physics::BodyKind;

namespace {

physics::WorldDef framed(const Frame& frame, const Setting& setting) {
    physics::WorldDef def = world_def(setting);
    def.gravity_mps2 = Vec3(frame.turn * Vec3d{0, -kG_mps2, 0});
    def.step_s *= std::sqrt(frame.scale);
    return def;
}

}  // namespace

FramedWorld::FramedWorld(const Frame& frame, const Setting& setting)
    : frame_(frame), world_(framed(frame, setting)) {}

std::size_t FramedWorld::box(BodyKind kind,
                             const Vec3d& at,
                             const Vec3d& size,
                             const BodyProperties& properties) {
    parts_.push_back({kind, physics::BoxShape{.size_m = vec(size * frame_.scale)}, at, properties});
    return parts_.size() - 1;
}

std::size_t FramedWorld::sphere(const Vec3d& at, double radius, const BodyProperties& properties) {
    parts_.push_back({BodyKind::Dynamic,
                      physics::SphereShape{.radius_m = real(radius * frame_.scale)},
                      at,
                      properties});
    return parts_.size() - 1;
}

void FramedWorld::floor(double friction, double restitution) {
    box(BodyKind::Static,
        {0, -1, 0},
        {90, 2, 90},
        {.friction = friction, .restitution = restitution});
}

void FramedWorld::build() {
    const double speed_scale = std::sqrt(frame_.scale);
    const bool drifts = glm::length(frame_.drift_mps) > 0;
    ids_.resize(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const std::size_t which = frame_.backwards ? parts_.size() - 1 - i : i;
        const Part& part = parts_[which];
        BodyProperties properties = part.properties;
        properties.turn = frame_.turn * properties.turn;
        properties.velocity_mps =
            frame_.turn * properties.velocity_mps * speed_scale + frame_.drift_mps;
        properties.spin_radps = frame_.turn * properties.spin_radps / speed_scale;
        const bool carried = part.kind == BodyKind::Static && drifts;
        ids_[which] = world_.add(
            carried ? BodyKind::Kinematic : part.kind, part.shape, place(part.at), properties);
    }
}

void FramedWorld::join(std::size_t a, std::size_t b, const Vec3d& anchor) {
    world_.join_at(place(anchor), ids_[a], ids_[b]);
}

void FramedWorld::run(Stepper& stepper, double seconds) {
    const double scaled_s = seconds * std::sqrt(frame_.scale);
    stepper.run(world_, scaled_s);
    passed_s_ += std::round(scaled_s / world_.step_s()) * world_.step_s();
}

Vec3d FramedWorld::at(std::size_t part) const {
    const Vec3d moved = world_.at(ids_[part]) - frame_.offset_m - frame_.drift_mps * passed_s_;
    return glm::conjugate(frame_.turn) * moved / frame_.scale;
}

Vec3d FramedWorld::velocity(std::size_t part) const {
    return glm::conjugate(frame_.turn) * (world_.velocity(ids_[part]) - frame_.drift_mps) /
           std::sqrt(frame_.scale);
}

}  // namespace plumbline::study

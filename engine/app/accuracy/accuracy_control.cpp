#include "engine/app/accuracy/accuracy_control.h"

#include "engine/physics/debug_lines.h"
#include "engine/physics/totals.h"
#include "engine/study/findings/fidelity_price.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::app {
namespace {

constexpr double kWindow_s = 1.0;
constexpr Vec3f kGhostColor{0.2F, 0.9F, 1.0F};
constexpr Vec3f kGhostRim{0.0F, 0.03F, 0.06F};

/// Nothing that an outline would show.
bool looks_the_same(const Pose& a, const Pose& b) {
    constexpr Real kApart_m = 1e-3_r;
    constexpr Real kTurned = 1e-3_r;  // of the quaternions: a tenth of a degree
    const Real turned = std::min(glm::length(a.orientation - b.orientation),
                                 glm::length(a.orientation + b.orientation));
    return glm::distance(a.position, b.position) < kApart_m && turned < kTurned;
}

/// Lines as wide as several pixels, with a dark rim: seen at a glance on any ground.
void add_wide(const LineList& thin, const Vec3f& eye_world, LineList& lines) {
    constexpr float kPixel = 0.0013F;  // of the distance; 50 degrees over 720 lines
    // The rim first: what is drawn later covers it.
    constexpr std::array kStrokes{-2.0F, 2.0F, -1.0F, 1.0F, 0.0F};
    for (const float stroke : kStrokes) {
        for (std::size_t i = 0; i + 1 < thin.vertices.size(); i += 2) {
            const Vec3f& from = thin.vertices[i].position_world;
            const Vec3f& to = thin.vertices[i + 1].position_world;
            const Vec3f sight = (from + to) * 0.5F - eye_world;
            const Vec3f across = glm::cross(to - from, sight);
            const float length = glm::length(across);
            if (!(length > 0.0F)) continue;
            const Vec3f aside = across * (stroke * kPixel * glm::length(sight) / length);
            lines.add(from + aside,
                      to + aside,
                      std::abs(stroke) > 1.5F ? kGhostRim : thin.vertices[i].color);
        }
    }
}

}  // namespace

void AccuracyControl::watch(bool shown) {
    if (shown && !watched_) study.look_up();
    watched_ = shown;
    if (!shown) samples_.clear();
}

std::vector<EffectInPlay> AccuracyControl::effects() const {
    std::vector<EffectInPlay> all;
    const std::vector<effects::LedgerLine> ledger = session_.effects->ledger();
    for (std::size_t i = 0; i < ledger.size(); ++i) {
        const scene::Fidelity* fidelity =
            scene::fidelity_of(session_.simulation->description(), ledger[i].name);
        if (fidelity == nullptr || !ledger[i].exists ||
            effects::effect_table()[i].domain != effects::Domain::Step)
            continue;
        all.push_back({.name = std::string(ledger[i].name), .fidelity = *fidelity});
        if (study.study() != nullptr)
            all.back().price =
                study::price_text(study::prices_of(study.study()->subject.points, ledger[i].name));
    }
    return all;
}

void AccuracyControl::after_step() {
    const scene::Simulation& simulation = *session_.simulation;
    forget_other_world();
    if (ghost_) ghost_->follow(simulation);
    if (!watched_) return;
    const physics::PhysicsWorld& world = simulation.physics;
    samples_.push_back({.time_s = simulation.time_s(),
                        .cost = world.report().cost,
                        .energy_J = physics::energy(world).total_J(),
                        .max_penetration_m = max_penetration_m(world),
                        .max_joint_error_m = max_joint_error_m(world),
                        .most_substeps = most_substeps(world)});
    while (samples_.front().time_s < simulation.time_s() - kWindow_s) samples_.pop_front();
}

void AccuracyControl::forget_other_world() {
    const bool same_world = generation_ == session_.generation();
    if (!same_world) ghost_.reset();
    generation_ = session_.generation();
    if (const study::Setting now = setting(); !same_world || now != sampled_at_) {
        samples_.clear();
        sampled_at_ = now;
    }
}

Result<Done> AccuracyControl::start_ghost(const study::Setting& setting) {
    forget_other_world();
    Result<study::Ghost> started = study::Ghost::start(*session_.simulation, setting);
    if (!started) return started.error();
    ghost_ = std::move(*started);
    return Done{};
}

void AccuracyControl::take_answers() {
    forget_other_world();
    if (ghost_) ghost_->take_answers();
    study.take_answers();
    picture.take_answers();
}

void AccuracyControl::add_ghost_lines(LineList& lines, const Vec3f& eye_world) const {
    if (!ghost_ || !ghost_->failure().empty()) return;
    const scene::Simulation& simulation = *session_.simulation;
    const std::span<const physics::BodyId> bodies = ghost_->bodies();
    const std::vector<study::GhostBody>& poses = ghost_->latest().bodies;
    LineList thin;
    // Both lists are in the order in which bodies came.
    std::size_t next = 0;
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        while (next < bodies.size() && bodies[next] < moving.body) ++next;
        if (next == bodies.size()) break;
        if (bodies[next] != moving.body) continue;
        const Pose pose{Vec3(poses[next].position_m), Quat(poses[next].orientation)};
        if (looks_the_same(simulation.physics.state(moving.body).world_from_body, pose)) continue;
        add_shape_lines(simulation.physics, moving.shape, pose, kGhostColor, thin);
    }
    add_wide(thin, eye_world, lines);
}

AccuracyGauges AccuracyControl::gauges(const FrameClock& clock) const {
    AccuracyGauges gauges{.lost_s = clock.lost_s()};
    if (samples_.empty()) return gauges;
    for (const Sample& sample : samples_) {
        gauges.cost.add(sample.cost);
        gauges.max_penetration_m = std::max(gauges.max_penetration_m, sample.max_penetration_m);
        gauges.max_joint_error_m = std::max(gauges.max_joint_error_m, sample.max_joint_error_m);
        gauges.most_substeps = std::max(gauges.most_substeps, sample.most_substeps);
    }
    const auto count = static_cast<double>(samples_.size());
    gauges.ms_per_s = gauges.cost.cpu_ms_total / (count * session_.simulation->step_s());
    gauges.islands = session_.simulation->physics.report().islands.size();
    gauges.energy_J = samples_.back().energy_J;
    gauges.energy_change_J = samples_.back().energy_J - samples_.front().energy_J;
    return gauges;
}

}  // namespace plumbline::app

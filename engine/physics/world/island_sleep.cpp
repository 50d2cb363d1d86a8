#include "engine/physics/world/island_sleep.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/body_scope.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Stretches of time that must be slow, one after the other.
constexpr int kStretches = 2;
/// Slow: below this share of the speed of a fall by the radius, sqrt(2 g r).
constexpr double kSlowShare = 0.0141;
/// ... and without gravity below this many radii per second.
constexpr double kSlowRadii_per_s = 1e-3;
/// The mean speed of a body at rest over a stretch, as a share of what is slow.
constexpr double kDriftShare = 0.08;
/// A body that goes farther in each stretch is tipping over or has been let go.
constexpr double kGrowth = 1.5;
/// Ways shorter than this share of the radius are rounding and say nothing about growth.
constexpr double kNoiseShare = 1e-4;

constexpr std::string_view kOtherSleepers = "who sleeps together does not agree";

double slow_mps(double radius_m, double gravity_mps2) {
    return std::max(kSlowShare * std::sqrt(2 * gravity_mps2 * radius_m),
                    kSlowRadii_per_s * radius_m);
}

/// Speed of a point mass with the body's kinetic energy.
double speed_of_energy(const BodyRecord& record) {
    const Vec3d v{record.motion->velocity_mps};
    const Vec3d spin{unrotated(record.motion->spin_radps, record.motion->at.rotation)};
    return std::sqrt(glm::dot(v, v) +
                     glm::dot(record.traits.inertia_kgm2, spin * spin) / record.traits.mass_kg);
}

Vec3d position_of(const BodyRecord& record) {
    if (record.motion->ballistic.going) return record.motion->ballistic.position_m;
    return Vec3d{record.motion->at.position_m};
}

Quatd orientation_of(const BodyRecord& record) {
    if (record.motion->ballistic.going) return record.motion->ballistic.orientation;
    return double_quat_of(record.motion->at.rotation);
}

void start_stretch(BodyRecord& record) {
    record.small.rest.position_m = position_of(record);
    record.small.rest.orientation = orientation_of(record);
    record.small.rest.stretch_s = 0;
}

/// How far the body's farthest point went in this stretch.
double displacement_m(const BodyRecord& record) {
    const Quatd turn = orientation_of(record) * glm::conjugate(record.small.rest.orientation);
    const double angle_rad = 2 * glm::length(Vec3d{turn.x, turn.y, turn.z});
    return glm::distance(position_of(record), record.small.rest.position_m) +
           static_cast<double>(record.traits.radius_m) * angle_rad;
}

}  // namespace

void break_rest(BodyRecord& record) {
    record.small.rest.slow_stretches = 0;
    record.small.rest.went_m = -1;
    record.small.rest.stretch_s = -1;  // the next slow step starts a stretch
}

void watch_rest(BodyRecord& record, double gravity_mps2, double step_s) {
    const auto radius_m = static_cast<double>(record.traits.radius_m);
    const double slow = slow_mps(radius_m, gravity_mps2);
    if (record.applied.by_caller || speed_of_energy(record) > slow) return break_rest(record);
    Rest& rest = record.small.rest;
    if (rest.stretch_s < 0) return start_stretch(record);
    rest.stretch_s += step_s;
    constexpr double kStretch_s = kSleepAfter_s / kStretches;
    if (rest.stretch_s < kStretch_s) return;
    const double moved_m = displacement_m(record);
    const bool grows =
        rest.went_m >= 0 && moved_m > kGrowth * rest.went_m && moved_m > kNoiseShare * radius_m;
    rest.slow_stretches =
        moved_m <= kDriftShare * slow * rest.stretch_s && !grows ? rest.slow_stretches + 1 : 0;
    rest.went_m = moved_m;
    start_stretch(record);
}

bool is_at_rest(const Island& island) {
    if (!island.supported || island.carried) return false;
    return std::all_of(island.bodies.begin(), island.bodies.end(), [](const BodyRecord* record) {
        return record->can_sleep && record->small.rest.slow_stretches >= kStretches;
    });
}

std::uint32_t SleepingIslands::add(std::span<BodyRecord* const> bodies) {
    if (free_.empty()) {
        bodies_.emplace_back();
        free_.push_back(static_cast<std::uint32_t>(bodies_.size()));
    }
    const std::uint32_t sleeping_island = free_.back();
    free_.pop_back();
    bodies_[sleeping_island - 1].assign(bodies.begin(), bodies.end());
    return sleeping_island;
}

std::vector<BodyRecord*> SleepingIslands::end(std::uint32_t sleeping_island) {
    free_.push_back(sleeping_island);
    return std::exchange(bodies_[sleeping_island - 1], {});
}

std::size_t SleepingIslands::count() const {
    std::size_t count = 0;
    for (const std::vector<BodyRecord*>& together : bodies_) count += together.size();
    return count;
}

void SleepingIslands::serialize(Archive& archive, const BodyScope& scope) {
    bodies_.resize(archive.count(bodies_.size()));
    for (std::size_t i = 0; i < bodies_.size() && !archive.failed(); ++i) {
        physics::serialize(archive, bodies_[i], scope);
        const auto is_here = [i](const BodyRecord* record) {
            return sleeps(*record) && record->small.sleeping_island == i + 1;
        };
        if (archive.reads())
            archive.expect(std::ranges::all_of(bodies_[i], is_here), kOtherSleepers);
    }
    archive(free_);
    if (!archive.reads() || archive.failed()) return;
    std::vector<bool> is_free(bodies_.size(), false);
    for (const std::uint32_t number : free_) {
        const bool is_new = number >= 1 && number <= bodies_.size() && !is_free[number - 1] &&
                            bodies_[number - 1].empty();
        if (!archive.expect(is_new, kOtherSleepers)) return;
        is_free[number - 1] = true;
    }
}

}  // namespace plumbline::physics

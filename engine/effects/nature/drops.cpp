#include "engine/effects/nature/drops.h"

#include "engine/effects/effect_table.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

/// Of a ball, at the Reynolds numbers of falling drops.
constexpr float kDragCoefficient = 0.47F;
constexpr float kAir_over_water = 1.2F / 1000.0F;
/// A body in the way is looked for so many steps ahead, and then not again until they have passed.
constexpr float kStepsAhead = 4.0F;
constexpr std::size_t kMostRings = 96;
constexpr std::uint32_t kDropsARing = 6;
constexpr float kLeastReach_m = 0.03F;
constexpr float kSplashLife_s = 0.35F;
/// Splashes are too small to be slowed or to splash again.
constexpr float kSplashSize = 0.5F;

constexpr std::array<float, 3> kDropShares{0.4F, 1.0F, 2.0F};  // by fidelity

float litres_of(float radius_m) {
    return 4.0F / 3.0F * glm::pi<float>() * radius_m * radius_m * radius_m * 1000.0F;
}

}  // namespace

Drops::Drops(std::span<const scene::FountainDescription> fountains,
             scene::Fidelity fidelity,
             const Vec3f& gravity_mps2)
    : gravity_mps2_(gravity_mps2) {
    float total_per_s = 0.0F;
    for (const scene::FountainDescription& fountain : fountains) {
        const float radius_m = static_cast<float>(fountain.drop_mm) * 0.5e-3F;
        const Vec3f direction(fountain.direction);
        const Vec3f aside =
            std::abs(direction.y) < 0.9F ? Vec3f{0.0F, 1.0F, 0.0F} : Vec3f{1.0F, 0.0F, 0.0F};
        const Vec3f axis_x = glm::normalize(glm::cross(direction, aside));
        nozzles_.push_back(
            {.position_world = Vec3f(fountain.position_m),
             .direction = direction,
             .axis_x = axis_x,
             .axis_z = glm::cross(axis_x, direction),
             .ring = fountain.ring,
             .speed_mps = static_cast<float>(fountain.speed_mps),
             .spread_rad = static_cast<float>(fountain.spread_rad),
             .drops_per_s = static_cast<float>(fountain.flow_lps) / litres_of(radius_m),
             .held_l = static_cast<float>(fountain.flow_lps),  // of a second, so far
             .radius_m = radius_m,
             .drag_per_m =
                 fountain.drag ? 0.375F * kAir_over_water * kDragCoefficient / radius_m : 0.0F});
        total_per_s += nozzles_.back().drops_per_s;
        for (const scene::PoolDescription& pool : fountain.pools)
            pools_.push_back({Vec3f(pool.center_m), static_cast<float>(pool.radius_m)});
    }
    const float share = std::min(by_fidelity(fidelity, kDropShares),
                                 total_per_s > 0.0F ? kMostPerSecond / total_per_s : 1.0F);
    for (Nozzle& nozzle : nozzles_) {
        nozzle.drops_per_s *= share;
        nozzle.held_l = nozzle.drops_per_s > 0.0F ? nozzle.held_l / nozzle.drops_per_s : 0.0F;
    }
}

Drop Drops::leaving(const Nozzle& nozzle) {
    const float turn = random_.uniform(0.0F, 2.0F * glm::pi<float>());
    // Even over the cap of directions, near enough for the narrow ones of jets.
    const float tilt = nozzle.spread_rad * std::sqrt(random_.uniform());
    Vec3f ahead = nozzle.direction;
    Vec3f x = nozzle.axis_x;
    Vec3f z = nozzle.axis_z;
    Vec3f place = nozzle.position_world;
    if (nozzle.ring) {
        const scene::NozzleRing& ring = *nozzle.ring;
        const auto streams = static_cast<std::uint32_t>(ring.streams);
        // At random: in turn, they would leave in a spiral that the eye sees.
        const float angle = 2.0F * glm::pi<float>() * static_cast<float>(random_.below(streams)) /
                            static_cast<float>(streams);
        ahead = nozzle.axis_x * portable_cos(angle) + nozzle.axis_z * portable_sin(angle);
        place += ahead * static_cast<float>(ring.radius_m);
        x = nozzle.direction;
        z = glm::cross(x, ahead);
    }
    const Vec3f aside = x * portable_cos(turn) + z * portable_sin(turn);
    return {.position_world = place,
            .velocity_mps =
                (ahead * portable_cos(tilt) + aside * portable_sin(tilt)) * nozzle.speed_mps,
            .radius_m = nozzle.radius_m,
            .drag_per_m = nozzle.drag_per_m,
            .held_l = nozzle.held_l,
            .rank = random_.uniform()};
}

void Drops::emit(Nozzle& nozzle, float step_s) {
    nozzle.due += nozzle.drops_per_s * step_s;
    while (nozzle.due >= 1.0F) {
        nozzle.due -= 1.0F;
        Drop drop = leaving(nozzle);
        in_l_ += static_cast<double>(drop.held_l);
        // It left when it was due, within the step: a jet has no gaps from step to step.
        const float since_s = std::min(nozzle.due / nozzle.drops_per_s, step_s);
        drop.age_s = since_s;
        integrate(drop, since_s);
        drops_.push_back(drop);
    }
}

void Drops::integrate(Drop& drop, float step_s) const {
    // Half of the drag, all of gravity, half of the drag: order two, exact without air, and steady for
    // drops that air stops within a step.
    const Vec3f before = drop.velocity_mps;
    const auto slowed = [&](const Vec3f& velocity) {
        const Vec3f through_air = velocity - wind_mps_;
        return wind_mps_ +
               through_air / (1.0F + drop.drag_per_m * glm::length(through_air) * 0.5F * step_s);
    };
    drop.velocity_mps = slowed(slowed(before) + gravity_mps2_ * step_s);
    drop.position_world += 0.5F * (before + drop.velocity_mps) * step_s;
}

std::optional<Drops::PoolHit> Drops::pool_met(const Vec3f& from, const Vec3f& to) const {
    for (const Pool& pool : pools_) {
        if (from.y < pool.center_world.y || to.y >= pool.center_world.y) continue;
        const float share = (from.y - pool.center_world.y) / (from.y - to.y);
        const Vec3f place = glm::mix(from, to, share);
        const Vec3f off = place - pool.center_world;
        const float reach_m = pool.radius_m - glm::length(glm::vec2{off.x, off.z});
        if (reach_m >= 0.0F) return PoolHit{place, reach_m};
    }
    return {};
}

void Drops::look_ahead(Drop& drop, float step_s, const Obstacles& obstacles) const {
    const float ahead_s = kStepsAhead * step_s;
    drop.looks_at_s = drop.age_s + ahead_s;
    const Vec3f to = drop.position_world + drop.velocity_mps * ahead_s +
                     0.5F * gravity_mps2_ * (ahead_s * ahead_s);
    if (const auto share = obstacles(drop.position_world, to))
        drop.ends_at_s = drop.age_s + *share * ahead_s;
}

void Drops::raise_ring(const PoolHit& hit) {
    if (hit.reach_m < kLeastReach_m || random_.below(kDropsARing) != 0) return;
    if (rings_.size() >= kMostRings) rings_.erase(rings_.begin());
    rings_.push_back({.center_world = hit.place_world,
                      .strength = random_.uniform(0.4F, 1.0F),
                      .reach_m = hit.reach_m});
}

void Drops::splash(const Vec3f& place, const Drop& drop) {
    if (random_.below(3) != 0) return;
    const float turn = random_.uniform(0.0F, 2.0F * glm::pi<float>());
    const float speed = std::min(0.35F * glm::length(drop.velocity_mps), 1.4F);
    const float aside = random_.uniform(0.1F, 0.6F);
    splashes_.push_back({.position_world = place,
                         .velocity_mps = speed * Vec3f{aside * portable_cos(turn),
                                                       random_.uniform(0.5F, 1.0F),
                                                       aside * portable_sin(turn)},
                         .radius_m = kSplashSize * drop.radius_m,
                         .ends_at_s = kSplashLife_s,
                         .rank = random_.uniform()});
}

void Drops::step(float step_s, const Obstacles& obstacles, const Vec3f& wind_mps) {
    wind_mps_ = wind_mps;
    splashes_.clear();
    std::size_t kept = 0;
    for (Drop drop : drops_) {  // a copy: places are taken over from the front
        const Vec3f from = drop.position_world;
        if (drop.held_l > 0.0F && obstacles && drop.age_s >= drop.looks_at_s)
            look_ahead(drop, step_s, obstacles);
        integrate(drop, step_s);
        drop.age_s += step_s;
        const auto pool = pool_met(from, drop.position_world);
        const bool meets_body = drop.age_s >= drop.ends_at_s;
        if (!pool && !meets_body && drop.age_s < kLongestFlight_s) {
            drops_[kept++] = drop;
            continue;
        }
        out_l_ += static_cast<double>(drop.held_l);
        if (drop.held_l <= 0.0F) continue;
        if (pool) raise_ring(*pool);
        if (pool || meets_body) splash(pool ? pool->place_world : from, drop);
    }
    drops_.resize(kept);
    for (Nozzle& nozzle : nozzles_) emit(nozzle, step_s);
    drops_.insert(drops_.end(), splashes_.begin(), splashes_.end());
    for (WaterRing& ring : rings_) ring.age_s += step_s;
    std::erase_if(rings_, [](const WaterRing& ring) { return ring.age_s >= kRingLife_s; });
}

void Drops::serialize(Archive& archive) {
    for (Nozzle& nozzle : nozzles_) archive.within(nozzle.due, 0.0F, kMostPerSecond);
    archive(random_, drops_, rings_, in_l_, out_l_);
}

WaterFlow Drops::flow() const {
    WaterFlow flow{.in_l = in_l_, .out_l = out_l_};
    for (const Drop& drop : drops_) flow.held_l += static_cast<double>(drop.held_l);
    return flow;
}

std::size_t Drops::bytes() const {
    return (drops_.capacity() + splashes_.capacity()) * sizeof(Drop) +
           rings_.capacity() * sizeof(WaterRing);
}

}  // namespace plumbline::effects

#include "engine/scene/simulation.h"

#include "engine/core/hash.h"
#include "engine/core/limits.h"
#include "engine/core/process/interrupt.h"
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/fragments.h"
#include "engine/scene/environment/sun_path.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace plumbline::scene {

namespace {

/// Above it 16 sub-steps do not hold the heavier body up (docs/PHYSICS.md).
constexpr Real kWidestMassRatio = 1e4_r;

bool is_below(const std::optional<Real>& height_m, const Vec3& position) {
    return height_m && position.y < *height_m;
}

bool is_far_out(const Vec3& position) {
    const auto limit_m = static_cast<Real>(limits::kPosition_m);
    return glm::any(glm::greaterThan(glm::abs(position), Vec3{limit_m}));
}

/// What lay on them or hung from them has to move.
void wake_round(physics::PhysicsWorld& world, std::span<const Vec3d> points_m) {
    constexpr double kNear_m = 0.1;
    const auto [low, high] = physics::bounds_of(points_m);
    for (const physics::BodyId body :
         physics::bodies_in_box(world, Vec3(low - kNear_m), Vec3(high + kNear_m)))
        world.wake(body);
}

}  // namespace

Simulation::Simulation(SceneDescription description,
                       const SimulationOverrides& overrides,
                       assets::AssetLibrary& library,
                       SurfaceTable surfaces)
    : physics(world_def(description, overrides)),
      random(overrides.seed),
      description_(std::move(description)),
      library_(library),
      surfaces_(std::move(surfaces)),
      clock_{.step_s = physics.def().step_s},
      open_(std::make_shared<bool>(true)) {
    std::vector<EffectFidelity>& chosen = description_.accuracy.fidelity;
    if (!overrides.fidelity.empty()) chosen = overrides.fidelity;
    for (const EffectFidelity& each : chosen) {
        if (Fidelity* place = fidelity_of(description_, each.effect)) *place = each.fidelity;
    }
    switches.textures = !description_.viewer;
    if (description_.sun) {
        const SunDescription& sun = *description_.sun;
        switches.sun_direction = Vec3f(sun.direction);
        switches.sun_rotation_radps = static_cast<float>(sun.rotation_radps);
    }

    registry.on_remove<BodyRef>([this, open = open_](ecs::Entity, BodyRef& ref) {
        if (!*open) return;
        physics.destroy_body(ref.body);
        bodies_.any_destroyed = true;
        ++revision_;
    });
    registry.on_remove<Name>([this, open = open_](ecs::Entity entity, Name& name) {
        if (!*open) return;
        const auto known = names_.entities.find(name.text);
        if (known != names_.entities.end() && known->second == entity) {
            names_.entities.erase(known);
        }
        bodies_.any_destroyed = true;
        ++revision_;
    });
    builder_ = std::make_unique<EntityBuilder>(*this);
}

Simulation::~Simulation() {
    *open_ = false;
}

void Simulation::remember_poses() {
    registry.view<PreviousTransform, const Transform>().each(
        [](ecs::Entity, PreviousTransform& previous, const Transform& now) {
            previous.world_from_body = now.world_from_body;
        });
}

void Simulation::step() {
    forget_destroyed();
    if (before_step) {
        before_step(*this);
        forget_destroyed();
    }
    move_along_paths();
    play_models();
    if (!deformables.empty()) deformables.begin_step(step_s());
    if (stepped_elsewhere) {
        stepped_elsewhere();
    } else {
        const IgnoresInterrupts work;
        physics.step(force_fields.all());
    }
    if (!deformables.empty()) deformables.end_step();
    charges_lit.clear();  // whoever lives by them took them before the step
    ++clock_.steps;
    if (switches.sun_rotation_radps != 0.0F) {
        const float angle = switches.sun_rotation_radps * static_cast<float>(clock_.step_s);
        const Vec3 up = description_.viewer ? description_.viewer->up : Vec3{0, 1, 0};
        // About the earth's axis the sky turns from east to west.
        const Vec3f axis = description_.time ? -sky_pole(*description_.time) : Vec3f(up);
        switches.sun_direction = portable_angle_axis(angle, axis) * switches.sun_direction;
    }
    sync_transforms();
    report_quarantined();
    report_broken_joints();
    warn_of_mass_ratio();
    warn_of_crowd();
}

std::uint64_t Simulation::step_at(double time_s) const {
    const double steps = std::max(0.0, (time_s - clock_.since_s) / clock_.step_s);
    return clock_.since_step + static_cast<std::uint64_t>(std::llround(steps));
}

void Simulation::set_accuracy(const physics::WorldDef& def) {
    clock_.since_s = time_s();
    clock_.since_step = clock_.steps;
    clock_.step_s = def.step_s;
    physics.reconfigure(def);
}

void Simulation::destroy_marked() {
    blows.clear();
    bursts.clear();
    registry.destroy_marked();
    forget_destroyed();
}

void Simulation::move_along_paths() {
    const double end_s = time_at(clock_.steps + 1);
    registry.view<const MotionPath, const BodyRef>().each(
        [&](ecs::Entity, const MotionPath& path, const BodyRef& ref) {
            physics.move_kinematic(ref.body, pose_on_path(path, end_s));
        });
}

void Simulation::sync_transforms() {
    for (MovingBody& moving : bodies_.moving) {
        const physics::BodyState state = physics.state(moving.body);
        // A body that fell asleep in this step still moved in it.
        if (!state.awake && !moving.awake) continue;
        moving.awake = state.awake;
        registry.get<Transform>(moving.entity).world_from_body = state.world_from_body;
        const Vec3& position = state.world_from_body.position;
        if (moving.kind != physics::BodyKind::Dynamic) continue;
        if (is_below(description_.kill_below_m, position) || is_far_out(position)) {
            registry.mark_for_destruction(moving.entity);
            ++tally_.removed;
        }
    }
}

void Simulation::report_quarantined() {
    const std::span<const physics::BodyId> quarantined = physics.report().isolated;
    for (; tally_.quarantined_reported < quarantined.size(); ++tally_.quarantined_reported) {
        const physics::BodyId body = quarantined[tally_.quarantined_reported];
        // It stands where it last was: one that went too far was there at most a step before.
        const Vec3d at{physics.state(body).world_from_body.position};
        warnings.push_back(fmt::format("{}: taken out of the simulation at {:.3f} s: {}",
                                       describe(*this, entity_of(*this, body)),
                                       time_s(),
                                       glm::length(at) > 0.99e6
                                           ? "it was more than 1000 km from the origin"
                                           : "its position or velocity was not a finite number"));
    }
}

/// Names the first touching pair whose masses differ by more than any number of sub-steps can hold.
void Simulation::warn_of_mass_ratio() {
    const auto mass_of = [&](physics::BodyId body) {
        return physics.contains(body) ? physics.state(body).mass.mass_kg : Real{0};
    };
    if (mass_ratio_.weighed_revision != revision_) {
        mass_ratio_.weighed_revision = revision_;
        Real least = std::numeric_limits<Real>::max();
        Real most = 0;
        for (const MovingBody& moving : bodies_.moving) {
            if (moving.kind != physics::BodyKind::Dynamic) continue;
            least = std::min(least, mass_of(moving.body));
            most = std::max(most, mass_of(moving.body));
        }
        mass_ratio_.differ_widely = most > kWidestMassRatio * least;
    }
    if (!mass_ratio_.differ_widely || mass_ratio_.named) return;
    for (const physics::ContactEvent& touch : all_contacts(physics)) {
        const Real a = mass_of(touch.a);
        const Real b = mass_of(touch.b);
        if (a <= 0 || b <= 0 || std::max(a, b) <= kWidestMassRatio * std::min(a, b)) continue;
        mass_ratio_.named = true;
        warnings.push_back(
            fmt::format("{} and {} touch, {:.3g} kg and {:.3g} kg: above a mass ratio of "
                        "{:.0f} the lighter is pressed in",
                        describe(*this, entity_of(*this, touch.a)),
                        describe(*this, entity_of(*this, touch.b)),
                        a,
                        b,
                        kWidestMassRatio));
        return;
    }
}

void Simulation::warn_of_crowd() {
    const std::uint64_t left_out = physics.report().cost.interventions.left_out_pairs;
    if (crowd_named_ || left_out == 0) return;
    crowd_named_ = true;
    warnings.push_back(fmt::format(
        "{} pairs of bodies in a crowd push nothing at {:.3f} s: each body meets the {} "
        "that are nearest",
        left_out,
        time_s(),
        physics::kNearestPairs));
}

void Simulation::forget_destroyed() {
    if (!bodies_.any_destroyed) return;
    bodies_.any_destroyed = false;
    std::erase_if(bodies_.moving, [this](const MovingBody& moving) {
        return !registry.alive(moving.entity) || !physics.contains(moving.body);
    });
    for (auto* list : {&bodies_.cloths, &bodies_.softs}) {
        std::erase_if(*list, [this](SceneDeformable& each) {
            if (registry.alive(each.entity)) return false;
            wake_round(physics, each.body->body().positions_m());
            deformables.leave(*each.body);
            displace(waters, each.displaced, {});
            return true;
        });
    }
}

ecs::Entity Simulation::spawn(const EntityDescription& description) {
    std::string name;
    do {
        name = fmt::format("{}#{}", description.name, ++names_.spawned[description.name]);
    } while (names_.entities.contains(name));
    return respawn(description, name);
}

ecs::Entity Simulation::respawn(const EntityDescription& description, const std::string& name) {
    Result<ecs::Entity> made = builder_->build(description, name);
    if (!made) {
        warnings.push_back(made.error().message);
        return {};
    }
    registry.add<Spawned>(*made, Spawned{.description = description.name});
    return *made;
}

ecs::Entity Simulation::find(std::string_view name) const {
    const auto known = names_.entities.find(name);
    return known == names_.entities.end() ? ecs::Entity{} : known->second;
}

std::uint64_t Simulation::state_hash() const {
    Hasher hasher;
    for (const MovingBody& moving : bodies_.moving) {
        if (!physics.contains(moving.body)) continue;
        const physics::BodyState state = physics.state(moving.body);
        const Vec3& p = state.world_from_body.position;
        const Quat& q = state.world_from_body.orientation;
        const Vec3& v = state.velocity_mps;
        const Vec3& w = state.angular_velocity_radps;
        const Real numbers[] = {p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z, w.x, w.y, w.z};
        hasher.add(numbers, sizeof numbers);
    }
    for (const SceneWater& water : waters) {
        if (water.waves) water.waves->hash(hasher);
    }
    for (const auto* list : {&bodies_.cloths, &bodies_.softs}) {
        for (const SceneDeformable& each : *list) {
            for (const auto& numbers :
                 {each.body->body().positions_m(), each.body->body().velocities_mps()})
                hasher.add(numbers.data(), numbers.size_bytes());
        }
    }
    for (auto [entity, fragile] : registry.view<const Fragile>()) {
        const std::vector<std::uint32_t>& cracked = fragile.cracked;
        hasher.add(cracked.data(), cracked.size() * sizeof(cracked[0]));
    }
    return hasher.digest();
}

void Simulation::set_features(const physics::WorldFeatures& features) {
    features_ = features;
    physics.set_features(features);
}

Pose pose_on_path(const MotionPath& path, double time_s) {
    Pose pose = path.start;
    const double turn_radps = static_cast<double>(glm::length(path.spin_radps));
    if (turn_radps > 0.0) {
        const double angle = std::fmod(turn_radps * time_s, 2.0 * glm::pi<double>());
        const Vec3 axis = path.spin_radps / static_cast<Real>(turn_radps);
        pose.orientation =
            glm::normalize(portable_angle_axis(static_cast<Real>(angle), axis) * pose.orientation);
    }
    if (path.points_m.empty() || path.period_s <= Real{0}) return pose;

    // The time between two points is in proportion to the way between them.
    std::vector<double> path_m{0.0};
    for (std::size_t i = 1; i < path.points_m.size(); ++i) {
        path_m.push_back(path_m.back() + static_cast<double>(glm::distance(path.points_m[i],
                                                                           path.points_m[i - 1])));
    }
    pose.position = path.points_m.front();
    if (path_m.back() <= 0.0) return pose;

    const double share = std::fmod(time_s / static_cast<double>(path.period_s), 1.0);
    const double there = share <= 0.5 ? 2.0 * share : 2.0 - 2.0 * share;
    const double done_m = there * path_m.back();
    std::size_t leg = 1;
    while (leg + 1 < path_m.size() && done_m > path_m[leg]) ++leg;
    const double leg_m = path_m[leg] - path_m[leg - 1];
    const double part =
        leg_m > 0.0 ? std::clamp((done_m - path_m[leg - 1]) / leg_m, 0.0, 1.0) : 1.0;
    const double eased = 0.5 - 0.5 * portable_cos(glm::pi<double>() * part);
    const Vec3& from = path.points_m[leg - 1];
    pose.position = from + (path.points_m[leg] - from) * static_cast<Real>(eased);
    return pose;
}

}  // namespace plumbline::scene

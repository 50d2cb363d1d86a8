#include "engine/scene/simulation.h"

#include "engine/core/hash.h"
#include "engine/core/limits.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/environment/sun_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace plumbline::scene {

namespace {

/// Below the share of its inner radius at which the physics sweeps a body: what speeds up within
/// the step is still seen.
constexpr Real kSweptShare = 0.9_r;
/// Slower turning than this the physics leaves without gyroscopic torque too.
constexpr Real kSpinning_radps = 1e-3_r;
/// Above it 16 sub-steps do not hold the heavier body up (docs/PHYSICS.md).
constexpr Real kWidestMassRatio = 1e4_r;

bool is_below(const std::optional<Real>& height_m, const Vec3& position) {
    return height_m && position.y < *height_m;
}

bool is_far_out(const Vec3& position) {
    const auto limit_m = static_cast<Real>(limits::kPosition_m);
    return glm::any(glm::greaterThan(glm::abs(position), Vec3{limit_m}));
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
      step_s_(physics.def().step_s),
      open_(std::make_shared<bool>(true)) {
    switches.textures = !description_.viewer;
    if (description_.sun) {
        const SunDescription& sun = *description_.sun;
        switches.sun_direction = Vec3f(sun.direction);
        switches.sun_rotation_radps = static_cast<float>(sun.rotation_radps);
    }

    registry.on_remove<BodyRef>([this, open = open_](ecs::Entity, BodyRef& ref) {
        if (!*open) return;
        physics.destroy_body(ref.body);
        bodies_destroyed_ = true;
        ++revision_;
    });
    registry.on_remove<Name>([this, open = open_](ecs::Entity entity, Name& name) {
        if (!*open) return;
        const auto known = entities_by_name_.find(name.text);
        if (known != entities_by_name_.end() && known->second == entity) {
            entities_by_name_.erase(known);
        }
        ++revision_;
    });
    builder_ = std::make_unique<EntityBuilder>(*this);
}

Simulation::~Simulation() {
    *open_ = false;
}

void Simulation::remember_poses() {
    registry.view<PreviousPlacement, const Placement>().each(
        [](ecs::Entity, PreviousPlacement& previous, const Placement& now) {
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
    physics.step();
    ++steps_;
    if (switches.sun_rotation_radps != 0.0F) {
        const float angle = switches.sun_rotation_radps * static_cast<float>(step_s_);
        const Vec3 up = description_.viewer ? description_.viewer->up : Vec3{0, 1, 0};
        // About the earth's axis the sky turns from east to west.
        const Vec3f axis = description_.time ? -sky_pole(*description_.time) : Vec3f(up);
        switches.sun_direction = glm::angleAxis(angle, axis) * switches.sun_direction;
    }
    sync_placements();
    report_quarantined();
    report_broken_joints();
    warn_of_mass_ratio();
}

void Simulation::set_hour(double hour) {
    if (description_.time) switches.sun_direction = Vec3f(-to_sun_at(*description_.time, hour));
}

std::optional<double> Simulation::hour() const {
    if (!description_.time) return {};
    return hour_of_sun(*description_.time, -switches.sun_direction);
}

std::uint64_t Simulation::step_at(double time_s) const {
    const double steps = std::max(0.0, (time_s - since_s_) / step_s_);
    return since_step_ + static_cast<std::uint64_t>(std::llround(steps));
}

void Simulation::set_accuracy(const physics::WorldDef& def) {
    since_s_ = time_s();
    since_step_ = steps_;
    step_s_ = def.step_s;
    physics.reconfigure(def);
}

void Simulation::destroy_marked() {
    registry.destroy_marked();
    forget_destroyed();
}

void Simulation::move_along_paths() {
    const double end_s = time_at(steps_ + 1);
    registry.view<const MotionPath, const BodyRef>().each(
        [&](ecs::Entity, const MotionPath& path, const BodyRef& ref) {
            physics.move_kinematic(ref.body, pose_on_path(path, end_s));
        });
}

void Simulation::sync_placements() {
    for (MovingBody& moving : moving_) {
        const physics::BodyState state = physics.state(moving.body);
        // A body that fell asleep in this step still moved in it.
        if (!state.awake && !moving.awake) continue;
        moving.awake = state.awake;
        registry.get<Placement>(moving.entity).world_from_body = state.world_from_body;
        const Vec3& position = state.world_from_body.position;
        if (moving.kind != physics::BodyKind::Dynamic) continue;
        if (is_below(description_.kill_below_m, position) || is_far_out(position)) {
            registry.mark_for_destruction(moving.entity);
            ++removed_;
        }
    }
}

void Simulation::report_quarantined() {
    const std::span<const physics::BodyId> quarantined = physics.quarantined();
    for (; quarantined_reported_ < quarantined.size(); ++quarantined_reported_) {
        const ecs::Entity entity = entity_of(quarantined[quarantined_reported_]);
        add_warning(
            fmt::format("{}: taken out of the simulation at {:.3f} s: its state was not finite",
                        describe(entity),
                        time_s()));
    }
}

/// Names the first touching pair whose masses differ by more than any number of sub-steps can hold.
void Simulation::warn_of_mass_ratio() {
    const auto mass_of = [&](physics::BodyId body) {
        return physics.contains(body) ? physics.mass_properties(body).mass_kg : Real{0};
    };
    if (weighed_revision_ != revision_) {
        weighed_revision_ = revision_;
        Real least = std::numeric_limits<Real>::max();
        Real most = 0;
        for (const MovingBody& moving : moving_) {
            if (moving.kind != physics::BodyKind::Dynamic) continue;
            least = std::min(least, mass_of(moving.body));
            most = std::max(most, mass_of(moving.body));
        }
        masses_differ_widely_ = most > kWidestMassRatio * least;
    }
    if (!masses_differ_widely_ || mass_ratio_named_) return;
    for (const physics::ContactEvent& touch : physics.all_contacts()) {
        const Real a = mass_of(touch.a);
        const Real b = mass_of(touch.b);
        if (a <= 0 || b <= 0 || std::max(a, b) <= kWidestMassRatio * std::min(a, b)) continue;
        mass_ratio_named_ = true;
        add_warning(
            fmt::format("{} and {} touch, {:.3g} kg and {:.3g} kg: above a mass ratio of "
                        "{:.0f} the lighter is pressed in",
                        describe(entity_of(touch.a)),
                        describe(entity_of(touch.b)),
                        a,
                        b,
                        kWidestMassRatio));
        return;
    }
}

void Simulation::forget_destroyed() {
    if (!bodies_destroyed_) return;
    bodies_destroyed_ = false;
    std::erase_if(moving_, [this](const MovingBody& moving) {
        return !registry.alive(moving.entity) || !physics.contains(moving.body);
    });
}

ecs::Entity Simulation::spawn(const EntityDescription& description) {
    std::string name;
    do {
        name = fmt::format("{}#{}", description.name, ++spawned_by_name_[description.name]);
    } while (entities_by_name_.contains(name));
    return respawn(description, name);
}

ecs::Entity Simulation::respawn(const EntityDescription& description, const std::string& name) {
    Result<ecs::Entity> made = builder_->build(description, name);
    if (!made) {
        add_warning(made.error().message);
        return {};
    }
    registry.add<Spawned>(*made, Spawned{.description = description.name});
    return *made;
}

ecs::Entity Simulation::entity_of(physics::BodyId body) const {
    return physics.contains(body) ? entity_of_mark(physics.user(body)) : ecs::Entity{};
}

ecs::Entity Simulation::entity_of_mark(std::uint64_t user) const {
    const ecs::Entity entity{static_cast<std::uint32_t>(user),
                             static_cast<std::uint32_t>(user >> 32U)};
    return registry.alive(entity) ? entity : ecs::Entity{};
}

ecs::Entity Simulation::find(std::string_view name) const {
    const auto known = entities_by_name_.find(name);
    return known == entities_by_name_.end() ? ecs::Entity{} : known->second;
}

std::string Simulation::name_of_mark(std::uint64_t user) const {
    const ecs::Entity entity = entity_of_mark(user);
    return registry.alive(entity) ? registry.get<Name>(entity).text : "player";
}

std::string Simulation::describe(ecs::Entity entity) const {
    if (!registry.alive(entity)) return "a body of the game";
    const std::string& name = registry.get<Name>(entity).text;
    const Source* source = registry.find<Source>(entity);
    if (source == nullptr) return "entity " + name;
    return fmt::format("entity {} ({}:{})", name, source->file, source->line);
}

std::uint64_t Simulation::state_hash() const {
    Hasher hasher;
    for (const MovingBody& moving : moving_) {
        if (!physics.contains(moving.body)) continue;
        const physics::BodyState state = physics.state(moving.body);
        const Vec3& p = state.world_from_body.position;
        const Quat& q = state.world_from_body.orientation;
        const Vec3& v = state.velocity_mps;
        const Vec3& w = state.angular_velocity_radps;
        const Real numbers[] = {p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z, w.x, w.y, w.z};
        hasher.add(numbers, sizeof numbers);
    }
    return hasher.digest();
}

void Simulation::update_motion_demand() {
    // small_step looks for contacts once a step, bullet_* in each of its parts.
    const physics::WorldDef& world = physics.def();
    const int looks = world.solver == physics::Solver::SmallStep ? 1 : world.substeps;
    const auto substep_s = static_cast<Real>(step_s_ / looks);
    MotionDemand demand;
    // Who is named stays named while it qualifies, so that the callers' list does not flicker.
    const auto name = [](ecs::Entity& named, ecs::Entity before, ecs::Entity entity) {
        if (!named || entity == before) named = entity;
    };
    Real fastest_mps{0};
    Real second_mps{0};
    ecs::Entity fastest{};
    for (const MovingBody& moving : moving_) {
        if (!physics.contains(moving.body)) continue;
        const bool is_dynamic = moving.kind == physics::BodyKind::Dynamic;
        if (is_dynamic && moving.ccd == physics::ContinuousCollision::On) {
            name(demand.swept, demand_.swept, moving.entity);
        }
        if (!moving.awake) continue;
        const physics::BodyState state = physics.state(moving.body);
        const Real speed_mps = glm::length(state.velocity_mps);
        if (speed_mps > fastest_mps) {
            second_mps = fastest_mps;
            fastest_mps = speed_mps;
            fastest = moving.entity;
        } else {
            second_mps = std::max(second_mps, speed_mps);
        }
        if (!is_dynamic) continue;
        if (moving.ccd == physics::ContinuousCollision::Auto &&
            speed_mps * substep_s > kSweptShare * moving.inner_radius_m) {
            name(demand.swept, demand_.swept, moving.entity);
        }
        if (!moving.spherical_inertia &&
            glm::length(state.angular_velocity_radps) > kSpinning_radps) {
            name(demand.spinning, demand_.spinning, moving.entity);
        }
    }
    // A light body that a heavy one strikes leaves at up to twice its speed, within the same step.
    for (const MovingBody& moving : moving_) {
        if (moving.kind != physics::BodyKind::Dynamic) continue;
        if (moving.ccd != physics::ContinuousCollision::Auto) continue;
        const Real other_mps = moving.entity == fastest ? second_mps : fastest_mps;
        if (Real{2} * other_mps * substep_s > kSweptShare * moving.inner_radius_m) {
            name(demand.swept, demand_.swept, moving.entity);
        }
    }
    demand_ = demand;
}

void Simulation::set_features(const physics::WorldFeatures& features) {
    features_ = features;
    physics.set_features(features);
}

void Simulation::request_contact_events(const std::string& who) {
    contact_listeners_.push_back(who);
    ++revision_;
}

void Simulation::release_contact_events(const std::string& who) {
    std::erase(contact_listeners_, who);
    ++revision_;
}

Pose pose_on_path(const MotionPath& path, double time_s) {
    Pose pose = path.start;
    const double turn_radps = static_cast<double>(glm::length(path.spin_radps));
    if (turn_radps > 0.0) {
        const double angle = std::fmod(turn_radps * time_s, 2.0 * glm::pi<double>());
        const Vec3 axis = path.spin_radps / static_cast<Real>(turn_radps);
        pose.orientation =
            glm::normalize(glm::angleAxis(static_cast<Real>(angle), axis) * pose.orientation);
    }
    if (path.points_m.empty() || path.period_s <= Real{0}) return pose;

    // The time between two points is in proportion to the way between them.
    std::vector<double> way_m{0.0};
    for (std::size_t i = 1; i < path.points_m.size(); ++i) {
        way_m.push_back(way_m.back() +
                        static_cast<double>(glm::distance(path.points_m[i], path.points_m[i - 1])));
    }
    pose.position = path.points_m.front();
    if (way_m.back() <= 0.0) return pose;

    const double share = std::fmod(time_s / static_cast<double>(path.period_s), 1.0);
    const double there = share <= 0.5 ? 2.0 * share : 2.0 - 2.0 * share;
    const double done_m = there * way_m.back();
    std::size_t leg = 1;
    while (leg + 1 < way_m.size() && done_m > way_m[leg]) ++leg;
    const double leg_m = way_m[leg] - way_m[leg - 1];
    const double part = leg_m > 0.0 ? std::clamp((done_m - way_m[leg - 1]) / leg_m, 0.0, 1.0) : 1.0;
    const double eased = 0.5 - 0.5 * std::cos(glm::pi<double>() * part);
    const Vec3& from = path.points_m[leg - 1];
    pose.position = from + (path.points_m[leg] - from) * static_cast<Real>(eased);
    return pose;
}

}  // namespace plumbline::scene

#include "engine/core/limits.h"
#include "engine/physics/query.h"
#include "engine/scene/build/array_copies.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/level/level_changes.h"
#include "engine/scene/sections/scene_parts.h"
#include "engine/scene/simulation.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/scene/simulation/scene_water.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::scene {

namespace {

/// Looking for penetration costs a query a body; beyond this many it would be felt at the start.
constexpr std::size_t kOverlapChecks = 2'000;
/// ... and each pair found costs another: who reads of so many needs no exact count.
constexpr std::size_t kOverlapsCounted = 1'000;
constexpr double kMostSwing_rad = 0.5;  ///< of a spring in a sub-step

std::size_t body_count_of(const SceneDescription& description) {
    std::size_t bodies = 0;
    for (const EntityDescription& entity : description.entities) bodies += entity.body ? 1U : 0U;
    for (const ArrayDescription& array : description.arrays) {
        bodies += array.prefab.body ? copies_of(array) : 0U;
    }
    return bodies;
}

Result<Done> build_array(const ArrayDescription& array, EntityBuilder& builder) {
    EntityDescription copy = array.prefab;
    Result<Done> built = Done{};
    visit_copies(array, [&](const std::string& name, const Pose& pose) {
        copy.world_from_body = pose;
        if (const Result<ecs::Entity> made = builder.build(copy, name); !made) built = made.error();
        return built.ok();
    });
    return built;
}

/// Bodies that start inside each other are thrown apart; whoever wrote the scene should know.
void warn_of_overlaps(Simulation& simulation) {
    const std::span<const MovingBody> moving = simulation.moving_bodies();
    if (moving.size() > kOverlapChecks) return;
    std::size_t pairs = 0;
    Real deepest_m = 0;
    std::string deepest;
    for (const MovingBody& body : moving) {
        if (pairs >= kOverlapsCounted) break;
        if (!body.convex || body.kind != physics::BodyKind::Dynamic) continue;
        const physics::BodyState own = simulation.physics.state(body.body);
        const Pose pose = own.world_from_body;
        const std::vector<physics::OverlapHit> hits = physics::overlaps(
            simulation.physics, body.shape, pose, Real{0}, {.ignored = body.body});
        for (const physics::OverlapHit& hit : hits) {
            if (hit.depth_m < std::max(0.005_r, 0.1_r * body.inner_radius_m)) continue;
            const physics::BodyState other = simulation.physics.state(hit.body);
            const bool seen_from_both =
                other.kind == physics::BodyKind::Dynamic && hit.body < body.body;
            if (seen_from_both || !may_touch(other.filter, own.filter)) continue;
            ++pairs;
            if (hit.depth_m <= deepest_m) continue;
            deepest_m = hit.depth_m;
            deepest = fmt::format("{} and {}",
                                  describe(simulation, body.entity),
                                  describe(simulation, entity_of(simulation, hit.body)));
        }
    }
    if (pairs == 0) return;
    simulation.warnings.push_back(
        fmt::format("{}{} {} interpenetrating; deepest of these: {}, by {:.3f} m",
                    pairs < kOverlapsCounted ? "" : "at least ",
                    pairs,
                    pairs == 1 ? "pair of bodies starts" : "pairs of bodies start",
                    deepest,
                    deepest_m));
}

/// Two of Bullet's solvers are known to lose joints; whoever chose one should know.
void warn_of_joints(Simulation& simulation) {
    if (simulation.joints().empty()) return;
    const physics::Solver solver = simulation.physics.def().solver;
    if (solver == physics::Solver::BulletNncg)
        simulation.warnings.push_back("bullet_nncg throws some joints between free bodies apart");
    if (solver == physics::Solver::BulletDantzig && simulation.joints().size() > 1)
        simulation.warnings.push_back(
            "bullet_dantzig throws off bodies that are held twice over, as by two hinges");
}

double inverse_mass_of(const Simulation& simulation, const std::string& name) {
    const BodyRef* ref = simulation.registry.find<BodyRef>(simulation.find(name));
    if (ref == nullptr) return 0;
    const Real mass_kg = simulation.physics.state(ref->body).mass.mass_kg;
    return mass_kg > 0 ? 1 / static_cast<double>(mass_kg) : 0;
}

/// A spring swings its bodies at the root of k / m. Where that turns far within the shortest sub-step, the
/// swing is slower than it should be or is not there at all.
void warn_of_stiff_springs(Simulation& simulation) {
    const physics::WorldDef& def = simulation.physics.def();
    const double shortest_s = def.step_s / std::max(def.substeps, def.substeps_max);
    for (const JointDescription& joint : simulation.description().joints) {
        if (joint.kind != JointKind::Spring) continue;
        const double inverse_kg = inverse_mass_of(simulation, joint.a) +
                                  (joint.b == "world" ? 0 : inverse_mass_of(simulation, joint.b));
        const double swing_radps = std::sqrt(static_cast<double>(joint.stiffness_Npm) * inverse_kg);
        if (swing_radps * shortest_s <= kMostSwing_rad) continue;
        const double most_Npm = whole_power(kMostSwing_rad / shortest_s, 2) / inverse_kg;
        simulation.warnings.push_back(fmt::format(
            "{}: joint {}: {:g} N/m swings its bodies faster than {:.0f} sub-steps a second "
            "can follow: it holds them, but swings slower or not at all; up to {:.3g} N/m they can",
            to_string(joint.location),
            joint.name,
            joint.stiffness_Npm,
            1 / shortest_s,
            most_Npm));
    }
}

void warn_of_lights(Simulation& simulation) {
    std::size_t lights = 0;
    simulation.registry.view<const PointLight>().each(
        [&](ecs::Entity, const PointLight&) { ++lights; });
    if (lights > limits::kLights) {
        simulation.warnings.push_back(fmt::format(
            "{} lights: only the {} nearest to the camera shine", lights, limits::kLights));
    }
}

/// Each in file order, as far as one is refused.
template <class T, class Add>
Result<Done> add_all(const std::vector<T>& list, const Add& add) {
    for (const T& each : list) {
        Result<Done> made = add(each);
        if (!made) return made;
    }
    return Done{};
}

/// What is more than one entity: waters in their basins, joints, and what bodies are held by.
Result<Done> add_wholes(Simulation& simulation, const SceneDescription& scene) {
    const ForceDescription& forces = scene.forces;
    Result<Done> made =
        add_all(forces.waters, [&](const auto& water) { return add_water(simulation, water); });
    if (made)
        made =
            add_all(scene.joints, [&](const auto& joint) { return simulation.add_joint(joint); });
    if (made)
        made = add_all(forces.ropes, [&](const auto& rope) { return simulation.add_rope(rope); });
    if (made)
        made =
            add_all(forces.cloths, [&](const auto& cloth) { return simulation.add_cloth(cloth); });
    if (made)
        made = add_all(forces.softs, [&](const auto& soft) { return simulation.add_soft(soft); });
    if (made)
        made = add_all(forces.vehicles,
                       [&](const auto& vehicle) { return simulation.add_vehicle(vehicle); });
    return made;
}

}  // namespace

Result<std::unique_ptr<Simulation>> build_simulation(const SceneDescription& described,
                                                     const SimulationOverrides& overrides,
                                                     assets::AssetLibrary& library,
                                                     const SurfaceTable& surfaces) {
    PL_ASSERT(!surfaces.surfaces.empty(), "a surface table with its default surface");
    SceneDescription staged;
    if (described.shows_model) {
        staged = described;
        if (const Result<Done> fits = fit_stage(staged, library); !fits) return fits.error();
    }
    const SceneDescription& description = described.shows_model ? staged : described;
    const std::size_t bodies = body_count_of(description);
    if (bodies > limits::kBodies) {
        return Error{fmt::format("{}: {} bodies; at most {} are allowed",
                                 description.file.generic_string(),
                                 bodies,
                                 limits::kBodies),
                     ExitCode::Refused};
    }
    auto simulation = std::make_unique<Simulation>(description, overrides, library, surfaces);
    if (bodies > limits::kBodiesWarn) {
        simulation->warnings.push_back(
            fmt::format("{} bodies: more than {} may be slow", bodies, limits::kBodiesWarn));
    }
    for (const EntityDescription& entity : description.entities) {
        const Result<ecs::Entity> made = simulation->builder().build(entity, entity.name);
        if (!made) return made.error();
    }
    for (const ArrayDescription& array : description.arrays) {
        const Result<Done> made = build_array(array, simulation->builder());
        if (!made) return made.error();
    }
    if (const Result<Done> made = add_wholes(*simulation, description); !made) return made.error();
    apply_changes(*simulation);
    warn_of_joints(*simulation);
    warn_of_stiff_springs(*simulation);
    warn_of_overlaps(*simulation);
    warn_of_lights(*simulation);
    return simulation;
}

}  // namespace plumbline::scene

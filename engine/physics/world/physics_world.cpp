#include "engine/physics/physics_world.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

struct SolverName {
    Solver solver;
    std::string_view name;
};
constexpr std::array<SolverName, 5> kSolverNames{{{Solver::SmallStep, "small_step"},
                                                  {Solver::BulletSi, "bullet_si"},
                                                  {Solver::BulletNncg, "bullet_nncg"},
                                                  {Solver::BulletDantzig, "bullet_dantzig"},
                                                  {Solver::BulletPgs, "bullet_pgs"}}};

}  // namespace

std::string_view solver_name(Solver solver) {
    for (const SolverName& entry : kSolverNames) {
        if (entry.solver == solver) return entry.name;
    }
    return "";
}

std::optional<Solver> solver_from_name(std::string_view name) {
    for (const SolverName& entry : kSolverNames) {
        if (entry.name == name) return entry.solver;
    }
    return std::nullopt;
}

BodyRecord& WorldState::body(BodyId id) const {
    return *bodies.get(id);
}

WorldOwner::WorldOwner(const WorldDef& def) : state_(std::make_unique<WorldState>(def)) {}
WorldOwner::~WorldOwner() = default;

PhysicsWorld::PhysicsWorld(const WorldDef& def)
    : WorldOwner(def),
      WorldBodies(*state_),
      WorldJoints(*state_),
      WorldQueries(*state_),
      WorldReport(*state_) {}
PhysicsWorld::~PhysicsWorld() = default;

Result<ShapeId> PhysicsWorld::create_shape(const ShapeDef& def, std::vector<std::string>* notes) {
    return state_->shapes.create(def, notes);
}

void PhysicsWorld::set_features(const WorldFeatures& features) {
    state_->features = features;
}
const WorldDef& PhysicsWorld::def() const {
    return state_->def;
}
std::size_t WorldBodies::body_count() const {
    return world_.bodies.size();
}
std::span<const ContactEvent> WorldReport::contacts() const {
    return world_.events;
}
void Interventions::add(const Interventions& more) {
    braked_J += more.braked_J;
    braked_islands += more.braked_islands;
    clamped_bodies += more.clamped_bodies;
    unresolved_islands += more.unresolved_islands;
    restored_islands += more.restored_islands;
    limited_bodies += more.limited_bodies;
    impacts += more.impacts;
    oversized_islands += more.oversized_islands;
    left_out_pairs += more.left_out_pairs;
}
const StepCost& WorldReport::cost() const {
    return world_.cost;
}
const FeatureUse& WorldReport::feature_use() const {
    return world_.use;
}
std::span<const IslandReport> WorldReport::islands() const {
    if (!world_.small) return {};
    return world_.small->reports;
}
std::span<const BodyId> WorldReport::quarantined() const {
    return world_.quarantined;
}

// --- totals

Energy WorldReport::energy() const {
    const Vec3d gravity{world_.def.gravity_mps2};
    Energy sum;
    world_.bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (!pushable(*record)) return;
        const Transform at = record->motion->at;
        const Vec3d v{record->motion->velocity_mps};
        const Vec3d spin{unrotated(record->motion->spin_radps, at.rotation)};
        sum.kinetic_J += 0.5 * record->traits.mass_kg * glm::dot(v, v) +
                         0.5 * glm::dot(record->traits.inertia_kgm2, spin * spin);
        sum.potential_J -= record->traits.mass_kg * glm::dot(gravity, Vec3d{at.position_m});
    });
    sum.potential_J += elastic_energy_J(world_.joints);
    return sum;
}

Vec3d WorldReport::momentum_kgmps() const {
    Vec3d sum{0, 0, 0};
    world_.bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (pushable(*record)) sum += record->traits.mass_kg * Vec3d{record->motion->velocity_mps};
    });
    return sum;
}

Vec3d WorldReport::angular_momentum_kgm2ps() const {
    Vec3d sum{0, 0, 0};
    world_.bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (!pushable(*record)) return;
        const Transform at = record->motion->at;
        const Vec3d v{record->motion->velocity_mps};
        const Vec3d body_spin{unrotated(record->motion->spin_radps, at.rotation)};
        const Vec3 own = at.rotation * Vec3{record->traits.inertia_kgm2 * body_spin};
        sum += record->traits.mass_kg * glm::cross(Vec3d{at.position_m}, v) + Vec3d{own};
    });
    return sum;
}

double WorldReport::max_penetration_m() const {
    double deepest = 0;
    world_.engine->each_manifold([&deepest](const Manifold& manifold) {
        for (const ManifoldPoint& point : manifold.points)
            deepest = std::max(deepest, -static_cast<double>(point.distance_m));
    });
    return deepest;
}

int most_substeps(const PhysicsWorld& world) {
    int most = world.def().substeps;
    for (const IslandReport& island : world.islands()) most = std::max(most, island.substeps);
    return most;
}

}  // namespace plumbline::physics

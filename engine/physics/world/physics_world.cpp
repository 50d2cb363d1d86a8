#include "engine/physics/physics_world.h"

#include "engine/physics/world/world_state.h"

#include <array>

namespace plumbline::physics {
namespace {

/// In the order of kSolvers.
constexpr std::array<std::string_view, kSolvers.size()> kSolverNames{
    "small_step", "bullet_si", "bullet_nncg", "bullet_dantzig", "bullet_pgs"};

}  // namespace

std::string_view solver_name(Solver solver) {
    return kSolverNames[static_cast<std::size_t>(solver)];
}

std::optional<Solver> solver_from_name(std::string_view name) {
    for (const Solver solver : kSolvers) {
        if (solver_name(solver) == name) return solver;
    }
    return std::nullopt;
}

BodyRecord& WorldState::body(BodyId id) const {
    return *bodies.get(id);
}

PhysicsWorld::PhysicsWorld(const WorldDef& def) : state_(std::make_unique<WorldState>(def)) {}
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

const StepReport& PhysicsWorld::report() const {
    return state_->report;
}

const WorldState& internals(const PhysicsWorld& world) {
    return *world.state_;
}

}  // namespace plumbline::physics

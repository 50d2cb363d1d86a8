// A world's engine: built, and built anew when the solver, the rate or gravity changes.
#include "engine/physics/world/world_state.h"

#include <cmath>

namespace plumbline::physics {
namespace {

Real kept_after(double damping_per_s, double duration_s) {
    return static_cast<Real>(portable_exp(-damping_per_s * duration_s));
}

void check_def(const WorldDef& def) {
    PL_ASSERT(def.step_s > 0 && std::isfinite(def.step_s), "a positive step");
    PL_ASSERT(def.substeps >= 1 && def.iterations >= 1, "at least one substep and iteration");
    PL_ASSERT(is_finite(def.gravity_mps2), "finite gravity");
}

/// Between small_step's rates, and between Bullet's solvers and rates: contacts and joints go on with
/// the mean forces that they carried, in steps of any length.
void change_in_place(WorldState& world, const WorldDef& def) {
    check_def(def);
    const WorldDef before = world.def;
    world.def = def;
    if (world.small)
        world.small->take_rate();
    else
        world.engine->change(before, def);
    world.bodies.each([&](BodyId, std::unique_ptr<BodyRecord>& record) {
        suit_to_world(world.def, *record);
        if (world.def.gravity_mps2 != before.gravity_mps2 && record->in_world) world.wake(*record);
    });
}

}  // namespace

WorldState::WorldState(const WorldDef& world_def) {
    build_engine(world_def);
}

void WorldState::build_engine(const WorldDef& world_def) {
    check_def(world_def);
    def = world_def;
    report.islands.clear();
    engine = std::make_unique<BulletEngine>(def, report);
    if (def.solver == Solver::SmallStep) {
        small = std::make_unique<SmallStepWorld>(SmallStepParts{
            .def = def, .engine = *engine, .bodies = bodies, .joints = joints, .report = report});
        small->after_solve = [this] { gather_events(*this, false, gathered); };
    }
}

void WorldState::take_engine_down() {
    joints.each([](JointId, std::unique_ptr<JointRecord>& joint) { joint->bullet.reset(); });
    bodies.each([this](BodyId, std::unique_ptr<BodyRecord>& record) {
        if (record->in_world) engine->remove(*record);
    });
    small.reset();
    engine.reset();
}

WorldState::~WorldState() {
    take_engine_down();
}

void suit_to_world(const WorldDef& def, BodyRecord& record) {
    BodyTraits& traits = record.traits;
    const double duration_s =
        def.solver == Solver::SmallStep ? def.step_s : def.step_s / def.substeps;
    traits.linear_damping_factor = kept_after(traits.linear_damping_per_s, duration_s);
    traits.angular_damping_factor = kept_after(traits.angular_damping_per_s, duration_s);
    if (record.kind == BodyKind::Dynamic) {
        traits.weight_N =
            def.gravity_mps2 * traits.gravity_factor * static_cast<Real>(traits.mass_kg);
    }
}

void PhysicsWorld::reconfigure(const WorldDef& def) {
    WorldState& world = *state_;
    const bool was_small = world.small != nullptr;
    if (was_small == (def.solver == Solver::SmallStep)) return change_in_place(world, def);
    // Neither side's contacts mean anything to the other. Bodies go through the state that callers see, as if they were made from it: no digit of
    // Bullet's own numbers may survive.
    std::vector<BodyState> states;
    world.bodies.each(
        [&](BodyId id, const std::unique_ptr<BodyRecord>&) { states.push_back(state(id)); });
    world.take_engine_down();
    world.build_engine(def);
    world.report.contacts.clear();

    auto kept = states.begin();
    world.bodies.each([&](BodyId id, std::unique_ptr<BodyRecord>& record) {
        const BodyState& body_state = *kept++;
        suit_to_world(def, *record);
        record->small.substeps = record->small.substeps_held = 0;
        record->small.rest = {};
        if (!record->in_world) return;
        record->in_world = false;
        const Transform target = record->drive.target;
        const bool driven = record->drive.driven;
        world.place(*record, world_from_mass(*record, body_state.world_from_body));
        world.enter_world(*record);
        set_velocity(id, body_state.velocity_mps, body_state.angular_velocity_radps);
        if (record->drive.has_target) record->drive.target = target;
        record->drive.driven = driven;
    });
    world.joints.each([&world](JointId, std::unique_ptr<JointRecord>& joint) {
        joint->solver.bound_load = {};
        joint->solver.mean_load = {};
        joint->solver.elastic_speed = {};
        if (joint->state.broken || world.small) return;
        joint->bullet = std::make_unique<BulletJoint>(*joint, world.engine->world());
    });
}

}  // namespace plumbline::physics

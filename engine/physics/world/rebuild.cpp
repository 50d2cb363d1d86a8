// A world's engine: built, and built anew when the solver, the rate or gravity changes.
#include "engine/physics/world/world_state.h"

#include <cmath>

namespace plumbline::physics {
namespace {

Real kept_after(double damping_per_s, double duration_s) {
    return static_cast<Real>(std::exp(-damping_per_s * duration_s));
}

}  // namespace

PhysicsWorld::Impl::Impl(const WorldDef& world_def) : def(world_def) {
    check_def();
    build_engine();
}

void PhysicsWorld::Impl::check_def() const {
    PL_ASSERT(def.step_s > 0 && std::isfinite(def.step_s), "a positive step");
    PL_ASSERT(def.substeps >= 1 && def.iterations >= 1, "at least one substep and iteration");
    PL_ASSERT(is_finite(def.gravity_mps2), "finite gravity");
}

void PhysicsWorld::Impl::build_engine() {
    bullet_joints = def.solver != Solver::SmallStep;
    engine = std::make_unique<BulletEngine>(def, cost);
    if (def.solver == Solver::SmallStep) {
        small = std::make_unique<SmallStepWorld>(
            SmallStepParts{.def = def, .engine = *engine, .joints = joints});
        small->after_solve = [this] { gather_events(false, gathered); };
    }
}

void PhysicsWorld::Impl::take_engine_down() {
    joints.each([](JointId, std::unique_ptr<JointRecord>& joint) { joint->bullet.reset(); });
    bodies.each([this](BodyId, std::unique_ptr<BodyRecord>& record) {
        if (record->in_world) engine->remove(*record);
    });
    small.reset();
    engine.reset();
}

PhysicsWorld::Impl::~Impl() {
    take_engine_down();
}

void PhysicsWorld::Impl::suit_to_world(BodyRecord& record) const {
    const double duration_s = small ? def.step_s : def.step_s / def.substeps;
    record.traits.linear_damping_factor =
        kept_after(record.traits.linear_damping_per_s, duration_s);
    record.traits.angular_damping_factor =
        kept_after(record.traits.angular_damping_per_s, duration_s);
    if (record.kind == BodyKind::Dynamic) {
        record.traits.weight_N = def.gravity_mps2 * record.traits.linear_factor *
                                 static_cast<Real>(record.traits.mass_kg);
    }
}

/// What contacts and joints carry is kept as mean forces, which fit steps of any length.
void PhysicsWorld::Impl::change_rate(const WorldDef& changed) {
    const bool other_gravity = changed.gravity_mps2 != def.gravity_mps2;
    def = changed;
    check_def();
    small->take_rate();
    bodies.each([&](BodyId, std::unique_ptr<BodyRecord>& record) {
        suit_to_world(*record);
        if (other_gravity && record->in_world) wake(*record);
    });
}

void PhysicsWorld::reconfigure(const WorldDef& def) {
    Impl& impl = *impl_;
    if (impl.small && def.solver == Solver::SmallStep) return impl.change_rate(def);
    // Bodies go through the state that callers see, as if they were made from it: no digit of
    // Bullet's own numbers may survive.
    std::vector<BodyState> states;
    impl.bodies.each(
        [&](BodyId id, const std::unique_ptr<BodyRecord>&) { states.push_back(state(id)); });
    impl.take_engine_down();
    impl.def = def;
    impl.check_def();
    impl.build_engine();
    impl.events.clear();

    auto kept = states.begin();
    impl.bodies.each([&](BodyId id, std::unique_ptr<BodyRecord>& record) {
        const BodyState& body_state = *kept++;
        impl.suit_to_world(*record);
        record->small.substeps = record->small.substeps_held = 0;
        record->small.rest = {};
        if (!record->in_world) return;
        record->in_world = false;
        const Transform target = record->drive.target;
        const bool driven = record->drive.driven;
        impl.place(*record, impl.world_from_mass(*record, body_state.world_from_body));
        impl.enter_world(*record);
        set_velocity(id, body_state.velocity_mps, body_state.angular_velocity_radps);
        if (record->drive.has_target) record->drive.target = target;
        record->drive.driven = driven;
    });
    impl.joints.each([&impl](JointId, std::unique_ptr<JointRecord>& joint) {
        joint->solver.bounded_impulse = {};
        joint->solver.impulse = {};
        if (joint->state.broken || !impl.bullet_joints) return;
        joint->bullet = std::make_unique<BulletJoint>(*joint, impl.engine->world());
    });
}

}  // namespace plumbline::physics

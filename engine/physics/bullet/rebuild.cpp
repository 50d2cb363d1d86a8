// The Bullet side of a world: built, and built anew when the solver, the rate or gravity changes.
#include "engine/physics/bullet/contact_copy.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/counting_solver.h"
#include "engine/physics/bullet/joints.h"
#include "engine/physics/world/small_step_world.h"
#include "engine/physics/world/world_state.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>
#include <LinearMath/btAlignedAllocator.h>

#include <cmath>
#include <cstdlib>
#include <new>

namespace plumbline::physics {
namespace {

// Bullet does not look whether it got the memory that it asked for.
void* allocate_or_throw(std::size_t bytes) {
    void* memory = std::malloc(bytes);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

/// Its own solvers get materials combined, and all of Bullet its memory, through global function
/// pointers, for every world of the process. Setting them again to the same functions is harmless.
void install_global_callbacks() {
    btAlignedAllocSetCustom(allocate_or_throw, std::free);
    using Object = btCollisionObject;
    gCalculateCombinedFrictionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).friction;
    };
    gCalculateCombinedRestitutionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).restitution;
    };
    gCalculateCombinedRollingFrictionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).rolling_m;
    };
    gCalculateCombinedSpinningFrictionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).spinning_m;
    };
}

/// Groups must agree both ways, something must be able to give way, and no joint forbids it.
class PairFilter final : public btOverlapFilterCallback {
public:
    bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
        const auto& object_a = *static_cast<const btCollisionObject*>(a->m_clientObject);
        const auto& object_b = *static_cast<const btCollisionObject*>(b->m_clientObject);
        if (object_a.isStaticOrKinematicObject() && object_b.isStaticOrKinematicObject()) {
            return false;
        }
        const BodyRecord& record_a = record_of(object_a);
        const BodyRecord& record_b = record_of(object_b);
        return (record_a.group & record_b.collides_with) != 0 &&
               (record_b.group & record_a.collides_with) != 0 && !kept_apart(record_a, record_b);
    }
};

btScalar kept_after(double damping_per_s, double duration_s) {
    return static_cast<btScalar>(std::exp(-damping_per_s * duration_s));
}

}  // namespace

PhysicsWorld::Impl::Impl(const WorldDef& world_def) : def(world_def) {
    install_global_callbacks();
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
    configuration = std::make_unique<btDefaultCollisionConfiguration>();
    if (def.solver == Solver::SmallStep) {
        dispatcher = std::make_unique<PairDispatcher>(configuration.get());
        box_contacts = std::make_unique<BoxContacts>(*dispatcher);
        pairs = std::make_unique<PairList>(*dispatcher);
    } else {
        dispatcher = std::make_unique<btCollisionDispatcher>(configuration.get());
        pairs = std::make_unique<btHashedOverlappingPairCache>();
    }
    mesh_contacts = std::make_unique<MeshContacts>(*dispatcher);
    pair_filter = std::make_unique<PairFilter>();
    pairs->setOverlapFilterCallback(pair_filter.get());
    broadphase = std::make_unique<btDbvtBroadphase>(pairs.get());
    build_solver();
    world = std::make_unique<StepWorld>(
        dispatcher.get(), broadphase.get(), solver.get(), configuration.get(), def.gravity_mps2);
    world->getSolverInfo().m_numIterations = def.iterations;
    if (pivot_solver) {
        // The matrix grows with the square of a batch: one island at a time.
        world->getSolverInfo().m_minimumSolverBatchSize = 1;
    }
    world->after_solve = [this] { gather_events(false, gathered); };
    if (def.solver == Solver::SmallStep) {
        small = std::make_unique<SmallStepWorld>(
            SmallStepParts{.def = def,
                           .world = *world,
                           .dispatcher = static_cast<PairDispatcher&>(*dispatcher),
                           .pairs = static_cast<PairList&>(*pairs),
                           .joints = joints});
        small->after_solve = world->after_solve;
    }
}

void PhysicsWorld::Impl::build_solver() {
    // The solver counts into the world's cost, which does not exist yet: into ours, then.
    switch (def.solver) {
        case Solver::SmallStep:
        case Solver::BulletSi: {
            auto made = std::make_unique<CountingSolver<btSequentialImpulseConstraintSolver>>(cost);
            made->setRandSeed(def.seed);
            solver = std::move(made);
            break;
        }
        case Solver::BulletNncg: {
            auto made = std::make_unique<CountingSolver<btNNCGConstraintSolver>>(cost);
            made->setRandSeed(def.seed);
            solver = std::move(made);
            break;
        }
        case Solver::BulletDantzig:
            pivot_solver = std::make_unique<btDantzigSolver>();
            solver = std::make_unique<CountingMatrixSolver>(cost, pivot_solver.get(), 1);
            break;
        case Solver::BulletPgs:
            pivot_solver = std::make_unique<btSolveProjectedGaussSeidel>();
            solver =
                std::make_unique<CountingMatrixSolver>(cost, pivot_solver.get(), def.iterations);
            break;
    }
}

void PhysicsWorld::Impl::take_engine_down() {
    joints.each([](JointId, std::unique_ptr<JointRecord>& joint) { joint->bullet.reset(); });
    bodies.each([this](BodyId, std::unique_ptr<BodyRecord>& record) {
        if (record->in_world) world->removeRigidBody(record->rigid.get());
    });
    small.reset();
    world.reset();
    solver.reset();
    pivot_solver.reset();
    broadphase.reset();
    pairs.reset();
    pair_filter.reset();
    dispatcher.reset();
    mesh_contacts.reset();
    box_contacts.reset();
    configuration.reset();
}

PhysicsWorld::Impl::~Impl() {
    take_engine_down();
}

void PhysicsWorld::Impl::suit_to_world(BodyRecord& record) const {
    const double duration_s = small ? def.step_s : def.step_s / def.substeps;
    record.linear_keep = kept_after(record.linear_damping_per_s, duration_s);
    record.angular_keep = kept_after(record.angular_damping_per_s, duration_s);
    if (record.kind == BodyKind::Dynamic) {
        record.weight_N = to_bullet(def.gravity_mps2 * record.linear_factor) *
                          static_cast<btScalar>(record.mass_kg);
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
        record->substeps = record->substeps_held = 0;
        record->rest = {};
        if (!record->in_world) return;
        record->in_world = false;
        const btTransform target = record->target;
        const bool driven = record->driven;
        impl.place(*record, impl.world_from_mass(*record, body_state.world_from_body));
        impl.enter_world(*record);
        set_velocity(id, body_state.velocity_mps, body_state.angular_velocity_radps);
        if (record->has_target) record->target = target;
        record->driven = driven;
    });
    impl.joints.each([&impl](JointId, std::unique_ptr<JointRecord>& joint) {
        joint->solver.bounded_impulse = {};
        joint->solver.impulse = {};
        if (joint->state.broken || !impl.bullet_joints) return;
        joint->bullet = std::make_unique<BulletJoint>(*joint, *impl.world);
    });
}

}  // namespace plumbline::physics

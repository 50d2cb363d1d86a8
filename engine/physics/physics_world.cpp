#include "engine/physics/physics_world.h"

#include "engine/physics/bullet_convert_impl.h"
#include "engine/physics/counting_solver_impl.h"
#include "engine/physics/physics_world_impl.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

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

// Bullet combines materials through four global function pointers, for every world of the process.
// Setting them again to the same functions is harmless, so each world does it.
btScalar combined_friction(const btCollisionObject* a, const btCollisionObject* b) {
    return std::sqrt(a->getFriction() * b->getFriction());
}
btScalar combined_restitution(const btCollisionObject* a, const btCollisionObject* b) {
    return std::max(a->getRestitution(), b->getRestitution());
}
// A ball's own resistance holds on any ground, so one side's coefficient is enough.
btScalar combined_rolling_friction(const btCollisionObject* a, const btCollisionObject* b) {
    return std::max(a->getRollingFriction(), b->getRollingFriction());
}
btScalar combined_spinning_friction(const btCollisionObject* a, const btCollisionObject* b) {
    return std::max(a->getSpinningFriction(), b->getSpinningFriction());
}

void install_global_callbacks() {
    gCalculateCombinedFrictionCallback = combined_friction;
    gCalculateCombinedRestitutionCallback = combined_restitution;
    gCalculateCombinedRollingFrictionCallback = combined_rolling_friction;
    gCalculateCombinedSpinningFrictionCallback = combined_spinning_friction;
}

/// Groups must agree both ways, something must be able to give way, and no joint forbids it.
class PairFilter final : public btOverlapFilterCallback {
public:
    explicit PairFilter(const ExemptPairs& exempt) : exempt_(exempt) {}

    bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
        const auto& object_a = *static_cast<const btCollisionObject*>(a->m_clientObject);
        const auto& object_b = *static_cast<const btCollisionObject*>(b->m_clientObject);
        if (object_a.isStaticOrKinematicObject() && object_b.isStaticOrKinematicObject()) {
            return false;
        }
        const BodyRecord& record_a = record_of(object_a);
        const BodyRecord& record_b = record_of(object_b);
        return (record_a.group & record_b.collides_with) != 0 &&
               (record_b.group & record_a.collides_with) != 0 &&
               !exempt_.contains(record_a.id, record_b.id);
    }

private:
    const ExemptPairs& exempt_;
};

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

PhysicsWorld::Impl::Impl(const WorldDef& world_def) : def(world_def) {
    PL_ASSERT(def.step_s > 0 && std::isfinite(def.step_s), "a positive step");
    PL_ASSERT(def.substeps >= 1 && def.iterations >= 1, "at least one substep and iteration");
    PL_ASSERT(is_finite(def.gravity_mps2), "finite gravity");
    install_global_callbacks();

    configuration = std::make_unique<btDefaultCollisionConfiguration>();
    dispatcher = std::make_unique<btCollisionDispatcher>(configuration.get());
    mesh_contacts = std::make_unique<MeshContacts>(*dispatcher);
    pair_filter = std::make_unique<PairFilter>(exempt_pairs);
    pairs = std::make_unique<btHashedOverlappingPairCache>();
    pairs->setOverlapFilterCallback(pair_filter.get());
    broadphase = std::make_unique<btDbvtBroadphase>(pairs.get());

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
    world = std::make_unique<StepWorld>(
        dispatcher.get(), broadphase.get(), solver.get(), configuration.get(), def.gravity_mps2);
    world->getSolverInfo().m_numIterations = def.iterations;
    if (pivot_solver) {
        // The matrix grows with the square of a batch: one island at a time.
        world->getSolverInfo().m_minimumSolverBatchSize = 1;
    }
    world->after_solve = [this] { gather_events(false, gathered); };
}

PhysicsWorld::Impl::~Impl() {
    bodies.each([this](BodyId, std::unique_ptr<BodyRecord>& record) {
        if (record->in_world) world->removeRigidBody(record->rigid.get());
    });
}

BodyRecord& PhysicsWorld::Impl::body(BodyId id) {
    return *bodies.get(id);
}
const BodyRecord& PhysicsWorld::Impl::body(BodyId id) const {
    return *bodies.get(id);
}

PhysicsWorld::PhysicsWorld(const WorldDef& def) : impl_(std::make_unique<Impl>(def)) {}
PhysicsWorld::~PhysicsWorld() = default;

Result<ShapeId> PhysicsWorld::create_shape(const ShapeDef& def, std::vector<std::string>* notes) {
    auto built = build_shape(def, notes);
    if (!built) return built.error();
    return impl_->shapes.insert(std::move(built.value()));
}

void PhysicsWorld::set_features(const WorldFeatures& features) {
    impl_->features = features;
}
const WorldDef& PhysicsWorld::def() const {
    return impl_->def;
}
std::size_t PhysicsWorld::body_count() const {
    return impl_->bodies.size();
}
std::span<const ContactEvent> PhysicsWorld::contacts() const {
    return impl_->events;
}
const StepCost& PhysicsWorld::cost() const {
    return impl_->cost;
}
const FeatureUse& PhysicsWorld::feature_use() const {
    return impl_->use;
}
std::span<const BodyId> PhysicsWorld::quarantined() const {
    return impl_->quarantined;
}

// --- totals

Energy PhysicsWorld::energy() const {
    const Vec3d gravity{impl_->def.gravity_mps2};
    Energy sum;
    impl_->bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (record->kind != BodyKind::Dynamic || !record->in_world || record->frozen) return;
        const btRigidBody& rigid = *record->rigid;
        const Vec3d v = double_from_bullet(rigid.getLinearVelocity());
        const Vec3d spin =
            double_from_bullet(rigid.getAngularVelocity() * rigid.getWorldTransform().getBasis());
        const Vec3d x = double_from_bullet(rigid.getWorldTransform().getOrigin());
        sum.kinetic_J += 0.5 * record->mass_kg * glm::dot(v, v) +
                         0.5 * glm::dot(record->inertia_kgm2, spin * spin);
        sum.potential_J -= record->mass_kg * glm::dot(gravity, x);
    });
    sum.potential_J += impl_->elastic_energy_J();
    return sum;
}

Vec3d PhysicsWorld::momentum_kgmps() const {
    Vec3d sum{0, 0, 0};
    impl_->bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (record->kind != BodyKind::Dynamic || !record->in_world || record->frozen) return;
        sum += record->mass_kg * double_from_bullet(record->rigid->getLinearVelocity());
    });
    return sum;
}

Vec3d PhysicsWorld::angular_momentum_kgm2ps() const {
    Vec3d sum{0, 0, 0};
    impl_->bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (record->kind != BodyKind::Dynamic || !record->in_world || record->frozen) return;
        const btTransform& at = record->rigid->getWorldTransform();
        const Vec3d x = double_from_bullet(at.getOrigin());
        const Vec3d v = double_from_bullet(record->rigid->getLinearVelocity());
        const Vec3d body_spin =
            double_from_bullet(record->rigid->getAngularVelocity() * at.getBasis());
        const btVector3 own = at.getBasis() * bullet_from_double(record->inertia_kgm2 * body_spin);
        sum += record->mass_kg * glm::cross(x, v) + double_from_bullet(own);
    });
    return sum;
}

double PhysicsWorld::max_penetration_m() const {
    double deepest = 0;
    for (int i = 0; i < impl_->dispatcher->getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *impl_->dispatcher->getManifoldByIndexInternal(i);
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            deepest =
                std::max(deepest, -static_cast<double>(manifold.getContactPoint(p).getDistance()));
        }
    }
    return deepest;
}

}  // namespace plumbline::physics

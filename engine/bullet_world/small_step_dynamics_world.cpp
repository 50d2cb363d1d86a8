#include "engine/bullet_world/small_step_dynamics_world.h"

#include "engine/bullet_world/contact_copies.h"
#include "engine/bullet_world/left_constraints.h"
#include "engine/bullet_world/mirrored_bodies.h"
#include "engine/bullet_world/mirrored_joints.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

namespace plumbline {
namespace {

/// What Bullet's filters, ignore lists and material functions say.
class BulletRules final : public physics::PairRules {
public:
    explicit BulletRules(btCollisionWorld& world) : world_(world) {}

    bool may_touch(std::uint64_t user_a, std::uint64_t user_b) const override {
        btCollisionObject& a = *bullet_world::mirror_of(user_a).object;
        btCollisionObject& b = *bullet_world::mirror_of(user_b).object;
        return a.hasContactResponse() && b.hasContactResponse() && a.checkCollideWith(&b) &&
               b.checkCollideWith(&a) &&
               world_.getPairCache()->needsBroadphaseCollision(a.getBroadphaseHandle(),
                                                               b.getBroadphaseHandle()) &&
               ((!a.isActive() && !b.isActive()) || world_.getDispatcher()->needsCollision(&a, &b));
    }
    physics::Material combined(std::uint64_t user_a, std::uint64_t user_b) const override {
        const btCollisionObject* a = bullet_world::mirror_of(user_a).object;
        const btCollisionObject* b = bullet_world::mirror_of(user_b).object;
        const btScalar restitution = gCalculateCombinedRestitutionCallback(a, b);
        return {.friction = std::max(gCalculateCombinedFrictionCallback(a, b), btScalar(0)),
                .restitution = std::clamp(restitution, btScalar(0), btScalar(1)),
                .rolling_m = gCalculateCombinedRollingFrictionCallback(a, b),
                .spinning_m = gCalculateCombinedSpinningFrictionCallback(a, b)};
    }

private:
    btCollisionWorld& world_;
};

}  // namespace

struct SmallStepDynamicsWorld::Parts {
    explicit Parts(btDiscreteDynamicsWorld& world)
        : rules(world),
          bodies(world, notes),
          joints(bodies, notes),
          left(bodies, notes),
          contacts(world, bodies),
          physics(
              {.gravity_mps2 = bullet_world::vec_of(world.getGravity()), .pair_rules = &rules}) {}

    /// Rate, sub-steps and gravity of the coming step.
    void adopt(const btVector3& gravity_mps2, btScalar step_s) {
        physics::WorldDef def = physics.def();
        const physics::WorldDef before = def;
        def.gravity_mps2 = bullet_world::vec_of(gravity_mps2);
        def.step_s = static_cast<double>(step_s);
        def.substeps = std::max(substeps.least, 1);
        def.substeps_max = substeps.most;
        if (def.gravity_mps2 != before.gravity_mps2 || def.step_s != before.step_s ||
            def.substeps != before.substeps || def.substeps_max != before.substeps_max)
            physics.reconfigure(def);
    }

    BulletRules rules;
    bullet_world::Notes notes;
    bullet_world::MirroredBodies bodies;
    bullet_world::MirroredJoints joints;
    bullet_world::LeftConstraints left;
    bullet_world::ContactCopies contacts;
    physics::PhysicsWorld physics;
    SubstepRange substeps{};
    std::vector<btTypedConstraint*> left_constraints;
    bool detected_by_bullet{false};  ///< its pairs have manifolds of its own
};

SmallStepDynamicsWorld::SmallStepDynamicsWorld(btDispatcher* dispatcher,
                                               btBroadphaseInterface* broadphase,
                                               btConstraintSolver* solver,
                                               btCollisionConfiguration* configuration)
    : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration),
      parts_(std::make_unique<Parts>(*this)) {}

SmallStepDynamicsWorld::~SmallStepDynamicsWorld() {
    parts_->contacts.clear();
}

void SmallStepDynamicsWorld::set_substeps(const SubstepRange& range) {
    parts_->substeps = range;
}

const physics::PhysicsWorld& SmallStepDynamicsWorld::physics() const {
    return parts_->physics;
}

const std::vector<std::string>& SmallStepDynamicsWorld::notes() const {
    return parts_->notes.all();
}

void SmallStepDynamicsWorld::forget(btCollisionObject& object) {
    parts_->contacts.forget(object);
    parts_->bodies.remove(parts_->physics, object);
}

void SmallStepDynamicsWorld::removeRigidBody(btRigidBody* body) {
    forget(*body);
    btDiscreteDynamicsWorld::removeRigidBody(body);
}

void SmallStepDynamicsWorld::removeCollisionObject(btCollisionObject* object) {
    if (btRigidBody::upcast(object) == nullptr) forget(*object);
    btDiscreteDynamicsWorld::removeCollisionObject(
        object);  // ... by removeRigidBody(), if it is one
}

void SmallStepDynamicsWorld::removeConstraint(btTypedConstraint* constraint) {
    parts_->joints.remove(parts_->physics, *constraint);
    btDiscreteDynamicsWorld::removeConstraint(constraint);
}

void SmallStepDynamicsWorld::applyGravity() {
    btDiscreteDynamicsWorld::applyGravity();
    parts_->bodies.note_gravity();
}

/// For programs that ask for contacts without a step: Bullet's own.
void SmallStepDynamicsWorld::performDiscreteCollisionDetection() {
    parts_->contacts.clear();
    parts_->detected_by_bullet = true;
    btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
}

/// Boxes and pairs of all objects, contact points of those that small_step does not find.
void SmallStepDynamicsWorld::detect_left_pairs() {
    updateAabbs();
    computeOverlappingPairs();
    if (!parts_->bodies.some_left() && !parts_->detected_by_bullet) return;
    parts_->detected_by_bullet = false;
    btOverlappingPairCache& cache = *getPairCache();
    auto* dispatcher = dynamic_cast<btCollisionDispatcher*>(getDispatcher());
    btBroadphasePairArray& pairs = cache.getOverlappingPairArray();
    for (int i = 0; i < pairs.size(); ++i) {
        const auto* a = static_cast<btCollisionObject*>(pairs[i].m_pProxy0->m_clientObject);
        const auto* b = static_cast<btCollisionObject*>(pairs[i].m_pProxy1->m_clientObject);
        if (parts_->bodies.are_ours(*a, *b))
            cache.cleanOverlappingPair(pairs[i], getDispatcher());
        else if (dispatcher != nullptr)
            dispatcher->getNearCallback()(pairs[i], *dispatcher, getDispatchInfo());
    }
}

void SmallStepDynamicsWorld::internalSingleStepSimulation(btScalar step_s) {
    if (m_internalPreTickCallback != nullptr) m_internalPreTickCallback(this, step_s);
    btDispatcherInfo& info = getDispatchInfo();
    info.m_timeStep = step_s;
    info.m_stepCount = 0;
    info.m_debugDraw = getDebugDrawer();
    getSolverInfo().m_timeStep = step_s;

    Parts& parts = *parts_;
    parts.adopt(getGravity(), step_s);
    parts.bodies.read(parts.physics);
    detect_left_pairs();
    parts.joints.read(parts.physics, *this, parts.left_constraints);
    parts.left.solve(parts.physics,
                     *getConstraintSolver(),
                     parts.left_constraints,
                     getSolverInfo(),
                     *getDispatcher());
    parts.physics.step();
    parts.bodies.write(parts.physics);
    parts.joints.write(parts.physics);
    parts.contacts.write(parts.physics);

    updateActions(step_s);
    if (m_internalTickCallback != nullptr) m_internalTickCallback(this, step_s);
}

}  // namespace plumbline

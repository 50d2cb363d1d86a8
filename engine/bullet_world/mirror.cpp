#include "engine/bullet_world/mirror.h"

#include "engine/core/log.h"

#include <algorithm>

namespace plumbline::bullet_world {
namespace {

std::array<btScalar, 3> array_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

physics::BodyKind kind_of(const btCollisionObject& object, btScalar inverse_mass) {
    if (object.isKinematicObject()) return physics::BodyKind::Kinematic;
    return inverse_mass > 0 ? physics::BodyKind::Dynamic : physics::BodyKind::Static;
}

}  // namespace

Pose pose_of(const btTransform& transform) {
    btQuaternion turn;
    transform.getBasis().getRotation(turn);
    return {.position = vec_of(transform.getOrigin()), .orientation = quat_of(turn)};
}

btTransform transform_of(const Pose& pose) {
    const Quat& q = pose.orientation;
    return btTransform(btQuaternion(q.x, q.y, q.z, q.w), bullet_of(pose.position));
}

BodyTraits traits_of(const btCollisionObject& object) {
    BodyTraits traits;
    const btCollisionShape* shape = object.getCollisionShape();
    traits.shape = shape;
    if (shape != nullptr) {
        traits.shape_scaling = array_of(shape->getLocalScaling());
        traits.shape_margin = shape->getMargin();
        if (shape->isCompound())
            traits.shape_revision = static_cast<const btCompoundShape*>(shape)->getUpdateRevision();
    }
    if (const auto* rigid = btRigidBody::upcast(&object); rigid != nullptr) {
        traits.inverse_mass = rigid->getInvMass();
        traits.inverse_inertia = array_of(rigid->getInvInertiaDiagLocal());
        traits.linear_factor = array_of(rigid->getLinearFactor());
        traits.angular_factor = array_of(rigid->getAngularFactor());
        traits.damping = {rigid->getLinearDamping(), rigid->getAngularDamping()};
    }
    traits.kind = kind_of(object, traits.inverse_mass);
    traits.materials = {object.getFriction(),
                        object.getRestitution(),
                        object.getRollingFriction(),
                        object.getSpinningFriction()};
    if (const btBroadphaseProxy* proxy = object.getBroadphaseHandle(); proxy != nullptr) {
        traits.group = proxy->m_collisionFilterGroup;
        traits.mask = proxy->m_collisionFilterMask;
    }
    traits.not_collided_with = object.getNumObjectsWithoutCollision();
    traits.can_sleep = object.getActivationState() != DISABLE_DEACTIVATION;
    traits.responds = object.hasContactResponse();
    return traits;
}

void Notes::add(const std::string& note) {
    if (std::ranges::find(notes_, note) != notes_.end()) return;
    log_warning("{}", note);
    notes_.push_back(note);
}

}  // namespace plumbline::bullet_world

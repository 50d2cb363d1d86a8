#include "engine/physics/bullet/body.h"

#include "engine/core/assert.h"
#include "engine/physics/bullet/contact/contact_copy.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/shape/shape_record.h"
#include "engine/physics/world/body_record.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Slower than both for two seconds sleeps. Well below anything a person sees moving (a snail makes
/// 1 cm/s, but a thing that slides that slowly is about to stop); bodies in the air never sleep.
constexpr btScalar kSleepSpeed_mps = btScalar(0.05);
constexpr btScalar kSleepSpin_radps = btScalar(0.1);

bool nearly_equal(const Vec3d& inertia) {
    const double largest = std::max({inertia.x, inertia.y, inertia.z});
    const double smallest = std::min({inertia.x, inertia.y, inertia.z});
    return largest - smallest <= 1e-5 * largest;
}

/// Mass, inertia and the mass frame the definition asks for.
void weigh(BodyRecord& record, const BodyDef& def, const ShapeRecord& shape) {
    record.body_from_mass = shape.body_from_mass;
    record.mass_frame_is_body = shape.mass_frame_is_body;
    record.mass_kg = static_cast<double>(def.mass_kg);
    record.inertia_kgm2 = record.mass_kg * shape.inertia_per_kg;
    if (shape.mesh) return;  // stands or is carried: no mass frame to choose
    if (def.inertia_kgm2) {
        record.inertia_kgm2 = Vec3d{*def.inertia_kgm2};
        record.body_from_mass.orientation = kNoRotation;
    }
    if (def.center_of_mass_m) record.body_from_mass.position = *def.center_of_mass_m;
    record.mass_frame_is_body = record.body_from_mass.position == Vec3{0, 0, 0} &&
                                record.body_from_mass.orientation == kNoRotation;
    record.round_inertia = nearly_equal(record.inertia_kgm2);
}

/// The shape as seen from the body's mass frame; a compound of one where the two differ.
btCollisionShape* fitted_shape(BodyRecord& record, const ShapeRecord& shape) {
    const bool same_frame = record.body_from_mass.position == shape.body_from_mass.position &&
                            record.body_from_mass.orientation == shape.body_from_mass.orientation;
    const Pose mass_from_shape =
        same_frame ? Pose{} : compose(invert(record.body_from_mass), shape.body_from_mass);
    record.cores = shape.cores;
    record.smallest_core_m = shape.cores.empty() ? 0 : shape.cores.front().radius_m;
    for (Core& core : record.cores) {
        core.center_m = transform_point(mass_from_shape, core.center_m);
        record.smallest_core_m = std::min(record.smallest_core_m, core.radius_m);
    }
    if (same_frame) return shape.collision;
    record.wrapper = std::make_unique<btCompoundShape>();
    record.wrapper->addChildShape(to_bullet(mass_from_shape), shape.collision);
    return record.wrapper.get();
}

std::unique_ptr<btRigidBody> make_rigid(const BodyRecord& record,
                                        const BodyDef& def,
                                        btCollisionShape* collision) {
    const bool dynamic = def.kind == BodyKind::Dynamic;
    btRigidBody::btRigidBodyConstructionInfo info(
        dynamic ? static_cast<btScalar>(record.mass_kg) : btScalar(0),
        nullptr,
        collision,
        dynamic ? bullet_from_double(record.inertia_kgm2) : btVector3(0, 0, 0));
    info.m_friction = def.friction;
    info.m_rollingFriction = def.rolling_friction;
    info.m_spinningFriction = def.spinning_friction;
    info.m_restitution = def.restitution;
    info.m_linearSleepingThreshold = kSleepSpeed_mps;
    info.m_angularSleepingThreshold = kSleepSpin_radps;
    auto rigid = std::make_unique<btRigidBody>(info);
    // Gyroscopic torque and gravity are the step's business (step_world.cpp), not Bullet's.
    rigid->setFlags(BT_DISABLE_WORLD_GRAVITY);
    if (def.kind == BodyKind::Kinematic) {
        rigid->setCollisionFlags(
            (rigid->getCollisionFlags() & ~btCollisionObject::CF_STATIC_OBJECT) |
            btCollisionObject::CF_KINEMATIC_OBJECT);
    }
    return rigid;
}

}  // namespace

BodyRecord::BodyRecord() = default;
BodyRecord::~BodyRecord() = default;

void give_rigid_body(BodyRecord& record, const BodyDef& def, const ShapeRecord& shape) {
    PL_ASSERT(def.kind != BodyKind::Dynamic || !shape.static_only,
              "planes and meshes only as static or kinematic bodies");
    weigh(record, def, shape);
    btCollisionShape* collision = fitted_shape(record, shape);
    record.rigid = make_rigid(record, def, collision);
    record.rigid->setUserPointer(&record);
    if (record.held_along_axes()) record.rigid->setLinearFactor(to_bullet(def.linear_factor));
    record.radius_m = collision->getAngularMotionDisc();
    record.touch_m = collision->getContactBreakingThreshold(gContactBreakingThreshold);
}

void set_rigid_mass(BodyRecord& record, bool frozen) {
    btRigidBody& rigid = *record.rigid;
    rigid.setMassProps(frozen ? btScalar(0) : static_cast<btScalar>(record.mass_kg),
                       frozen ? btVector3(0, 0, 0) : bullet_from_double(record.inertia_kgm2));
    rigid.updateInertiaTensor();
}

Transform rigid_transform(const BodyRecord& record) {
    return transform_from_bullet(record.rigid->getWorldTransform());
}
Vec3 rigid_position(const BodyRecord& record) {
    return from_bullet(record.rigid->getWorldTransform().getOrigin());
}
void set_rigid_transform(BodyRecord& record, const Transform& to) {
    record.rigid->setCenterOfMassTransform(to_bullet(to));
}

Vec3 linear_velocity(const BodyRecord& record) {
    return from_bullet(record.rigid->getLinearVelocity());
}
Vec3 angular_velocity(const BodyRecord& record) {
    return from_bullet(record.rigid->getAngularVelocity());
}
bool stands_still(const BodyRecord& record) {
    return record.rigid->getLinearVelocity().isZero() &&
           record.rigid->getAngularVelocity().isZero();
}
void set_linear_velocity(BodyRecord& record, const Vec3& velocity_mps) {
    record.rigid->setLinearVelocity(to_bullet(velocity_mps));
}
void set_angular_velocity(BodyRecord& record, const Vec3& spin_radps) {
    record.rigid->setAngularVelocity(to_bullet(spin_radps));
}

Real inverse_mass_of(const BodyRecord& record) {
    return record.rigid->getInvMass();
}
SymmetricMat3 inverse_inertia_of(const BodyRecord& record) {
    const btMatrix3x3& m = record.rigid->getInvInertiaTensorWorld();
    return {
        .xx = m[0][0], .xy = m[0][1], .xz = m[0][2], .yy = m[1][1], .yz = m[1][2], .zz = m[2][2]};
}
Vec3 inverse_moments_of(const BodyRecord& record) {
    return from_bullet(record.rigid->getInvInertiaDiagLocal());
}
Vec3 angular_gain(const BodyRecord& record, const Vec3& torque_Nm) {
    return from_bullet(record.rigid->getInvInertiaTensorWorld() * to_bullet(torque_Nm));
}

Vec3 total_force_N(const BodyRecord& record) {
    return from_bullet(record.rigid->getTotalForce());
}
Vec3 total_torque_Nm(const BodyRecord& record) {
    return from_bullet(record.rigid->getTotalTorque());
}
void add_force(BodyRecord& record, const Vec3& force_N) {
    record.rigid->applyCentralForce(to_bullet(force_N));
}
void add_torque(BodyRecord& record, const Vec3& torque_Nm) {
    record.rigid->applyTorque(to_bullet(torque_Nm));
}
void clear_forces(BodyRecord& record) {
    record.rigid->clearForces();
}
void add_impulse(BodyRecord& record, const Vec3& impulse_Ns, const Vec3& arm) {
    record.rigid->applyImpulse(to_bullet(impulse_Ns), to_bullet(arm));
}

bool is_active(const BodyRecord& record) {
    return record.rigid->isActive();
}
void set_activity(BodyRecord& record, Activity activity) {
    const int awake = record.can_sleep ? ACTIVE_TAG : DISABLE_DEACTIVATION;
    record.rigid->forceActivationState(activity == Activity::Awake ? awake : ISLAND_SLEEPING);
}
void wake_rigid_body(BodyRecord& record) {
    record.rigid->activate(true);
}

Box box_of(const BodyRecord& record) {
    btVector3 low;
    btVector3 high;
    record.rigid->getCollisionShape()->getAabb(record.rigid->getWorldTransform(), low, high);
    return {.low = from_bullet(low), .high = from_bullet(high)};
}

void set_rigid_friction(BodyRecord& record, Real friction) {
    record.rigid->setFriction(friction);
}
void set_rigid_restitution(BodyRecord& record, Real restitution) {
    record.rigid->setRestitution(restitution);
}
PairMaterial material_of(const BodyRecord& a, const BodyRecord& b) {
    return material_of(*a.rigid, *b.rigid);
}

}  // namespace plumbline::physics

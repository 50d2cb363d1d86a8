#include "engine/physics/bullet/body.h"

#include "engine/core/assert.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/bullet/shape/shape_record.h"
#include "engine/physics/world/body_record.h"

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
    record.traits.body_from_mass = shape.body_from_mass;
    record.traits.mass_frame_is_body = shape.mass_frame_is_body;
    record.traits.mass_kg = static_cast<double>(def.mass_kg);
    record.traits.inertia_kgm2 = record.traits.mass_kg * shape.inertia_per_kg;
    if (shape.mesh) return;  // stands or is carried: no mass frame to choose
    if (def.inertia_kgm2) {
        record.traits.inertia_kgm2 = Vec3d{*def.inertia_kgm2};
        record.traits.body_from_mass.orientation = def.body_from_inertia;
    }
    if (def.center_of_mass_m) record.traits.body_from_mass.position = *def.center_of_mass_m;
    record.traits.mass_frame_is_body = record.traits.body_from_mass.position == Vec3{0, 0, 0} &&
                                       record.traits.body_from_mass.orientation == kNoRotation;
    record.traits.isotropic_inertia = nearly_equal(record.traits.inertia_kgm2);
}

/// The geometry in the body's own mass frame.
void give_geometry(BodyRecord& record,
                   const ShapeRecord& shape,
                   std::span<const PartTraits> own_traits) {
    const Pose& own = record.traits.body_from_mass;
    const Pose& shared = shape.body_from_mass;
    if (own.position == shared.position && own.orientation == shared.orientation) {
        record.traits.geometry = shape.geometry;
    } else {
        const Pose own_from_shared = compose(invert(own), shared);
        record.traits.geometry = std::make_shared<const BodyGeometry>(moved(
            *shape.geometry,
            Transform{glm::mat3_cast(own_from_shared.orientation), own_from_shared.position}));
    }
    if (!own_traits.empty()) {
        PL_ASSERT(own_traits.size() == record.traits.geometry->parts.size(),
                  "the traits of every part, or none");
        auto geometry = std::make_shared<BodyGeometry>(*record.traits.geometry);
        for (std::size_t i = 0; i < own_traits.size(); ++i) geometry->parts[i].own = own_traits[i];
        record.traits.geometry = std::move(geometry);
    }
    const std::vector<GeometryPart>& parts = record.traits.geometry->parts;
    if (parts.size() == 1 && parts.front().mass_from_part == Transform{})
        record.traits.primitive = parts.front().shape;
}

/// The shape as seen from the body's mass frame, as a compound of one; none where the two agree.
std::unique_ptr<btCompoundShape> wrapper_of(const BodyRecord& record, const ShapeRecord& shape) {
    const Pose& own = record.traits.body_from_mass;
    const bool same_frame = own.position == shape.body_from_mass.position &&
                            own.orientation == shape.body_from_mass.orientation;
    const Pose mass_from_shape = same_frame ? Pose{} : compose(invert(own), shape.body_from_mass);
    if (same_frame) return nullptr;
    auto wrapper = std::make_unique<btCompoundShape>();
    wrapper->addChildShape(to_bullet(mass_from_shape), shape.collision);
    return wrapper;
}

std::unique_ptr<RigidBody> make_rigid(const BodyRecord& record,
                                      const BodyDef& def,
                                      btCollisionShape* collision) {
    const bool dynamic = def.kind == BodyKind::Dynamic;
    btRigidBody::btRigidBodyConstructionInfo info(
        dynamic ? static_cast<btScalar>(record.traits.mass_kg) : btScalar(0),
        nullptr,
        collision,
        dynamic ? bullet_from_double(record.traits.inertia_kgm2) : btVector3(0, 0, 0));
    info.m_linearSleepingThreshold = kSleepSpeed_mps;
    info.m_angularSleepingThreshold = kSleepSpin_radps;
    auto rigid = std::make_unique<RigidBody>(info);
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
    give_geometry(record, shape, def.parts);
    record.sweep.inner_radius_m = shape.inner_radius_m;
    record.traits.material = {.friction = def.friction,
                              .restitution = def.restitution,
                              .rolling_m = def.rolling_friction,
                              .spinning_m = def.spinning_friction,
                              .friction_rule = def.friction_rule,
                              .restitution_rule = def.restitution_rule};
    std::unique_ptr<btCompoundShape> wrapper = wrapper_of(record, shape);
    btCollisionShape* collision = wrapper ? wrapper.get() : shape.collision;
    record.rigid = make_rigid(record, def, collision);
    record.rigid->wrapper = std::move(wrapper);
    record.motion->inverse_mass = record.rigid->getInvMass();
    record.motion->inverse_moments = from_bullet(record.rigid->getInvInertiaDiagLocal());
    record.rigid->setUserPointer(&record);
    if (record.traits.held_along_axes())
        record.rigid->setLinearFactor(to_bullet(def.linear_factor));
    record.traits.radius_m = collision->getAngularMotionDisc();
    record.traits.contact_margin_m =
        collision->getContactBreakingThreshold(gContactBreakingThreshold);
}

void set_rigid_mass(BodyRecord& record, bool frozen) {
    btRigidBody& rigid = *record.rigid;
    rigid.setMassProps(
        frozen ? btScalar(0) : static_cast<btScalar>(record.traits.mass_kg),
        frozen ? btVector3(0, 0, 0) : bullet_from_double(record.traits.inertia_kgm2));
    rigid.updateInertiaTensor();
    record.motion->inverse_mass = rigid.getInvMass();
    record.motion->inverse_moments = from_bullet(rigid.getInvInertiaDiagLocal());
}

void write_rigid_pose(const BodyRecord& record) {
    record.rigid->setWorldTransform(to_bullet(record.motion->at));
}
void write_rigid_motion(const BodyRecord& record) {
    RigidBody& rigid = *record.rigid;
    rigid.setCenterOfMassTransform(to_bullet(record.motion->at));
    rigid.setLinearVelocity(to_bullet(record.motion->velocity_mps));
    rigid.setAngularVelocity(to_bullet(record.motion->spin_radps));
}
void read_rigid_motion(BodyRecord& record) {
    record.motion->at = transform_from_bullet(record.rigid->getWorldTransform());
    record.motion->velocity_mps = from_bullet(record.rigid->getLinearVelocity());
    record.motion->spin_radps = from_bullet(record.rigid->getAngularVelocity());
}
void write_rigid_start(const BodyRecord& record) {
    RigidBody& rigid = *record.rigid;
    rigid.setLinearVelocity(to_bullet(record.motion->velocity_mps));
    rigid.setAngularVelocity(to_bullet(record.motion->spin_radps));
    rigid.clearForces();
    rigid.applyCentralForce(to_bullet(record.applied.force_N));
    rigid.applyTorque(to_bullet(record.applied.torque_Nm));
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
    record.rigid->getCollisionShape()->getAabb(to_bullet(record.motion->at), low, high);
    return {.low = from_bullet(low), .high = from_bullet(high)};
}

}  // namespace plumbline::physics

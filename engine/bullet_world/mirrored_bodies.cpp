#include "engine/bullet_world/mirrored_bodies.h"

#include "engine/bullet_world/foreign_shapes.h"

#include <algorithm>
#include <cmath>

namespace plumbline::bullet_world {
namespace {

/// Bullet's objects that cannot turn have no inertia; so much times their mass and size keeps them
/// from it for as long as anybody looks.
constexpr Real kLockedInertia = 1e15_r;

/// What has no surface moves as a ball of this radius that touches nothing.
constexpr btScalar kPoint_m = btScalar(0.01);

btCollisionObject& object_at(btCollisionWorld& world, std::size_t index) {
    return *world.getCollisionObjectArray()[static_cast<int>(index)];
}

Vec3 vec_of(const std::array<btScalar, 3>& a) {
    return {a[0], a[1], a[2]};
}

/// Principal moments: those of Bullet, with what its angular factor holds locked.
Vec3 inertia_of(const btRigidBody& rigid, const BodyTraits& traits) {
    btVector3 centre;
    btScalar radius = 0;
    rigid.getCollisionShape()->getBoundingSphere(centre, radius);
    const Real locked =
        kLockedInertia * std::max(radius * radius, btScalar(1)) / traits.inverse_mass;
    const Vec3 inverse = vec_of(traits.inverse_inertia) * vec_of(traits.angular_factor);
    Vec3 inertia{locked, locked, locked};
    for (int i = 0; i < 3; ++i) {
        if (inverse[i] > 1 / locked) inertia[i] = 1 / inverse[i];
    }
    return inertia;
}

/// Bullet keeps (1 - d)^t of a speed, we exp(-k t).
Real damping_per_s(btScalar bullet_damping) {
    const double kept = std::max(1.0 - static_cast<double>(bullet_damping), 1e-9);
    return static_cast<Real>(-std::log(kept));
}

/// What Bullet has added to the forces of an awake body for the world's gravity.
btVector3 pull_of(const btRigidBody& rigid, const Vec3& gravity_mps2) {
    return (bullet_of(gravity_mps2) * (btScalar(1) / rigid.getInvMass())) * rigid.getLinearFactor();
}

void set_activation(btRigidBody& rigid, bool awake) {
    const int state = rigid.getActivationState();
    if (state == DISABLE_DEACTIVATION || state == DISABLE_SIMULATION) return;
    if (!awake) {
        rigid.setActivationState(ISLAND_SLEEPING);
    } else if (state != ACTIVE_TAG) {
        rigid.setActivationState(ACTIVE_TAG);
        rigid.setDeactivationTime(0);
    }
}

/// Of ours: else Bullet finds what it touches.
bool has_contacts(const Mirror& mirror) {
    return mirror.body != physics::BodyId{} && mirror.traits.responds;
}

std::unique_ptr<Mirror> mirror_for(btCollisionObject& object) {
    auto mirror = std::make_unique<Mirror>();
    mirror->object = &object;
    mirror->rigid = btRigidBody::upcast(&object);
    return mirror;
}

}  // namespace

void MirroredBodies::note_gravity() {
    list_new();
    for (const auto& mirror : mirrors_)
        mirror->pulled = mirror->rigid != nullptr && mirror->rigid->isActive();
}

void MirroredBodies::list_new() {
    const auto count = static_cast<std::size_t>(objects_.getNumCollisionObjects());
    while (mirrors_.size() < count)
        mirrors_.push_back(mirror_for(object_at(objects_, mirrors_.size())));
}

void MirroredBodies::read(physics::PhysicsWorld& world) {
    list_new();
    left_ = 0;
    for (const auto& mirror : mirrors_) {
        const BodyTraits traits = traits_of(*mirror->object);
        if (!mirror->known || !(traits == mirror->traits)) {
            destroy(world, *mirror);
            make(world, *mirror, traits);
        } else if (mirror->body != physics::BodyId{}) {
            read_motion(world, *mirror);
        }
        if (!has_contacts(*mirror)) ++left_;
        if (mirror->body == physics::BodyId{} || traits.kind != physics::BodyKind::Dynamic)
            continue;
        read_activation(world, *mirror);
        read_forces(world, *mirror);
    }
}

void MirroredBodies::make(physics::PhysicsWorld& world, Mirror& mirror, const BodyTraits& traits) {
    mirror.known = true;
    mirror.traits = traits;
    mirror.pose = mirror.object->getWorldTransform();
    const bool dynamic = traits.kind == physics::BodyKind::Dynamic;
    if (traits.inverse_mass < 0)
        notes_.add("a body with a mass below zero stands as if it had none");
    if (traits.shape == nullptr || (!traits.responds && !dynamic)) return;

    const bool surface = has_surface(*traits.shape);
    if (!surface && !dynamic) return;
    physics::BodyDef def{.kind = traits.kind};
    const btSphereShape point(kPoint_m);
    const btCollisionShape& shape = surface ? *traits.shape : point;
    def.shape = shape_of(world, shape, dynamic, mirror.object_from_body);
    if (def.shape == physics::ShapeId{}) return;
    def.world_from_body = compose(pose_of(mirror.pose), mirror.object_from_body);
    def.filter = {.group = static_cast<std::uint32_t>(traits.group),
                  .collides_with = surface ? static_cast<std::uint32_t>(traits.mask) : 0};
    def.can_sleep = traits.can_sleep;
    def.user = mirror.mark();
    if (dynamic) {
        mirror.velocity = mirror.rigid->getLinearVelocity();
        mirror.spin = mirror.rigid->getAngularVelocity();
        def.mass_kg = 1 / traits.inverse_mass;
        def.inertia_kgm2 = inertia_of(*mirror.rigid, traits);
        def.center_of_mass_m = Vec3{0, 0, 0};
        def.velocity_mps = bullet_world::vec_of(mirror.velocity);
        def.angular_velocity_radps = bullet_world::vec_of(mirror.spin);
        def.linear_damping_per_s = damping_per_s(traits.damping[0]);
        def.angular_damping_per_s = damping_per_s(traits.damping[1]);
        def.linear_factor = vec_of(traits.linear_factor);
    }
    mirror.body = world.create_body(def);
    mirror.awake = mirror.simulated = true;
}

void MirroredBodies::destroy(physics::PhysicsWorld& world, Mirror& mirror) {
    if (!mirror.known) return;
    mirror.known = false;
    if (mirror.body != physics::BodyId{}) world.destroy_body(mirror.body);
    mirror.body = {};
}

physics::ShapeId MirroredBodies::shape_of(physics::PhysicsWorld& world,
                                          const btCollisionShape& shape,
                                          bool dynamic,
                                          Pose& object_from_shape) {
    auto foreign = foreign_shape(shape, dynamic);
    if (!foreign) {
        notes_.add("a body is left out: " + foreign.error().message);
        return {};
    }
    object_from_shape = foreign->object_from_shape;
    const std::uint64_t hash = shape_hash(foreign->def);
    if (const auto known = shapes_.find(hash); known != shapes_.end()) return known->second;
    const auto made = world.create_shape(foreign->def);
    if (!made) {
        notes_.add("a body is left out: " + made.error().message);
        return {};
    }
    shapes_.emplace(hash, *made);
    return *made;
}

void MirroredBodies::read_motion(physics::PhysicsWorld& world, Mirror& mirror) {
    const bool moved = !(mirror.object->getWorldTransform() == mirror.pose);
    if (moved) {
        mirror.pose = mirror.object->getWorldTransform();
        const Pose pose = compose(pose_of(mirror.pose), mirror.object_from_body);
        if (mirror.traits.kind == physics::BodyKind::Kinematic)
            world.move_kinematic(mirror.body, pose);
        else
            world.set_pose(mirror.body, pose);
    }
    if (mirror.traits.kind != physics::BodyKind::Dynamic) return;
    const btRigidBody& rigid = *mirror.rigid;
    if (rigid.getLinearVelocity() != mirror.velocity || rigid.getAngularVelocity() != mirror.spin) {
        mirror.velocity = rigid.getLinearVelocity();
        mirror.spin = rigid.getAngularVelocity();
        world.set_velocity(
            mirror.body, bullet_world::vec_of(mirror.velocity), bullet_world::vec_of(mirror.spin));
    } else if (!mirror.awake && rigid.isActive()) {
        world.wake(mirror.body);
    }
}

void MirroredBodies::read_activation(physics::PhysicsWorld& world, Mirror& mirror) {
    const bool simulated = mirror.rigid->getActivationState() != DISABLE_SIMULATION;
    if (simulated != mirror.simulated) world.set_frozen(mirror.body, !simulated);
    mirror.simulated = simulated;
}

void MirroredBodies::read_forces(physics::PhysicsWorld& world, const Mirror& mirror) {
    const btRigidBody& rigid = *mirror.rigid;
    if (!rigid.isActive()) return;
    btVector3 force = rigid.getTotalForce();
    if (mirror.pulled) force -= pull_of(rigid, world.def().gravity_mps2);
    if (!force.isZero()) {
        // The factor is in it already.
        for (int i = 0; i < 3; ++i) {
            if (rigid.getLinearFactor()[i] != 0) force[i] /= rigid.getLinearFactor()[i];
        }
        world.apply_force(mirror.body, bullet_world::vec_of(force));
    }
    if (!rigid.getTotalTorque().isZero())
        world.apply_torque(mirror.body, bullet_world::vec_of(rigid.getTotalTorque()));
}

void MirroredBodies::write(const physics::PhysicsWorld& world) {
    for (const auto& mirror : mirrors_) {
        if (mirror->body != physics::BodyId{} && mirror->traits.kind == physics::BodyKind::Dynamic)
            write_motion(world, *mirror);
    }
}

void MirroredBodies::write_motion(const physics::PhysicsWorld& world, Mirror& mirror) {
    const physics::BodyState state = world.state(mirror.body);
    if (!state.awake && !mirror.awake) return;
    btRigidBody& rigid = *mirror.rigid;
    rigid.setLinearVelocity(bullet_of(state.velocity_mps));
    rigid.setAngularVelocity(bullet_of(state.angular_velocity_radps));
    rigid.proceedToTransform(transform_of(state.world_from_body));
    mirror.pose = rigid.getWorldTransform();
    mirror.velocity = rigid.getLinearVelocity();
    mirror.spin = rigid.getAngularVelocity();
    mirror.awake = state.awake;
    set_activation(rigid, state.awake);
}

/// Bullet puts its last object in the place of the one that goes.
void MirroredBodies::remove(physics::PhysicsWorld& world, const btCollisionObject& object) {
    list_new();
    const int index = object.getWorldArrayIndex();
    if (index < 0 || static_cast<std::size_t>(index) >= mirrors_.size()) return;
    auto& place = mirrors_[static_cast<std::size_t>(index)];
    destroy(world, *place);
    std::swap(place, mirrors_.back());
    mirrors_.pop_back();
}

Mirror* MirroredBodies::find(const btCollisionObject& object) const {
    const int index = object.getWorldArrayIndex();
    if (index < 0 || static_cast<std::size_t>(index) >= mirrors_.size()) return nullptr;
    Mirror* mirror = mirrors_[static_cast<std::size_t>(index)].get();
    return mirror->object == &object ? mirror : nullptr;
}

bool MirroredBodies::are_ours(const btCollisionObject& a, const btCollisionObject& b) const {
    const auto is_ours = [this](const btCollisionObject& object) {
        const Mirror* mirror = find(object);
        return mirror != nullptr && has_contacts(*mirror);
    };
    return is_ours(a) && is_ours(b);
}

}  // namespace plumbline::bullet_world

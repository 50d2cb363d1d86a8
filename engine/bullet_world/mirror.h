// A Bullet object and the body that stands for it in the PhysicsWorld.
#pragma once

#include "engine/physics/physics_world.h"

#include <btBulletDynamicsCommon.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::bullet_world {

Pose pose_of(const btTransform& transform);
btTransform transform_of(const Pose& pose);
inline Vec3 vec_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
inline Quat quat_of(const btQuaternion& q) {
    return {q.w(), q.x(), q.y(), q.z()};
}
inline btVector3 bullet_of(const Vec3& v) {
    return {v.x, v.y, v.z};
}

/// All that a body is made from. When any of it changes, the body is made anew.
struct BodyTraits {
    physics::BodyKind kind{physics::BodyKind::Static};
    const btCollisionShape* shape{nullptr};
    int shape_revision{0};  ///< of a compound
    std::array<btScalar, 3> shape_scaling{};
    btScalar shape_margin{0};
    btScalar inverse_mass{0};
    std::array<btScalar, 3> inverse_inertia{};
    std::array<btScalar, 3> linear_factor{};
    std::array<btScalar, 3> angular_factor{};
    std::array<btScalar, 4> materials{};  ///< friction, restitution, rolling, spinning
    std::array<btScalar, 2> damping{};
    int group{0};
    int mask{0};
    int not_collided_with{0};  ///< how many objects it ignores
    bool can_sleep{true};
    bool responds{true};  ///< to contacts

    bool operator==(const BodyTraits&) const = default;
};
BodyTraits traits_of(const btCollisionObject& object);

struct Mirror {
    btCollisionObject* object{nullptr};
    btRigidBody* rigid{nullptr};  ///< `object`, if it is one
    physics::BodyId body{};       ///< null: none stands for it
    bool known{false};            ///< `traits` have been read
    BodyTraits traits{};
    Pose object_from_body{};  ///< of static bodies; others have none
    bool simulated{true};     ///< false: its state is DISABLE_SIMULATION
    bool pulled{false};       ///< Bullet has added its gravity to its forces
    // As they were when the two last agreed.
    btTransform pose{btTransform::getIdentity()};
    btVector3 velocity{0, 0, 0};
    btVector3 spin{0, 0, 0};
    bool awake{true};

    std::uint64_t mark() const { return std::bit_cast<std::uint64_t>(this); }
};

inline const Mirror& mirror_of(std::uint64_t mark) {
    return *std::bit_cast<const Mirror*>(mark);
}

/// Sentences, each kept and logged once.
class Notes {
public:
    void add(const std::string& note);
    const std::vector<std::string>& all() const { return notes_; }

private:
    std::vector<std::string> notes_;
};

}  // namespace plumbline::bullet_world

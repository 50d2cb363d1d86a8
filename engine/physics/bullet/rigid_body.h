// Bullet's side of a body.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <memory>

namespace plumbline::physics {

struct BodyRecord;

struct RigidBody : btRigidBody {
    using btRigidBody::btRigidBody;

    std::uint32_t pairs{0};                    ///< bullet_*: in Bullet's cache
    std::unique_ptr<btCompoundShape> wrapper;  ///< when the mass frame is not the shape's own
};

/// The record behind a Bullet object of ours.
inline BodyRecord& record_of(const btCollisionObject& object) {
    return *static_cast<BodyRecord*>(object.getUserPointer());
}

}  // namespace plumbline::physics

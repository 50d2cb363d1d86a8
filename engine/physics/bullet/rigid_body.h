// Bullet's side of a body.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

namespace plumbline::physics {

struct RigidBody : btRigidBody {
    using btRigidBody::btRigidBody;

    std::unique_ptr<btCompoundShape> wrapper;  ///< when the mass frame is not the shape's own
};

}  // namespace plumbline::physics

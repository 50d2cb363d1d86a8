// Contacts as Bullet keeps them from step to step, for saved games.
#pragma once

#include "engine/core/io/archive.h"

#include <btBulletDynamicsCommon.h>

#include <vector>

class btCompoundCollisionAlgorithm;

namespace plumbline::physics {

/// The algorithms of pairs with their manifolds. Both ways meet them in the same order, so that a
/// manifold may be named by its number.
class ContactArchive {
public:
    ContactArchive(Archive& archive,
                   btCollisionDispatcher& dispatcher,
                   const btDispatcherInfo& info)
        : archive_(archive), dispatcher_(dispatcher), info_(info) {}

    /// Made when read, with all that hangs on it, if there was one.
    void pair(btCollisionAlgorithm*& algorithm, btRigidBody& first, btRigidBody& second);
    /// The dispatcher lists its manifolds as it did.
    void order();

private:
    void algorithm(btCollisionAlgorithm*& algorithm,
                   const btCollisionObjectWrapper& first,
                   const btCollisionObjectWrapper& second);
    void children(btCompoundCollisionAlgorithm& compound,
                  const btCollisionObjectWrapper& first,
                  const btCollisionObjectWrapper& second);
    void child_pairs(btCollisionAlgorithm& compounds,
                     const btCollisionObjectWrapper& first,
                     const btCollisionObjectWrapper& second);
    void single(btCollisionAlgorithm& single,
                const btCollisionObjectWrapper& first,
                const btCollisionObjectWrapper& second);
    void forget(btCollisionAlgorithm*& algorithm);

    Archive& archive_;
    btCollisionDispatcher& dispatcher_;
    const btDispatcherInfo& info_;
    std::vector<btPersistentManifold*> manifolds_;
};

}  // namespace plumbline::physics

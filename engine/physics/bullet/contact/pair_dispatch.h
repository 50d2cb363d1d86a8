// Bullet's dispatcher for the manifolds of small_step.
#pragma once

#include <btBulletCollisionCommon.h>

namespace plumbline::physics {

/// Makes manifolds that reach as far as the pair at work.
class PairDispatcher final : public btCollisionDispatcher {
public:
    explicit PairDispatcher(btCollisionConfiguration* configuration)
        : btCollisionDispatcher(configuration) {}

    btPersistentManifold* getNewManifold(const btCollisionObject* a,
                                         const btCollisionObject* b) override;
    /// Who walks the pairs decides; algorithms ask again while they are made.
    bool needsCollision(const btCollisionObject*, const btCollisionObject*) override {
        return true;
    }

    btScalar reach_m{0};
    int manifolds_made{0};  ///< ever; numbers them
};

}  // namespace plumbline::physics

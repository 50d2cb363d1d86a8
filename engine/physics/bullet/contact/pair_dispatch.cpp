#include "engine/physics/bullet/contact/pair_dispatch.h"

namespace plumbline::physics {

btPersistentManifold* PairDispatcher::getNewManifold(const btCollisionObject* a,
                                                     const btCollisionObject* b) {
    btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(a, b);
    manifold->setContactBreakingThreshold(reach_m);
    manifold->m_companionIdA = ++manifolds_made;
    return manifold;
}

}  // namespace plumbline::physics

// Contacts of a compound's boxes, spheres and capsules, which Bullet's compound algorithms ask for.
//
// Bullet 3.24's boxes have no points before they overlap, and lose corners when more than four are
// to choose from; its spheres meet boxes by an iteration that now and then ends at a wrong normal, and
// its capsules so with one point a step.
#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>

namespace plumbline::physics {

/// Makes the algorithm; the dispatcher keeps pointers to it, so it must outlive it.
class PartContacts {
public:
    /// From now on `dispatcher` meets boxes our way.
    explicit PartContacts(btCollisionDispatcher& dispatcher);

private:
    std::unique_ptr<btCollisionAlgorithmCreateFunc> maker_;
};

}  // namespace plumbline::physics

// Contacts of boxes with boxes, spheres and capsules.
//
// Bullet 3.24's boxes have no points before they overlap, and lose corners when more than four are
// to choose from; its spheres meet boxes by an iteration that now and then ends at a wrong normal, and
// its capsules so with one point a step.
#pragma once

#include <btBulletCollisionCommon.h>

#include <array>
#include <memory>

namespace plumbline::physics {

/// Makes the algorithms; the dispatcher keeps pointers to these, so they must outlive it.
class BoxContacts {
public:
    /// From now on `dispatcher` meets boxes our way.
    explicit BoxContacts(btCollisionDispatcher& dispatcher);

private:
    std::array<std::unique_ptr<btCollisionAlgorithmCreateFunc>, 2> makers_;
};

}  // namespace plumbline::physics

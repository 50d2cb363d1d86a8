// Bodies near a place in Bullet's world, in plain types.
#pragma once

#include "engine/physics/collision/shape/box_tree.h"

#include <cstdint>
#include <vector>

namespace plumbline::physics {

class StepWorld;
struct BodyRecord;

/// Bodies that a cast or overlap sees. Groups must agree both ways.
struct BodyFilter {
    std::uint32_t group{~0U};
    std::uint32_t collides_with{~0U};
    const BodyRecord* ignored{nullptr};  ///< and what joints keep it from touching
    const BodyRecord* also_ignored{nullptr};
    std::uint32_t unseen_group{0};  ///< SweptBody::group whose members are not hit; 0: none

    bool sees(const BodyRecord& record) const;
};

/// Bodies whose boxes touch the given box, in the order of their ids.
std::vector<const BodyRecord*> bodies_near(const StepWorld& world,
                                           const Bounds& box,
                                           const BodyFilter& filter);

}  // namespace plumbline::physics

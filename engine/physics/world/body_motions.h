// What steps move of all bodies, side by side.
#pragma once

#include "engine/physics/dynamics/body_motion.h"

#include <array>
#include <memory>
#include <vector>

namespace plumbline::physics {

/// By the index of the body's id; the body of a lower index comes first in memory within a block.
/// Addresses stay.
class BodyMotions {
public:
    /// At rest, at the origin: a body of this index is made.
    BodyMotion& make(std::uint32_t index) {
        while (blocks_.size() <= index / kBlock) blocks_.push_back(std::make_unique<Block>());
        return (*blocks_[index / kBlock])[index % kBlock] = {};
    }

private:
    static constexpr std::uint32_t kBlock = 64;
    using Block = std::array<BodyMotion, kBlock>;
    std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace plumbline::physics

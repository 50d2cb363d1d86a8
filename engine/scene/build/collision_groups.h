// Names of collision groups as bits, and what bodies and their parts touch.
#pragma once

#include "engine/core/result.h"
#include "engine/physics/body.h"
#include "engine/scene/scene_description.h"
#include "engine/scene/surfaces.h"

#include <map>
#include <string>
#include <vector>

namespace plumbline::scene {

class CollisionGroups {
public:
    /// Names the group's bit; groups beyond the 32nd are an error.
    Result<std::uint32_t> bit(const std::string& name);
    /// Of the body, and of all its parts where it has some of their own.
    Result<physics::CollisionFilter> filter_of(const BodyDescription& body);
    /// Of each of its parts; empty where they are as the body. What no part says is the surface's.
    Result<std::vector<physics::PartTraits>> parts_of(const BodyDescription& body,
                                                      const Surface& surface);
    /// Those named so far, each with its bit.
    const std::map<std::string, std::uint32_t>& bits() const { return bits_; }

private:
    std::map<std::string, std::uint32_t> bits_{{"default", 1U}};
};

}  // namespace plumbline::scene

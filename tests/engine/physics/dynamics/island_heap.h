// Bodies whose islands are told by their marks.
#pragma once

#include "tests/engine/physics/test_world.h"

#include <cmath>
#include <utility>
#include <vector>

namespace plumbline::physics {

inline BodyDef box_at_rest(std::uint64_t user) {
    return {.kind = BodyKind::Dynamic, .can_sleep = false, .user = user};
}

inline std::vector<std::pair<std::uint64_t, std::uint32_t>> users_and_sizes(
    const PhysicsWorld& world) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> list;
    for (const IslandReport& island : world.report().islands) {
        list.emplace_back(island.user, island.bodies);
    }
    return list;
}

using IslandSizes = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

/// A heap in which contacts come and go.
struct Heap {
    TestWorld test{in_small_steps()};
    std::vector<BodyId> ids;

    Heap() {
        test.ground();
        for (int i = 0; i < 40; ++i) {
            const auto n = static_cast<Real>(i);
            const Vec3 at{std::sin(n), 1 + 0.7_r * n, std::cos(2 * n)};
            const BodyDef def{.kind = BodyKind::Dynamic,
                              .angular_velocity_radps = {0, n, 0},
                              .restitution = i % 3 == 0 ? 0.5_r : 0.0_r,
                              .contact_events = i % 2 == 0};
            if (i % 3 == 0)
                ids.push_back(test.add(SphereShape{}, at, def));
            else
                ids.push_back(test.add(BoxShape{.size_m = {1, 0.6_r, 0.8_r}}, at, def));
        }
    }
    std::uint64_t run(int steps) {
        for (int i = 0; i < steps; ++i) test.world.step();
        return test.hash(ids);
    }
};

}  // namespace plumbline::physics

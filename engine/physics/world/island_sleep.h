// When bodies come to rest, and who wakes together.
//
// A body is slow while its kinetic energy would lift it by less than a 5000th of its radius. It is
// at rest once it was slow for half a second and hardly went anywhere meanwhile: what creeps, swings
// over or turns slowly is not at rest. An island sleeps when all its bodies are at rest.
#pragma once

#include "engine/physics/dynamics/island.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

struct BodyRecord;
struct BodyScope;

inline constexpr double kSleepAfter_s = 0.5;

/// How a body has kept still.
struct Rest {
    Vec3d position_m{0, 0, 0};  ///< at the start of the present stretch of time
    Quatd orientation{1, 0, 0, 0};
    double stretch_s{0};    ///< how long it lasts so far
    double went_m{-1};      ///< in the stretch before; negative: there is none
    int slow_stretches{0};  ///< stretches in a row
};

/// Takes note of a step of `step_s` that ends now.
void watch_rest(BodyRecord& record, double gravity_mps2, double step_s);
/// Starts watching anew.
void break_rest(BodyRecord& record);
/// Whether nothing keeps the island from sleeping.
bool is_at_rest(const Island& island);

/// Bodies that fell asleep together. Numbers start at 1 and are used again.
class SleepingIslands {
public:
    std::uint32_t add(std::span<BodyRecord* const> bodies);
    /// The bodies of a sleeping island, by their ids; it ends.
    std::vector<BodyRecord*> end(std::uint32_t sleeping_island);
    /// How many bodies sleep so.
    std::size_t count() const;
    void serialize(Archive& archive, const BodyScope& scope);

private:
    std::vector<std::vector<BodyRecord*>> bodies_;
    std::vector<std::uint32_t> free_;
};

}  // namespace plumbline::physics

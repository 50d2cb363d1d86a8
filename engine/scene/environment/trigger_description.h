// What a scene file says of a trigger: a volume, and what happens when a body comes in.
#pragma once

#include "engine/core/math.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {

struct TriggerDescription {
    std::vector<std::string> of;         ///< entities that count; none: every moving body
    int times{1};                        ///< how often at most
    std::string spawn;                   ///< prefab that appears; empty: none
    Vec3 at_m{0, 0, 0};                  ///< there
    bool remove{false};                  ///< what came in goes
    std::optional<Vec3> impulse_Ns{};    ///< what came in gets it, at its centre of mass
    std::optional<Vec3> gravity_mps2{};  ///< of the world from then on
    std::string explode;                 ///< name of the [[explosion]] that goes off
    std::string light;                   ///< entity whose light is switched on or off
    std::string message;                 ///< said to the player
    std::filesystem::path sound;         ///< heard there; empty: none
    bool count{false};                   ///< it counts towards the [goal]
};

}  // namespace plumbline::scene

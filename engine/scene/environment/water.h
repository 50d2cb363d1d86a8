// A water of a running scene.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/scene/environment/basin.h"
#include "engine/scene/environment/wave_field.h"

#include <memory>
#include <optional>

namespace plumbline::scene {

struct SceneWater {
    Vec3d min_m{0, 0, 0};
    Vec3d max_m{0, 0, 0};          ///< y: the level
    ecs::Entity surface{};         ///< what is drawn of it; null: nothing
    std::optional<Basin> basin{};  ///< none: it fills its box
    std::unique_ptr<WaveField>
        waves{};  ///< of a surface that is not flat, while effect water lives
};

}  // namespace plumbline::scene

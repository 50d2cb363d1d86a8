// A water of a running scene.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/scene/environment/basin.h"
#include "engine/scene/environment/wave_field.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

namespace plumbline::scene {

struct SceneWater {
    Vec3d min_m{0, 0, 0};
    Vec3d max_m{0, 0, 0};          ///< y: the level
    ecs::Entity surface{};         ///< what is drawn of it; null: nothing
    std::optional<Basin> basin{};  ///< none: it fills its box
    std::unique_ptr<WaveField>
        waves{};  ///< of a surface that is not flat, while effect water lives

    /// Whether there is water above its ground at that place.
    bool spans(double x_m, double z_m) const {
        const bool is_in_box = x_m >= min_m.x && x_m <= max_m.x && z_m >= min_m.z && z_m <= max_m.z;
        return is_in_box && (!basin || basin->holds(x_m, z_m));
    }
};

/// What something has under water.
struct Displaced {
    int water{-1};  ///< its number; below 0: none
    double volume_m3{0};
    double radius_m{0};  ///< of all of it
    Vec3d place_m{0, 0, 0};
    double gained_m3{0};  ///< in the latest step

    void serialize(auto& archive) { archive(water, volume_m3, radius_m, place_m, gained_m3); }
};

/// By how much what it is about to displace itself lifts the surface round such a thing on the way: the mean over the coming step.
double own_rise_m(const SceneWater& water, const Displaced& felt);
/// How far the surface is above its level there, as such a thing feels it in the coming step: with own_rise_m() of it.
double felt_rise_m(const SceneWater& water,
                   const Displaced& felt,
                   const Vec3d& place_m,
                   double own_m);
inline double felt_rise_m(const SceneWater& water, const Displaced& felt, const Vec3d& place_m) {
    return felt_rise_m(water, felt, place_m, own_rise_m(water, felt));
}

/// The waves of the waters know of `now` in place of `before`.
void displace(std::span<SceneWater> waters, Displaced& before, const Displaced& now);

}  // namespace plumbline::scene

// What is left of a body that breaks.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/physics/fracture.h"
#include "engine/scene/components.h"
#include "engine/scene/scene_description.h"

#include <optional>
#include <span>
#include <string>

namespace plumbline::scene {

/// A body that can break, or did: how it is cut, and what its parts are made of. Stays when it is gone.
struct FragileWhole {
    std::string name;
    EntityDescription description;
    physics::FracturePattern pattern;
    double density_kgpm3{1};
    std::vector<assets::MaterialId> materials;  ///< of its visual; at most one is used
    std::uint16_t surface{0};
    std::uint32_t next_part{0};  ///< number in the name of the next
    std::optional<double> broke_at_s{};
};

/// Whether it is a part of something that broke.
inline bool is_fragment(const FragileWhole& whole, const Fragile& fragile) {
    return fragile.pieces.size() < whole.pattern.pieces.size();
}

/// Where the frame of a body of these pieces lies in the pattern, along the same axes: the whole has its own, a part that of its centre.
Vec3d origin_of(const physics::FracturePattern& pattern, std::span<const std::uint32_t> pieces);

/// Some of its pieces as a thing of its own, whose origin is their centre: hulls, drawn with their cut faces. Pose and velocity are left
/// to the caller.
EntityDescription fragment_of(const FragileWhole& whole, std::span<const std::uint32_t> pieces);

}  // namespace plumbline::scene

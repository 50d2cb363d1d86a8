// Where grass grows, and what a tuft looks like. The same place grows the same tufts, whoever looks.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/core/math.h"
#include "engine/scene/nature_description.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace plumbline::effects {

struct Tuft {
    Vec3f root_world{0.0F};
    float yaw_rad{0.0F};
    float scale{1.0F};
    float shade{1.0F};         ///< of the colour
    float rank{0.0F};          ///< 0…1, even: where fewer are drawn, the low ones stay
    std::uint32_t variant{0};  ///< 0…kTuftVariants - 1
};

inline constexpr std::uint32_t kTuftVariants = 3;
inline constexpr float kGrassCell_m = 2.0F;

/// Height of the lawn over a place in the plane, or nothing where none grows.
using LawnAt = std::function<std::optional<float>(float x, float z)>;

/// Blades of a tuft as high as 1 m on average, rooted at the origin; colours from root to tip are shares
/// of the lawn's own. `near`: bent blades, more of them.
assets::MeshData tuft_mesh(std::uint32_t variant, bool near);

/// The tufts round the eye, by square cells that are kept while they are near.
class GrassField {
public:
    explicit GrassField(const scene::GrassDescription& grass) : grass_(grass) {}

    /// Grows cells within `reach_m` of the eye, at most `most_new` of them, and forgets those well
    /// beyond. Nearer ones first.
    void follow(const Vec3f& eye_world, float reach_m, std::size_t most_new, const LawnAt& lawn);

    const std::map<std::pair<int, int>, std::vector<Tuft>>& cells() const { return cells_; }
    std::size_t bytes() const;

private:
    std::vector<Tuft> grow(int x, int z, const LawnAt& lawn) const;

    scene::GrassDescription grass_;
    std::map<std::pair<int, int>, std::vector<Tuft>> cells_;
};

}  // namespace plumbline::effects

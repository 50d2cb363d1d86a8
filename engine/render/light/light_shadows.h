// Which local lights cast shadows, and the six maps that lie round each: what a cube map has as faces
// lies side by side in a row of one image. Pure arithmetic: tested without GL.
#pragma once

#include "engine/core/math.h"
#include "engine/render/culling/frustum.h"
#include "engine/render/render_frame.h"
#include "shaders/shared/limits.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace plumbline::render {

inline constexpr std::uint32_t kLightFaces = 6;  ///< +x -x +y -y +z -z

struct ShadowedLight {
    std::uint32_t light{0};  ///< its number in the frame
    std::uint32_t row{0};    ///< of the image; below PL_MAX_SHADOWED_LIGHTS
    bool moved{false};       ///< since it was chosen last
};

/// Chooses anew for each frame; a light keeps its row while it is chosen, so that its maps can be kept.
class LightShadowChoice {
public:
    /// Of the lights that cast shadows and reach into sight: those that are brightest at the eye, `most`
    /// at most. One that has its shadow keeps it until another is half as bright again.
    void choose(std::span<const LocalLight> lights,
                const Frustum& sight,
                const Vec3f& eye_world,
                std::uint32_t most);

    const std::vector<ShadowedLight>& chosen() const { return chosen_; }
    /// In sight, too, but dimmer than `most` others.
    std::uint32_t left_out() const { return left_out_; }

private:
    struct Candidate {
        std::uint32_t light{0};
        std::optional<std::uint32_t> row{};
        float brightness{0.0F};
    };
    std::vector<Candidate> candidates(std::span<const LocalLight> lights,
                                      const Frustum& sight,
                                      const Vec3f& eye_world);

    std::vector<ShadowedLight> chosen_;
    std::uint32_t left_out_{0};
    std::array<std::optional<Vec3f>, PL_MAX_SHADOWED_LIGHTS> places_world_{};  ///< by row
};

/// A quarter of a turn along an axis, and a margin for the filter's taps. Depth is that of a perspective
/// from PL_LIGHT_SHADOW_NEAR_M to the light's radius.
Mat4f clip_from_world(const LocalLight& light, std::uint32_t face, std::uint32_t size_px);

/// False only if none of the light goes that way.
bool shines_into(const LocalLight& light, std::uint32_t face);

/// What the shader finds a place in the maps with; see LocalLightEntry::shadow.
Vec4f shadow_numbers(const LocalLight& light, std::uint32_t row, std::uint32_t size_px);

}  // namespace plumbline::render

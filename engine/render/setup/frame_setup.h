// All that the passes of one frame read, computed from the frame before anything is drawn: no pass writes
// into it, and computing it draws nothing.
#pragma once

#include "engine/render/culling/convex_volume.h"
#include "engine/render/culling/draw_list.h"
#include "engine/render/culling/occlusion_culling.h"
#include "engine/render/light/light_shadows.h"
#include "engine/render/light/shadow_view.h"
#include "engine/render/setup/image_plan.h"
#include "engine/render/shader_blocks.h"
#include "engine/render/shaders/mesh_features.h"
#include "engine/render/sky/gpu_sky.h"

#include <optional>
#include <span>
#include <vector>

namespace plumbline::render {

/// Lights are given in physical units; shaders want what a matt white surface sends out.
inline constexpr float kPerPi = glm::one_over_pi<float>();

/// What passes over the whole image know of the camera.
struct ScreenView {
    Mat4f view_from_world{1.0F};
    Vec2f tan_half{1.0F};          ///< of half the angles of view
    Vec2f depth_line{1.0F, 0.0F};  ///< 1 / metres along the line of sight = x + y * depth
    float pixels_at_1m{1.0F};      ///< of the scene's image, that 1 m takes
};

struct SunSetup {
    std::optional<DirectionalLight> light;  ///< sun or moon, as it reaches the ground
    std::vector<ShadowView> shadow_views;   ///< one a cascade; empty: it throws no shadow
    /// Shadows end so near beside what casts them, m; 0: unknown.
    float shadow_margin_m{0.0F};
    bool hardens_contacts{
        false};  ///< the edges of shadows are as wide as the sun's disc makes them
};

struct FlashlightSetup {
    std::optional<ConvexVolume> beam;  ///< empty: there is no flashlight
    std::optional<ShadowView> shadow;  ///< empty: its shadows cannot be seen
};

struct LampSetup {
    std::vector<LocalLight> lights;    ///< those that cast shadows first
    std::vector<Vec4f> shadow_places;  ///< LocalLightEntry::shadow of those
    LightShadowChoice choice;          ///< which cast shadows: the next frame goes on from it
    std::uint32_t shadow_px{0};  ///< side of one of the maps round a light; 0: none casts shadows
};

struct DrawSetup {
    std::vector<VisibleItem> visible;
    DrawList opaque;
    DrawList translucent;
    DrawKind opaque_kind{DrawKind::Opaque};
    std::optional<ShadowSight> shadow_sight;  ///< who sees the shadows in the sun's nearest map
};

struct FrameSetup {
    const RenderFrame* frame{nullptr};
    ImagePlan image;
    ScreenView screen;
    FrameBlock block;
    FeatureSet features{0};  ///< those that the frame asks of the mesh shader
    SunSetup sun;
    FlashlightSetup flashlight;
    LampSetup lamps;
    DrawSetup draws;
};

/// What a setup is computed from beside the frame itself. Nothing of it is changed.
struct SetupInputs {
    const Device& device;
    const assets::AssetLibrary& library;
    const GpuSky& sky;
    const LightShadowChoice& lamps_before;  ///< of the frame before
};

/// Camera, light and air; no draw lists.
FrameSetup set_up(const RenderFrame& frame, const ImagePlan& image, const SetupInputs& inputs);

/// What of the frame is in sight. `lods`: coarser versions of meshes; null: full meshes only.
DrawSetup set_up_draws(const FrameSetup& setup,
                       const assets::AssetLibrary& library,
                       const LodTable* lods);

/// Sun and moon, and where their shadow maps look; their numbers go into the block.
SunSetup set_up_sun(const RenderFrame& frame,
                    const ImagePlan& image,
                    const SetupInputs& inputs,
                    FrameBlock& block);
FlashlightSetup set_up_flashlight(const RenderFrame& frame, FrameBlock& block);
/// Lamps in the order in which the shaders read them; the block says how many cast shadows.
LampSetup set_up_lamps(const RenderFrame& frame,
                       const ImagePlan& image,
                       const SetupInputs& inputs,
                       FrameBlock& block);

}  // namespace plumbline::render

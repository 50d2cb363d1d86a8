// Private: what a Renderer owns.
#pragma once

#include "engine/render/culling/convex_volume.h"
#include "engine/render/gl/buffer.h"
#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/object.h"
#include "engine/render/gl/pass_timer.h"
#include "engine/render/light/gpu_lights.h"
#include "engine/render/passes/drop_pass.h"
#include "engine/render/passes/light_shadow_pass.h"
#include "engine/render/passes/line_pass.h"
#include "engine/render/passes/mesh_pass.h"
#include "engine/render/passes/refraction_pass.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/scene_target.h"
#include "engine/render/passes/screen/exposure_meter.h"
#include "engine/render/passes/screen/focus_pass.h"
#include "engine/render/passes/screen/motion_blur_pass.h"
#include "engine/render/passes/screen/occlusion_pass.h"
#include "engine/render/passes/screen/post_pass.h"
#include "engine/render/passes/screen/shaft_pass.h"
#include "engine/render/passes/shadow_pass.h"
#include "engine/render/passes/sky_pass.h"
#include "engine/render/renderer.h"
#include "engine/render/resources/gpu_limits.h"
#include "engine/render/shader_blocks.h"

namespace plumbline::render {

/// 0: the device works.
using ResetStatus = unsigned int (*)();

/// So many fields because each pass, each kind of resource and each number that passes share is one.
struct Renderer::Impl {
    Impl(PresentTarget present,
         const std::filesystem::path& shaders,
         assets::AssetLibrary& library,
         const GpuLimits& gpu_limits)
        : target(present), limits(gpu_limits), scene(shaders, library, gpu_limits.map_px) {}

    PresentTarget target;
    GpuLimits limits;  ///< sizes are set, half_float_targets is as the driver has them
    GlInfo gl{};
    bool is_software_gl{false};
    ResetStatus reset_status{nullptr};
    bool device_lost{false};
    SceneResources scene;

    // The frame between begin() and end(); null outside.
    const RenderFrame* frame{nullptr};
    bool nothing_to_draw{true};
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    Quality quality{};                    ///< in force: the frame's, or less where memory is short
    FeatureSet features{0};               ///< of the frame
    std::optional<DirectionalLight> sun;  ///< or moon, as it reaches the ground
    PostView post_view{};
    ScreenView screen_view{};
    bool draws_codes{false};  ///< surfaces and sky write sRGB codes into the present target
    FrameBlock block;
    std::vector<ShadowView> sun_views;          ///< one a cascade
    float sun_shadow_margin_m{0.0F};            ///< as MeshView's
    std::optional<ShadowView> flashlight_view;  ///< none: its shadows cannot be seen
    std::optional<ConvexVolume> beam;           ///< the flashlight's
    LightShadowChoice light_choice;
    std::vector<LocalLight> lights_in_order;  ///< those that cast shadows first
    std::vector<Vec4f> light_shadow_numbers;  ///< of those
    std::vector<VisibleItem> visible;
    ShadowSight shadow_sight;
    DrawList opaque_draws;
    DrawList translucent_draws;

    gl::Buffer frame_buffer{gl::BufferUse::Uniforms, gl::BufferLife::PerFrame};
    GpuLights lights;
    gl::Texture color_image;  ///< Offscreen only
    gl::Texture depth_image;
    gl::Framebuffer own_framebuffer;
    SceneTarget scene_target;
    FullscreenTriangle triangle;
    ShadowPass sun_shadow;
    ShadowPass flashlight_shadow;
    LightShadowPass light_shadow;
    gl::SamplerObject depth_sampler;  ///< reads depths that textures compare; made when asked for
    gl::SamplerObject
        base_sampler;  ///< of base colour maps in images that are scaled up; made when needed
    MeshPass opaque_pass;
    MeshPass translucent_pass;
    PostPass post;
    RefractionPass refraction_pass;
    DropPass drop_pass;
    OcclusionPass occlusion_pass;
    ShaftPass shaft_pass;
    FocusPass focus_pass;
    MotionBlurPass motion_blur_pass;
    ExposureMeter exposure_meter;
    LinePass line_pass;

    gl::PassTimers timers;
    FrameStats stats;
    bool drew_a_frame{false};  ///< since there were other meshes and materials

    /// Sizes targets, reads the frame's wishes into features and matrices; frees what it has none.
    void set_up(const RenderFrame& new_frame);
    void build_draw_lists();
    /// Of what is visible, and of the casters in the sun's first map.
    void leave_out_hidden();
    /// Without half floats light is kept as sRGB codes: white is the brightest.
    gl::TargetFormat light_format() const {
        return limits.half_float_targets ? gl::TargetFormat::HdrColor : gl::TargetFormat::Srgb8;
    }
    DrawKind opaque_kind() const {
        return frame->depth_test == DepthTest::Less ? DrawKind::Opaque : DrawKind::OpaqueInOrder;
    }
    MeshView mesh_view() const {
        return {.features = features,
                .lights = lights_in_order,
                .shadowed_lights = light_shadow_numbers.size(),
                .beam = beam ? &*beam : nullptr,
                .frame = frame,
                .light_direction_world = sun ? sun->direction_world : Vec3f{0.0F},
                .shadow_margin_m = sun_shadow_margin_m,
                .clip_from_world = block.clip_from_world,
                .eye_world = frame->camera.position_world,
                .size_px = post_view.scene_px,
                .depth_line = screen_view.depth_line,
                .behind = refraction_pass.part()};
    }
    /// Side of one of the maps round a light.
    std::uint32_t light_shadow_px() const;
    /// Copies what lies behind water that shows it; without memory for that the water does not.
    void copy_behind_water();
    /// Runs the passes between the scene and bloom; frees those that the frame does not ask for.
    SceneLight finish_light();
    /// Sets the exposure by how bright the scene has become.
    void adapt_exposure();
    /// The sun's map as depths, where the frame's shaders ask for those.
    void bind_sun_depth();
    /// For meshes in an image that is scaled up: base colours as fine as in the image shown.
    void bind_base_sampler();
    void bind_present_target() const;
    /// The background, which is as far as the camera sees, as the image holds it.
    Vec3f clear_color() const;
    unsigned int present_framebuffer() const;

private:
    // Light that passes after the scene add needs half floats.
    bool has_occlusion() const {
        return limits.half_float_targets && frame->occlusion &&
               quality.ambient_occlusion != Drawn::Never;
    }
    bool has_shafts() const {
        return limits.half_float_targets && frame->sun && frame->shafts &&
               quality.sun_shafts != Drawn::Never;
    }
    bool has_refraction() const {
        return limits.half_float_targets && frame->refraction && quality.refraction != Drawn::Never;
    }
    bool has_focus() const { return limits.half_float_targets && frame->depth_of_field; }
    bool has_motion_blur() const { return limits.half_float_targets && frame->motion_blur; }
    /// Where the camera of the frame's motion blur was.
    Mat4f clip_before_from_world() const;
    void add_occlusion(SceneLight& light);
    void add_shafts(SceneLight& light);
    void add_focus(SceneLight& light);
    void add_motion_blur(SceneLight& light);
    void size_targets();
    void size_own_target();
    Result<Done> try_scene_targets();
    void set_up_wind(const Wind& wind);
    void set_up_sky();
    void choose_light_shadows();
    void choose_features(const RenderFrame& new_frame);
    void choose_shadow_filter();
    void set_up_light();
    void set_up_flashlight(const Flashlight& flashlight);

    PixelSize asked_px_{};  ///< for which size memory was short
    int given_up_{0};       ///< 0: nothing; 1: half the render scale; 2: the lowest level
};

inline constexpr FeatureSet kShadowFeatures =
    feature::kSunShadow | feature::kFlashlight | feature::kLightShadows;

/// The shader code that all of a frame's draws share.
FeatureSet frame_features_of(const RenderFrame& frame);

}  // namespace plumbline::render

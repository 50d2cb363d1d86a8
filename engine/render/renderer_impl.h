// Private: what a Renderer owns.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/pass_timer.h"
#include "engine/render/passes/line_pass.h"
#include "engine/render/passes/mesh_pass.h"
#include "engine/render/passes/post_pass.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/shadow_pass.h"
#include "engine/render/passes/sky_pass.h"
#include "engine/render/renderer.h"
#include "engine/render/shader_blocks.h"

namespace plumbline::render {

struct Renderer::Impl {
    Impl(PresentTarget present, const std::filesystem::path& shaders, assets::AssetLibrary& library)
        : target(present), scene(shaders, library) {}

    PresentTarget target;
    GlInfo gl{};
    bool is_software_gl{false};
    SceneResources scene;

    // The frame between begin() and end(); null outside.
    const RenderFrame* frame{nullptr};
    bool nothing_to_draw{true};
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    FeatureSet features{0};  ///< of the frame
    FrameBlock block;
    ShadowView sun_view{};
    ShadowView flashlight_view{};
    DrawList opaque_draws;
    DrawList translucent_draws;

    gl::Buffer frame_buffer{gl::BufferUse::Uniforms, gl::BufferLife::PerFrame};
    gl::Buffer lights_buffer{gl::BufferUse::Uniforms, gl::BufferLife::PerFrame};
    gl::Texture color_image;  ///< Offscreen only
    gl::Texture depth_image;
    gl::Framebuffer own_framebuffer;
    FullscreenTriangle triangle;
    ShadowPass sun_shadow;
    ShadowPass flashlight_shadow;
    MeshPass opaque_pass;
    MeshPass translucent_pass;
    PostPass post;
    LinePass line_pass;

    gl::PassTimers timers;
    FrameStats stats;

    /// Sizes targets, reads the frame's wishes into features and matrices; frees what it has none.
    void set_up(const RenderFrame& new_frame);
    void build_draw_lists();
    void bind_present_target() const;
    void bind_scene_target() const;  ///< HDR image or present target

private:
    void size_targets();
    void set_up_light();
    void set_up_flashlight(const Flashlight& flashlight);
};

/// The shader code that all of a frame's draws share. `hdr`: passes write radiance.
FeatureSet frame_features_of(const RenderFrame& frame, bool hdr);

}  // namespace plumbline::render

// Private: what a Renderer owns, by what lives together.
#pragma once

#include "engine/render/frame_passes.h"
#include "engine/render/gl/buffer.h"
#include "engine/render/gl/pass_timer.h"
#include "engine/render/gl_device.h"
#include "engine/render/light/gpu_lights.h"
#include "engine/render/passes/drop_pass.h"
#include "engine/render/passes/line_pass.h"
#include "engine/render/passes/mesh_pass.h"
#include "engine/render/passes/refraction_pass.h"
#include "engine/render/passes/screen/frame_targets.h"
#include "engine/render/passes/sky_pass.h"
#include "engine/render/renderer.h"
#include "engine/render/resources/samplers.h"
#include "engine/render/setup/frame_setup.h"

#include <optional>

namespace plumbline::render {

/// Numbers of a frame in the memory of the GPU.
struct FrameUniforms {
    gl::Buffer block{gl::BufferUse::Uniforms, gl::BufferLife::PerFrame};
    GpuLights lights;
};

struct ScenePasses {
    MeshPass opaque;
    MeshPass translucent;
    RefractionPass refraction;
    DropPass drops;
    LinePass lines;
};

struct Renderer::Impl {
    Impl(GlDevice gl_device, const std::filesystem::path& shaders, assets::AssetLibrary& library)
        : gl(std::move(gl_device)), scene(shaders, library, gl.device.limits.map_px) {}

    GlDevice gl;
    SceneResources scene;
    FrameTargets targets;
    FrameUniforms uniforms;
    Samplers samplers;
    FullscreenTriangle triangle;
    ShadowPasses shadow_passes;
    ScenePasses scene_passes;
    LightPasses light_passes;
    gl::PassTimers timers;
    FrameStats stats;
    LightShadowChoice lamps_before;  ///< of the frame before
    bool drew_a_frame{false};        ///< since there were other meshes and materials

    /// The frame between begin() and end(); none: there is nothing to draw.
    std::optional<FrameSetup> setup;
    ShadowMaps shadow_maps;

    /// Makes targets and resources ready for the frame and computes its setup without draw lists.
    std::optional<FrameSetup> set_up_frame(const RenderFrame& frame);
    void upload_uniforms(const FrameSetup& frame_setup);
    PassContext context() { return {scene, triangle, timers, stats}; }
};

}  // namespace plumbline::render

#include "engine/render/frame_passes.h"

#include "engine/core/color.h"

#include <glad/gl.h>

#include <cmath>

namespace plumbline::render {

ShadowMaps draw_shadow_maps(const FrameSetup& setup, ShadowPasses& passes, PassContext context) {
    ShadowMaps maps;
    const RenderFrame& frame = *setup.frame;
    if (!setup.sun.shadow_views.empty()) {
        const gl::PassTimers::Scope timed(context.timers, "shadow.sun");
        const auto& sight = setup.draws.shadow_sight;
        passes.sun.render(setup.sun.shadow_views,
                          sight ? &*sight : nullptr,
                          frame,
                          context.resources,
                          context.stats);
        maps.sun = &passes.sun.map();
    } else {
        passes.sun.free();
    }
    if (setup.flashlight.shadow) {
        const gl::PassTimers::Scope timed(context.timers, "shadow.flashlight");
        passes.flashlight.render(
            {&*setup.flashlight.shadow, 1}, nullptr, frame, context.resources, context.stats);
        maps.flashlight = &passes.flashlight.map();
    } else {
        passes.flashlight.free();
    }
    if (!setup.lamps.choice.chosen().empty()) {
        const gl::PassTimers::Scope timed(context.timers, "shadow.lights");
        passes.lamps.render(setup, context.resources, context.stats);
        maps.lamps = &passes.lamps.map();
    } else if (setup.lamps.shadow_px == 0) {
        passes.lamps.free();
    }
    return maps;
}

void bind_light_images(const FrameSetup& setup,
                       const ShadowMaps& maps,
                       const SceneResources& resources,
                       Samplers& samplers) {
    const auto bind = [](TextureUnit unit, const gl::Texture* map) {
        if (map != nullptr) gl::bind_texture(unit, gl::TextureKind::Flat, *map);
    };
    bind(kSunShadowUnit, maps.sun);
    bind(kLightShadowUnit, maps.lamps);
    bind(kFlashlightShadowUnit, maps.flashlight);
    samplers.bind_sun_depth(setup.sun.hardens_contacts ? maps.sun : nullptr);
    if (resources.sky.ready())
        gl::bind_texture(kSkyUnit, gl::TextureKind::Cube, resources.sky.reflection());
    if (resources.light_grid.ready()) resources.light_grid.bind();
}

float share_of_height(const ImagePlan& image) {
    return static_cast<float>(image.image_px.height) / static_cast<float>(image.present_px.height);
}

Vec3f background_of(const FrameSetup& setup) {
    const Vec3f& light = setup.frame->clear_color;
    if (!setup.image.writes_codes) return light;
    return {srgb_from_linear(light.x), srgb_from_linear(light.y), srgb_from_linear(light.z)};
}

std::optional<PixelPart> copy_behind_water(const FrameSetup& setup,
                                           const SceneTarget& scene,
                                           RefractionPass& pass,
                                           PassContext context) {
    if (!setup.image.refraction) {
        pass.free();
        return {};
    }
    const GpuMaterials& materials = context.resources.materials;
    Aabb seen;
    for (const DrawRun& run : setup.draws.translucent.runs) {
        if ((materials.features(run.material) & mesh_feature::kRefraction) != 0)
            seen.include(run.bounds_world);
    }
    if (seen.empty()) return {};
    const gl::PassTimers::Scope timed(context.timers, "refraction");
    const bool is_copied = pass.copy(scene, seen, setup.block.clip_from_world);
    scene.bind();
    if (!is_copied) return {};
    pass.bind();
    return pass.part();
}

SceneLight finish_light(const FrameSetup& setup,
                        const SceneTarget& scene,
                        const ShadowMaps& maps,
                        LightPasses& passes,
                        PassContext context) {
    const ImagePlan& image = setup.image;
    auto& [resources, triangle, timers, stats] = context;
    if (scene.samples() > 1) {
        const gl::PassTimers::Scope timed(timers, "resolve");
        scene.resolve();
    }
    SceneLight light{
        .image = &scene.color(), .depth = &scene.depth(), .depth_line = setup.screen.depth_line};
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    if (image.occlusion) {
        const gl::PassTimers::Scope timed(timers, "occlusion");
        light.occlusion = passes.occlusion.render(setup, *light.depth, triangle, resources, stats);
        if (light.occlusion != nullptr) light.features |= screen_feature::kOcclusion;
    } else {
        passes.occlusion.free();
    }
    if (image.shafts && setup.sun.light) {
        const gl::PassTimers::Scope timed(timers, "shafts");
        light.shafts =
            passes.shafts.render(setup, *light.depth, maps.sun, triangle, resources, stats);
        if (light.shafts != nullptr) light.features |= screen_feature::kShafts;
    } else {
        passes.shafts.free();
    }
    // What a lens or a shutter makes of the light holds all that was to be added.
    const auto replace_by = [&](const gl::Texture* seen) {
        if (seen == nullptr) return;
        light.image = seen;
        light.features = 0;
    };
    if (image.focus) {
        const gl::PassTimers::Scope timed(timers, "focus");
        replace_by(passes.focus.render(setup, light, triangle, resources, stats));
    } else {
        passes.focus.free();
    }
    if (image.motion_blur) {
        const gl::PassTimers::Scope timed(timers, "motion_blur");
        replace_by(passes.motion_blur.render(setup, light, triangle, resources, stats));
    } else {
        passes.motion_blur.free();
    }
    return light;
}

std::optional<float> measured_exposure(const FrameSetup& setup,
                                       const Device& device,
                                       const SceneTarget& scene,
                                       LightPasses& passes,
                                       PassContext context) {
    const std::optional<Post>& post = setup.frame->post;
    if (!post || !post->adapts || !device.limits.half_float_targets) {
        passes.exposure.free();
        return {};
    }
    const gl::PassTimers::Scope timed(context.timers, "post.exposure");
    return passes.exposure.measure(
        scene.color(),
        device.is_offscreen ? ExposureMeter::Reading::Now : ExposureMeter::Reading::Later,
        context.triangle,
        context.resources,
        context.stats);
}

}  // namespace plumbline::render

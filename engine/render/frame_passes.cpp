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
        passes.sun.render(setup.sun.shadow_views, sight ? &*sight : nullptr, frame, context);
        maps.sun = &passes.sun.map();
    } else {
        passes.sun.free();
    }
    if (setup.flashlight.shadow) {
        const gl::PassTimers::Scope timed(context.timers, "shadow.flashlight");
        passes.flashlight.render({&*setup.flashlight.shadow, 1}, nullptr, frame, context);
        maps.flashlight = &passes.flashlight.map();
    } else {
        passes.flashlight.free();
    }
    if (!setup.lamps.choice.chosen().empty()) {
        const gl::PassTimers::Scope timed(context.timers, "shadow.lights");
        passes.lamps.render(setup, context);
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
        if (map != nullptr) gl::bind_texture(unit, *map);
    };
    bind(kSunShadowUnit, maps.sun);
    bind(kLightShadowUnit, maps.lamps);
    bind(kFlashlightShadowUnit, maps.flashlight);
    samplers.bind_sun_depth(setup.sun.hardens_contacts ? maps.sun : nullptr);
    if (resources.sky.ready()) gl::bind_texture(kSkyUnit, resources.sky.reflection());
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
    gl::PassTimers& timers = context.timers;
    if (scene.samples() > 1) {
        const gl::PassTimers::Scope timed(timers, "resolve");
        scene.resolve();
    }
    SceneLight light{
        .image = &scene.color(), .depth = &scene.depth(), .depth_line = setup.screen.depth_line};
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    // What nobody asks for is freed.
    const auto run = [&](bool is_asked, std::string_view name, auto& images, auto pass) {
        if (!is_asked) {
            images = {};
            return static_cast<const gl::Texture*>(nullptr);
        }
        const gl::PassTimers::Scope timed(timers, name);
        return pass(images);
    };
    light.occlusion = run(image.occlusion, "occlusion", passes.occlusion, [&](PairImages& images) {
        return find_occlusion(setup, *light.depth, images, context);
    });
    light.shafts =
        run(image.shafts && setup.sun.light, "shafts", passes.shafts, [&](PairImages& images) {
            return find_shafts(setup, *light.depth, maps.sun, images, context);
        });
    light.features = screen_feature::kOcclusion.when(light.occlusion != nullptr) |
                     screen_feature::kShafts.when(light.shafts != nullptr);
    // What a lens or a shutter makes of the light holds all that was to be added.
    const auto replace_by = [&](const gl::Texture* seen) {
        if (seen == nullptr) return;
        light.image = seen;
        light.features = 0;
    };
    replace_by(run(image.focus, "focus", passes.focus, [&](FocusImages& images) {
        return see_through_lens(setup, light, images, context);
    }));
    replace_by(
        run(image.motion_blur, "motion_blur", passes.motion_blur, [&](MotionBlurImages& images) {
            return blur_motion(setup, light, images, context);
        }));
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
        context);
}

}  // namespace plumbline::render

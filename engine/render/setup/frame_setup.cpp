#include "engine/render/setup/frame_setup.h"

#include "engine/render/culling/frustum.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

ScreenView screen_view(const Camera& camera, const ImagePlan& image) {
    const float tan_y = std::tan(camera.fov_y_rad * 0.5F);
    return {.view_from_world = glm::translate(glm::transpose(glm::mat4_cast(camera.orientation)),
                                              -camera.position_world),
            .tan_half = {tan_y * image.aspect(), tan_y},
            .depth_line = {1.0F / camera.near_m, 1.0F / camera.far_m - 1.0F / camera.near_m},
            .pixels_at_1m = 0.5F * static_cast<float>(image.scene_px.height) / tan_y};
}

void put_camera(const Camera& camera,
                const ScreenView& screen,
                const ImagePlan& image,
                FrameBlock& block) {
    block.clip_from_world =
        glm::perspective(camera.fov_y_rad, image.aspect(), camera.near_m, camera.far_m) *
        screen.view_from_world;
    block.world_from_ray =
        glm::mat4_cast(camera.orientation) * glm::scale(Mat4f{1.0F}, Vec3f{screen.tan_half, -1.0F});
    block.camera_world = Vec4f{camera.position_world, 0.0F};
    block.clusters.x = PL_CLUSTERS_X / static_cast<float>(image.scene_px.width);
    block.clusters.y = PL_CLUSTERS_Y / static_cast<float>(image.scene_px.height);
}

void put_wind(const Wind& wind, FrameBlock& block) {
    block.wind.x = wind.mean_mps.x;
    block.wind.y = wind.mean_mps.y;
    for (std::size_t i = 0; i < kGustWaves; ++i) {
        const Wind::Wave& wave = wind.gusts[i];
        const float length = glm::length(wave.number_radpm);
        block.gusts[i] = Vec4f{
            wave.number_radpm, wave.phase_rad, length > 0.0F ? wave.speed_mps / length : 0.0F};
    }
}

void put_computed_sky(const ComputedSky& sky, float visibility_m, FrameBlock& block) {
    block.tone.w = 1.0F;
    // Fog is as bright as the light that falls into it.
    block.fog = Vec4f{Vec3f{block.fog} * sky.irradiance() * kPerPi, block.fog.w};
    if (visibility_m <= 0.0F) return;
    const std::array<Vec3f, 3> horizon = sky.horizon();
    const Vec2f heading = sky.light_heading();
    // Koschmieder: a fiftieth of the contrast is left there.
    block.aerial = {Vec4f{horizon[0], 3.912F / visibility_m},
                    Vec4f{horizon[1], heading.x},
                    Vec4f{horizon[2], heading.y}};
}

void put_sky(const RenderFrame& frame, const GpuSky& sky, FrameBlock& block) {
    block.tone.z = static_cast<float>(sky.reflection_levels() - 1);
    const ComputedSky* computed = sky.computed();
    const Vec3f scale = computed != nullptr ? Vec3f{1.0F} : frame.ambient;
    for (std::size_t i = 0; i < kSkyCoefficients; ++i)
        block.sky_light[i] = Vec4f{sky.light()[i] * scale, 0.0F};
    if (computed != nullptr)
        return put_computed_sky(*computed, frame.sky->model->visibility_m, block);
    block.tone.w = sky.exposure() * frame.sky->brightness;
}

void put_air_and_tone(const RenderFrame& frame, FrameBlock& block) {
    block.ambient = Vec4f{frame.ambient, 0.0F};
    if (frame.fog) block.fog = Vec4f{frame.fog->color, frame.fog->density_per_m};
    block.wind.z = frame.time_s;
    if (frame.wind) put_wind(*frame.wind, block);
    if (!frame.post) return;
    block.tone.x = frame.post->exposure;
    block.tone.y = frame.post->bloom;
}

/// A point of the surface is looked up half a cell off it, in the room that it faces.
void put_light_grid(const IndirectLight& indirect, FrameBlock& block) {
    const Vec3f scale = 1.0F / (indirect.max_world - indirect.min_world);
    block.grid = {Vec4f{scale, 0.5F * indirect.spacing_m},
                  Vec4f{-indirect.min_world * scale, indirect.gain}};
}

FeatureSet shadow_filter_of(const FrameSetup& setup, const Device& device) {
    if (!setup.image.quality.shadow_filter) return mesh_feature::kHardShadows;
    return mesh_feature::kSoftShadows.when(!device.is_software_gl);
}

/// The shader code that the frame's draws share.
FeatureSet features_of(const FrameSetup& setup, const Device& device) {
    const RenderFrame& frame = *setup.frame;
    FeatureSet features = shadow_filter_of(setup, device);
    const auto add = [&](bool wanted, FeatureSet feature) {
        if (wanted) features |= feature;
    };
    add(setup.sun.light.has_value(), mesh_feature::kSun);
    add(!setup.sun.shadow_views.empty(), mesh_feature::kSunShadow);
    add(setup.sun.shadow_views.size() > 1, mesh_feature::kCascades);
    add(setup.sun.hardens_contacts, mesh_feature::kContactHardening);
    add(setup.flashlight.beam.has_value(), mesh_feature::kFlashlight);
    add(setup.flashlight.beam && !setup.flashlight.shadow, mesh_feature::kFlashlightAtEye);
    add(!frame.lights.empty(), mesh_feature::kLocalLights);
    add(!frame.lights.empty() && setup.lamps.shadow_px > 0, mesh_feature::kLightShadows);
    add(frame.sky.has_value(), mesh_feature::kSkyLight);
    add(frame.sky && frame.indirect, mesh_feature::kIndirect);
    add(setup.block.aerial[0].w > 0.0F, mesh_feature::kAerial);
    add(setup.image.occlusion, mesh_feature::kOcclusion);
    add(setup.image.samples > 1, mesh_feature::kCoverage);
    add(setup.image.writes_codes, mesh_feature::kCodes);
    return features;
}

OcclusionView occlusion_view(const FrameSetup& setup) {
    return {.clip_from_world = setup.block.clip_from_world,
            .width_px = setup.image.scene_px.width,
            .height_px = setup.image.scene_px.height,
            .reach_px = setup.image.samples > 1 ? kSamplesReach_px : kCenterReach_px};
}

CullView cull_view(const FrameSetup& setup, const LodTable* lods) {
    const Quality& quality = setup.image.quality;
    const Camera& camera = setup.frame->camera;
    // However few pixels there are, a roof must not lose its tiles: no coarser than at six tenths.
    const float rows = std::max(static_cast<float>(setup.image.scene_px.height),
                                0.6F * static_cast<float>(setup.image.present_px.height));
    const float pixel_rad = 2.0F * std::tan(camera.fov_y_rad * 0.5F) / rows;
    return {.frustum = Frustum{setup.block.clip_from_world},
            .eye_world = camera.position_world,
            .lods = lods,
            .error_rad = quality.lod_error_px * pixel_rad,
            .smallest_rad = quality.smallest_px * pixel_rad,
            .sorts_foliage = true,
            .beam = setup.flashlight.beam ? &*setup.flashlight.beam : nullptr};
}

}  // namespace

FrameSetup set_up(const RenderFrame& frame, const ImagePlan& image, const SetupInputs& inputs) {
    FrameSetup setup{.frame = &frame, .image = image};
    setup.screen = screen_view(frame.camera, image);
    FrameBlock& block = setup.block;
    put_camera(frame.camera, setup.screen, image, block);
    put_air_and_tone(frame, block);
    if (frame.sky && inputs.sky.ready()) put_sky(frame, inputs.sky, block);
    if (frame.indirect) put_light_grid(*frame.indirect, block);
    setup.sun = set_up_sun(frame, image, inputs, block);
    setup.flashlight = set_up_flashlight(frame, block);
    setup.lamps = set_up_lamps(frame, image, inputs, block);
    setup.features = features_of(setup, inputs.device);
    return setup;
}

DrawSetup set_up_draws(const FrameSetup& setup,
                       const assets::AssetLibrary& library,
                       const LodTable* lods) {
    const RenderFrame& frame = *setup.frame;
    DrawSetup draws;
    const bool in_order = frame.depth_test != DepthTest::Less;
    draws.opaque_kind = in_order ? DrawKind::OpaqueInOrder : DrawKind::Opaque;
    draws.visible = cull(frame, library, cull_view(setup, lods));
    if (!in_order && frame.fill_mode == FillMode::Filled) {
        const OcclusionView view = occlusion_view(setup);
        remove_hidden(draws.visible, library, view);
        if (setup.sun.shadow_margin_m > 0.0F) {
            draws.shadow_sight = {.view = view,
                                  .visible = draws.visible,
                                  .light_direction_world = -Vec3f{setup.block.to_sun_world},
                                  .margin_m = setup.sun.shadow_margin_m};
        }
    }
    build_draws(draws.visible, library, draws.opaque_kind, draws.opaque);
    build_draws(draws.visible, library, DrawKind::Translucent, draws.translucent);
    if ((setup.features & mesh_feature::kAerial) != 0) {
        for (DrawList* list : {&draws.opaque, &draws.translucent})
            mark_far_instances(*list, frame.camera.position_world);
    }
    return draws;
}

}  // namespace plumbline::render

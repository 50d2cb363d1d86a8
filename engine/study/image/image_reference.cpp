#include "engine/study/image/image_reference.h"

#include "engine/render/light/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace plumbline::study {

Vec3f ray_through(const render::Camera& camera, float aspect, const Vec2f& at) {
    const float up = std::tan(camera.fov_y_rad * 0.5F);
    const Vec3f in_view{(2.0F * at.x - 1.0F) * up * aspect, (1.0F - 2.0F * at.y) * up, -1.0F};
    return glm::normalize(camera.orientation * in_view);
}

LightImage reference_image(const assets::ImageData& in_sun,
                           const assets::ImageData& without_sun,
                           std::uint32_t samples_per_side,
                           const IsShaded& is_shaded) {
    const LightImage lit = light_of(in_sun);
    const LightImage unlit = light_of(without_sun);
    LightImage reference{.width_px = lit.width_px / samples_per_side,
                         .height_px = lit.height_px / samples_per_side,
                         .light = {}};
    reference.light.assign(std::size_t{reference.width_px} * reference.height_px, Vec3f{0.0F});
    const Vec2f size{lit.width_px, lit.height_px};
    const float share = 1.0F / static_cast<float>(samples_per_side * samples_per_side);
    for (std::uint32_t y = 0; y < reference.height_px * samples_per_side; ++y) {
        for (std::uint32_t x = 0; x < reference.width_px * samples_per_side; ++x) {
            Vec3f sample = lit.at(x, y);
            const Vec3f& dark = unlit.at(x, y);
            if (sample != dark && is_shaded((Vec2f{x, y} + 0.5F) / size)) sample = dark;
            reference.light[std::size_t{y / samples_per_side} * reference.width_px +
                            x / samples_per_side] += sample * share;
        }
    }
    return reference;
}

IsShaded shaded_by_rays(const render::RenderFrame& frame, assets::AssetLibrary& library) {
    if (!frame.sun || !frame.sun_shadow) return [](const Vec2f&) { return false; };
    const auto rays = std::make_shared<const render::RayScene>(frame, library);
    const float aspect =
        static_cast<float>(frame.width_px) / static_cast<float>(std::max(frame.height_px, 1U));
    return [rays, aspect, camera = frame.camera, to_sun = -frame.sun->direction_world](
               const Vec2f& at) {
        const Vec3f direction = ray_through(camera, aspect, at);
        const std::optional<render::RayHit> place =
            rays->first_hit(camera.position_world, direction);
        return place && rays->is_shaded(*place, to_sun);
    };
}

}  // namespace plumbline::study

// Local lights of a frame: which of them cast shadows, and the order in which the shaders read them.
#include "engine/render/renderer_impl.h"

#include <algorithm>

namespace plumbline::render {

std::uint32_t Renderer::Impl::light_shadow_px() const {
    const float size_px = static_cast<float>(frame->light_shadows->size_px) * quality.shadow_detail;
    return std::clamp(static_cast<std::uint32_t>(size_px), 32U, limits.texture_px / kLightFaces);
}

void Renderer::Impl::choose_light_shadows() {
    lights_in_order = frame->lights;
    light_shadow_numbers.clear();
    const bool wanted = frame->light_shadows && quality.shadowed_lights > 0;
    light_choice.choose(wanted ? std::span{frame->lights} : std::span<const LocalLight>{},
                        Frustum{block.clip_from_world},
                        frame->camera.position_world,
                        quality.shadowed_lights);
    const std::vector<ShadowedLight>& chosen = light_choice.chosen();
    stats.shadowed_lights = static_cast<std::uint32_t>(chosen.size());
    stats.unshadowed_lights = light_choice.left_out();
    if (chosen.empty()) return;
    features |= feature::kLightShadows;
    // Bits for the first ones, as many as cast.
    block.wind.w = static_cast<float>((1U << chosen.size()) - 1U);
    lights_in_order.clear();
    std::vector<bool> is_chosen(frame->lights.size());
    for (const ShadowedLight& one : chosen) {
        const LocalLight& light = frame->lights[one.light];
        lights_in_order.push_back(light);
        light_shadow_numbers.push_back(shadow_numbers(light, one.row, light_shadow_px()));
        is_chosen[one.light] = true;
    }
    for (std::size_t i = 0; i < frame->lights.size(); ++i) {
        if (!is_chosen[i]) lights_in_order.push_back(frame->lights[i]);
    }
}

}  // namespace plumbline::render

#include "engine/effects/effects.h"

namespace plumbline::effects {

namespace {

class SunShadow final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::ShadowDescription& shadow = *simulation.description().sun->shadow;
        frame.sun_shadow =
            render::SunShadow{.size_px = static_cast<std::uint32_t>(shadow.size_px),
                              .distance_m = static_cast<float>(shadow.distance_m),
                              .cascades = static_cast<std::uint32_t>(shadow.cascades)};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

class Flashlight final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override {
        const scene::FlashlightDescription& light = *simulation.description().flashlight;
        const Quatf orientation(view.world_from_hand.orientation);
        frame.flashlight =
            render::Flashlight{.position_world = Vec3f(view.world_from_hand.position),
                               .direction_world = orientation * Vec3f{0.0F, 0.0F, -1.0F},
                               .intensity = light.color * light.intensity,
                               .radius_m = light.radius_m,
                               .inner_rad = radians_from_degrees(light.inner_deg),
                               .outer_rad = radians_from_degrees(light.outer_deg)};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

class Fog final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::FogDescription fog =
            simulation.description().fog.value_or(scene::FogDescription{});
        frame.fog = render::Fog{.color = fog.color * simulation.switches.light_scale,
                                .density_per_m = fog.density_per_m};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

class Skybox final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        frame.sky = render::Sky{.folder = simulation.description().sky->folder,
                                .brightness = simulation.switches.light_scale};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

class Post final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::PostDescription& post = *simulation.description().post;
        frame.post = render::Post{.exposure = post.exposure, .bloom = post.bloom};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

}  // namespace

std::unique_ptr<Effect> make_sun_shadow(scene::Simulation&) {
    return std::make_unique<SunShadow>();
}
std::unique_ptr<Effect> make_flashlight(scene::Simulation&) {
    return std::make_unique<Flashlight>();
}
std::unique_ptr<Effect> make_fog(scene::Simulation&) {
    return std::make_unique<Fog>();
}
std::unique_ptr<Effect> make_skybox(scene::Simulation&) {
    return std::make_unique<Skybox>();
}
std::unique_ptr<Effect> make_post(scene::Simulation&) {
    return std::make_unique<Post>();
}

}  // namespace plumbline::effects

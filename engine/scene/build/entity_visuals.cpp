// What of an entity is seen and heard.
#include "engine/scene/build/entity_builder.h"

namespace plumbline::scene {
namespace {

LampAppearance dark_look_of(assets::AssetLibrary& library,
                            const std::vector<assets::MaterialId>& materials) {
    LampAppearance look;
    for (const assets::MaterialId id : materials) {
        assets::MaterialData dark = library.material(id);
        dark.emissive = Vec3f{0.0F};
        look.off.push_back(library.add_material(std::move(dark)));
    }
    return look;
}

}  // namespace

void EntityBuilder::add_visual(const EntityDescription& description,
                               const Appearance& appearance,
                               ecs::Entity entity) {
    ecs::Registry& registry = simulation_.registry;
    if (appearance.mesh != assets::MeshId{}) {
        const bool is_static =
            !description.body || description.body->kind == physics::BodyKind::Static;
        registry.add<Visual>(entity,
                             Visual{.mesh = appearance.mesh,
                                    .materials = appearance.materials,
                                    .casts_shadow = description.casts_shadow,
                                    .is_static = is_static});
        if (description.light)
            registry.add<LampAppearance>(entity,
                                         dark_look_of(simulation_.library(), appearance.materials));
    }
    if (!description.contact_material.empty()) {
        registry.add<ContactAppearance>(
            entity, ContactAppearance{.material = material_named(description.contact_material)});
    }
}

void EntityBuilder::add_sound(const SoundDescription& sound, ecs::Entity entity) {
    simulation_.registry.add<AmbientSound>(entity,
                                           AmbientSound{.file = sound.file,
                                                        .gain = sound.gain,
                                                        .radius_m = sound.radius_m,
                                                        .loop = sound.loop,
                                                        .by_wind = sound.by_wind,
                                                        .by_flow = sound.by_flow});
}

void EntityBuilder::add_trigger(const EntityDescription& description, ecs::Entity entity) {
    const auto* primitive = std::get_if<Primitive>(&description.visual);
    if (primitive == nullptr) return;
    std::vector<std::string> notes;
    const Result<BuiltShape> shape =
        shapes_.make(scaled(shape_of_primitive(*primitive), description.scale), notes);
    if (!shape) return warn_once(shape.error().message);
    Vec3 min{0, 0, 0};
    Vec3 max{0, 0, 0};
    bounds_of(scaled(shape_of_primitive(*primitive), description.scale), min, max);
    const Vec3d size_m(max - min);
    simulation_.registry.add<TriggerVolume>(
        entity,
        TriggerVolume{.shape = shape->id,
                      .radius_m = glm::length(glm::max(glm::abs(Vec3d(min)), glm::abs(Vec3d(max)))),
                      .thinnest_m = std::min({size_m.x, size_m.y, size_m.z}),
                      .says = *description.trigger,
                      .times_left = description.trigger->times});
}

}  // namespace plumbline::scene

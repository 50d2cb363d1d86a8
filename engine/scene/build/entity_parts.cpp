// Bodies of what moves in a model, part by part.
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/model_bodies.h"

#include <fmt/format.h>

#include <utility>

namespace plumbline::scene {

const assets::MovingModel* EntityBuilder::moving_parts_of(const EntityDescription& description,
                                                          const Appearance& appearance) const {
    if (!description.body || description.body->kind != physics::BodyKind::Kinematic) return nullptr;
    if (!appearance.is_model || !std::holds_alternative<FitShape>(description.body->shape))
        return nullptr;
    return simulation_.library().moving(appearance.model);
}

Result<Done> EntityBuilder::build_parts(const EntityDescription& whole,
                                        const std::string& name,
                                        const assets::MovingModel& model,
                                        std::uint16_t surface,
                                        ecs::Entity entity) {
    EntityDescription part = whole;
    part.visual = {};
    part.scale = {1, 1, 1};
    part.light.reset();
    part.sound.reset();
    part.motion.reset();
    part.body->friction =
        whole.body->friction.value_or(simulation_.surfaces().get(surface).friction);
    part.body->restitution =
        whole.body->restitution.value_or(simulation_.surfaces().get(surface).restitution);
    const assets::ModelPose rest = assets::rest_pose(model.data);
    PartBodies bodies;
    for (PartShape& shape : part_shapes_of(model, whole.scale)) {
        part.world_from_body =
            part_pose(rest.model_from_node[shape.node], whole.scale, whole.world_from_body);
        part.body->shape = physics::ShapeDef{std::move(shape.hull)};
        const Result<ecs::Entity> made = build(part, fmt::format("{}/{}", name, shape.name));
        if (!made) return made.error();
        simulation_.registry.get<SurfaceRef>(*made).surface = surface;
        bodies.parts.push_back({.node = shape.node, .entity = *made});
    }
    simulation_.registry.add<PartBodies>(entity, std::move(bodies));
    return Done{};
}

}  // namespace plumbline::scene

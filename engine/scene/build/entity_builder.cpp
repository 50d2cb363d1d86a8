#include "engine/scene/build/entity_builder.h"

#include "engine/assets/primitives.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::scene {

namespace {

constexpr Real kLeastInertia = 0.05_r;  ///< of the inertia of a ball that fits in

// By reference: a cast of a value would be idle in the float build, and warned of.
float narrow(const Real& value) {
    return static_cast<float>(value);
}

struct MeshOfPrimitive {
    std::string name;
    assets::MeshData mesh;
};

MeshOfPrimitive mesh_of_primitive(const Primitive& primitive) {
    struct Maker {
        MeshOfPrimitive operator()(const physics::BoxShape& s) const {
            return {fmt::format("box {} {} {}", s.size_m.x, s.size_m.y, s.size_m.z),
                    assets::box_mesh(Vec3f(s.size_m))};
        }
        MeshOfPrimitive operator()(const physics::SphereShape& s) const {
            return {fmt::format("sphere {}", s.radius_m), assets::sphere_mesh(narrow(s.radius_m))};
        }
        MeshOfPrimitive operator()(const physics::CylinderShape& s) const {
            return {fmt::format("cylinder {} {}", s.radius_m, s.height_m),
                    assets::cylinder_mesh(narrow(s.radius_m), narrow(s.height_m))};
        }
        MeshOfPrimitive operator()(const physics::CapsuleShape& s) const {
            return {fmt::format("capsule {} {}", s.radius_m, s.height_m),
                    assets::capsule_mesh(narrow(s.radius_m), narrow(s.height_m))};
        }
        MeshOfPrimitive operator()(const physics::ConeShape& s) const {
            return {fmt::format("cone {} {}", s.radius_m, s.height_m),
                    assets::cone_mesh(narrow(s.radius_m), narrow(s.height_m))};
        }
        MeshOfPrimitive operator()(const physics::PlaneShape& s) const {
            return {fmt::format("plane {} {}", s.size_m.x, s.size_m.y),
                    assets::plane_mesh(Vec2f(s.size_m))};
        }
    };
    return std::visit(Maker{}, primitive);
}

std::string place_of(const EntityDescription& description, const std::string& name) {
    if (description.location.line <= 0) return "entity " + name;
    return fmt::format("{}: entity {}", to_string(description.location), name);
}

PointLight light_of(const LightDescription& light) {
    return {.on = light.on,
            .intensity = light.color * light.intensity,
            .radius_m = light.radius_m,
            .is_spot = light.is_spot,
            .direction_body = normalize_or(light.direction, Vec3f{0.0F, -1.0F, 0.0F}),
            .inner_rad = radians_from_degrees(light.inner_deg),
            .outer_rad = radians_from_degrees(light.outer_deg),
            .offset_body = Vec3f(light.offset_m),
            .casts_shadow = light.shadow};
}

}  // namespace

EntityBuilder::EntityBuilder(Simulation& simulation)
    : simulation_(simulation), shapes_(simulation.physics) {}

void EntityBuilder::warn_once(const std::string& text) {
    const std::vector<std::string>& known = simulation_.warnings;
    if (std::find(known.begin(), known.end(), text) == known.end())
        simulation_.warnings.push_back(text);
}

void EntityBuilder::lend_materials(const std::map<std::string, assets::MaterialData>& materials) {
    lent_ = materials;
}

const assets::MaterialData* EntityBuilder::described_material(const std::string& name) const {
    const auto& own = simulation_.description().materials;
    if (const auto found = own.find(name); found != own.end()) return &found->second;
    const auto found = lent_.find(name);
    return found != lent_.end() ? &found->second : nullptr;
}

assets::MaterialId EntityBuilder::material_named(const std::string& name) {
    if (const auto known = materials_.find(name); known != materials_.end()) return known->second;
    assets::MaterialData material;
    if (const assets::MaterialData* described = described_material(name)) material = *described;
    material.name = name;
    const assets::MaterialId id = simulation_.library().add_material(std::move(material));
    materials_.emplace(name, id);
    return id;
}

EntityBuilder::Appearance EntityBuilder::placeholder_for(const EntityDescription& description) {
    Vec3 min{-0.5_r};
    Vec3 max{0.5_r};
    if (description.body) {
        if (const auto* shape = std::get_if<physics::ShapeDef>(&description.body->shape)) {
            bounds_of(*shape, min, max);
        }
    }
    const Vec3 size_m = max - min;
    assets::MeshData mesh = assets::box_mesh(Vec3f(size_m));
    const Vec3 center = (min + max) * 0.5_r;
    for (assets::Vertex& vertex : mesh.vertices) vertex.position_body += Vec3f(center);
    mesh.bounds = assets::bounds_of(mesh);
    const std::string name =
        fmt::format("placeholder {} {} {} {} {} {}", min.x, min.y, min.z, max.x, max.y, max.z);

    assets::MaterialId& material = materials_["(placeholder)"];
    if (material == assets::MaterialId{}) {
        material = simulation_.library().add_material(
            {.name = "(placeholder)", .base_color = {0.8F, 0.0F, 0.8F}, .roughness = 1.0F});
    }
    return {.mesh = simulation_.library().add_mesh(name, std::move(mesh)), .materials = {material}};
}

EntityBuilder::Appearance EntityBuilder::appearance_of_model(const EntityDescription& description,
                                                             const ModelVisual& visual) {
    if (refused_models_.contains(visual.file)) return placeholder_for(description);
    const Result<assets::Model> model = simulation_.library().model(visual.file, visual.root);
    if (!model) {
        refused_models_.insert(visual.file);
        simulation_.warnings.push_back(fmt::format("{}: a box stands for its model: {}",
                                                   place_of(description, description.name),
                                                   model.error().message));
        return placeholder_for(description);
    }
    Appearance appearance{
        .mesh = model->mesh, .materials = model->materials, .model = model->id, .is_model = true};
    if (visual.body) {  // has a shape of its own, and no animation
        const bool is_there = *visual.body < model->bodies.size();
        appearance.mesh = is_there ? model->bodies[*visual.body] : assets::MeshId{};
        appearance.model = {};
        appearance.is_model = false;
    }
    for (assets::MaterialId& material : appearance.materials) {
        const std::string& own_name = simulation_.library().material(material).name;
        if (!description.material.empty()) {
            material = material_named(description.material);
        } else if (described_material(own_name) != nullptr) {
            material = material_named(own_name);
        }
    }
    return appearance;
}

EntityBuilder::Appearance EntityBuilder::appearance_of(const EntityDescription& description) {
    if (const auto* model = std::get_if<ModelVisual>(&description.visual)) {
        return appearance_of_model(description, *model);
    }
    if (const auto* visual = std::get_if<MeshVisual>(&description.visual)) {
        return {.mesh = simulation_.library().add_mesh(visual->key, *visual->mesh),
                .materials = {material_named(description.material)}};
    }
    if (const auto* primitive = std::get_if<Primitive>(&description.visual)) {
        MeshOfPrimitive made = mesh_of_primitive(*primitive);
        return {.mesh = simulation_.library().add_mesh(made.name, std::move(made.mesh)),
                .materials = {material_named(description.material)}};
    }
    return {};
}

std::uint16_t EntityBuilder::surface_of(const EntityDescription& description,
                                        const Appearance& appearance) const {
    if (const assets::MaterialData* named = described_material(description.material))
        return simulation_.surfaces().find(named->surface);
    if (appearance.materials.empty()) return 0;
    return simulation_.surfaces().find(
        simulation_.library().material(appearance.materials.front()).surface);
}

Result<BuiltShape> EntityBuilder::shape_of(const EntityDescription& description,
                                           const Appearance& appearance) {
    const BodyDescription& body = *description.body;
    std::vector<std::string> notes;
    const auto make = [&]() -> Result<BuiltShape> {
        if (const auto* shape = std::get_if<physics::ShapeDef>(&body.shape)) {
            return shapes_.make(scaled(*shape, description.scale), notes);
        }
        if (const auto* primitive = std::get_if<Primitive>(&description.visual)) {
            return shapes_.make(scaled(shape_of_primitive(*primitive), description.scale), notes);
        }
        if (appearance.is_model) {
            const bool as_hull = std::holds_alternative<ModelHullShape>(body.shape) ||
                                 (std::holds_alternative<FitShape>(body.shape) &&
                                  body.kind == physics::BodyKind::Dynamic);
            const assets::MovingModel* moving = moving_parts_of(description, appearance);
            const assets::MeshId mesh = moving != nullptr ? moving->still : appearance.mesh;
            return shapes_.make_from_model(
                simulation_.library().mesh(mesh), mesh.value, as_hull, description.scale, notes);
        }
        if (std::holds_alternative<ModelVisual>(description.visual)) {
            return shapes_.make(scaled(physics::BoxShape{}, description.scale), notes);
        }
        return Error{"a body without a shape needs a model or a primitive to fit one to",
                     ExitCode::Refused};
    };
    Result<BuiltShape> built = make();
    for (const std::string& note : notes) {
        warn_once(fmt::format("{}: {}", place_of(description, description.name), note));
    }
    return built;
}

/// Every solid body's moments are above those of a ball that fits into it. Contacts would turn one whose
/// file says far less away under them.
std::optional<Vec3> EntityBuilder::inertia_of(const EntityDescription& description,
                                              Real mass_kg,
                                              const BuiltShape& shape) {
    const std::optional<Vec3>& given = description.body->inertia_kgm2;
    if (!given || description.body->kind != physics::BodyKind::Dynamic) return given;
    const Real ball_kgm2 = 0.4_r * mass_kg * shape.inner_radius_m * shape.inner_radius_m;
    const Vec3 taken = glm::max(*given, Vec3(kLeastInertia * ball_kgm2));
    if (taken != *given) {
        warn_once(fmt::format(
            "{}: a moment of inertia of {:g} kg m2, where a ball that fits into it has "
            "{:.3g}: {:.3g} is used, as with less it would turn through what it lies on",
            place_of(description, description.name),
            std::min({given->x, given->y, given->z}),
            ball_kgm2,
            kLeastInertia * ball_kgm2));
    }
    return taken;
}

Result<physics::BodyId> EntityBuilder::body_of(const EntityDescription& description,
                                               const Appearance& appearance,
                                               std::uint16_t surface_index,
                                               ecs::Entity entity) {
    const BodyDescription& body = *description.body;
    const Result<BuiltShape> shape = shape_of(description, appearance);
    if (!shape) return shape.error();
    const Result<physics::CollisionFilter> filter = groups_.filter_of(body);
    if (!filter) return filter.error();
    const Surface& surface = simulation_.surfaces().get(surface_index);
    const Result<std::vector<physics::PartTraits>> parts = groups_.parts_of(body, surface);
    if (!parts) return parts.error();

    Real mass_kg = body.mass_kg.value_or(body.density_kgpm3.value_or(surface.density_kgpm3) *
                                         shape->volume_m3);
    const bool is_dynamic = body.kind == physics::BodyKind::Dynamic;
    if (is_dynamic && !(mass_kg >= static_cast<Real>(limits::kMassMin_kg))) {
        warn_once(fmt::format("{}: its volume and density give {} kg; {} kg is used",
                              place_of(description, description.name),
                              mass_kg,
                              limits::kMassMin_kg));
        mass_kg = static_cast<Real>(limits::kMassMin_kg);
    }
    const physics::BodyId id = simulation_.physics.create_body(
        {.kind = body.kind,
         .shape = shape->id,
         .world_from_body = description.world_from_body,
         .mass_kg = is_dynamic ? mass_kg : Real{0},
         .inertia_kgm2 = inertia_of(description, mass_kg, *shape),
         .body_from_inertia = body.body_from_inertia,
         .center_of_mass_m = body.center_of_mass_m,
         .velocity_mps = body.velocity_mps,
         .angular_velocity_radps = body.angular_velocity_radps,
         .surface_velocity_mps = body.surface_velocity_mps,
         .surface_spin_radps = body.surface_spin_radps,
         .friction = body.friction.value_or(surface.friction),
         .rolling_friction = body.rolling_friction,
         .spinning_friction = body.spinning_friction,
         .restitution = body.restitution.value_or(surface.restitution),
         .friction_rule = body.friction_rule,
         .restitution_rule = body.restitution_rule,
         .linear_damping_per_s = body.linear_damping_per_s,
         .angular_damping_per_s = body.angular_damping_per_s,
         .linear_factor = body.linear_factor,
         .gravity_factor = body.gravity_factor,
         .can_sleep = body.can_sleep,
         .ccd = body.ccd,
         .contact_events = (is_dynamic && simulation_.surfaces().is_heard(surface_index)) ||
                           !description.contact_material.empty(),
         .filter = *filter,
         .parts = *parts,
         .user = mark_of(entity)});
    if (body.kind != physics::BodyKind::Static) track(description, entity, id, *shape);
    return id;
}

void EntityBuilder::track(const EntityDescription& description,
                          ecs::Entity entity,
                          physics::BodyId body,
                          const BuiltShape& shape) {
    ecs::Registry& registry = simulation_.registry;
    const Pose& start = description.world_from_body;
    registry.add<PreviousTransform>(entity, PreviousTransform{.world_from_body = start});
    simulation_.bodies_.moving.push_back({.entity = entity,
                                          .body = body,
                                          .kind = description.body->kind,
                                          .shape = shape.id,
                                          .convex = shape.convex,
                                          .inner_radius_m = shape.inner_radius_m});
    if (!description.motion || description.body->kind != physics::BodyKind::Kinematic) return;
    MotionPath path{.points_m = {},
                    .period_s = description.motion->period_s,
                    .spin_radps = description.motion->spin_radps,
                    .start = start};
    for (const Vec3& offset : description.motion->points_m) {
        // A tour begins where the body stands, whether or not its points say so.
        if (path.points_m.empty() && offset != Vec3{0, 0, 0}) {
            path.points_m.push_back(start.position);
        }
        path.points_m.push_back(start.position + offset);
    }
    registry.add<MotionPath>(entity, std::move(path));
}

Result<ecs::Entity> EntityBuilder::build(const EntityDescription& description,
                                         const std::string& name) {
    const Appearance appearance = appearance_of(description);
    const std::uint16_t surface = surface_of(description, appearance);
    ecs::Registry& registry = simulation_.registry;
    const ecs::Entity entity = registry.create();
    const assets::MovingModel* moving = moving_parts_of(description, appearance);
    if (description.body && (moving == nullptr || moving->still != assets::MeshId{})) {
        const Result<physics::BodyId> body = body_of(description, appearance, surface, entity);
        if (!body) {
            registry.destroy(entity);
            return Error{fmt::format("{}: {}", place_of(description, name), body.error().message),
                         ExitCode::Refused};
        }
        registry.add<BodyRef>(entity, BodyRef{.body = *body});
        if (description.body->drag) registry.add<Drag>(entity, *description.body->drag);
        if (description.body->surface_velocity_mps != Vec3{0, 0, 0} ||
            description.body->surface_spin_radps != Vec3{0, 0, 0})
            registry.add<Belt>(entity, Belt{});
        if (description.body->magnet) registry.add<Magnet>(entity, *description.body->magnet);
    }
    registry.add<Name>(entity, Name{.text = name, .label = description.label});
    registry.add<Transform>(
        entity,
        Transform{.world_from_body = description.world_from_body, .scale = description.scale});
    registry.add<SurfaceRef>(entity, SurfaceRef{.surface = surface});
    if (description.location.line > 0) {
        registry.add<DescribedAt>(entity, description.location);
    }
    add_visual(description, appearance, entity);
    if (description.body && description.body->fracture)
        simulation_.add_whole(description, name, entity);
    if (description.trigger) add_trigger(description, entity);
    if (description.plaque)
        simulation_.registry.add<Plaque>(entity, Plaque{.says = *description.plaque});
    if (simulation_.library().moving(appearance.model) != nullptr) {
        registry.add<PlayingModel>(entity, PlayingModel{.model = appearance.model});
    }
    if (description.light) registry.add<PointLight>(entity, light_of(*description.light));
    if (description.sound) add_sound(*description.sound, entity);
    if (moving != nullptr) {
        const Result<Done> made = build_parts(description, name, *moving, surface, entity);
        if (!made) {
            registry.destroy(entity);
            return made.error();
        }
    }
    simulation_.names_.entities.insert_or_assign(name, entity);
    ++simulation_.revision_;
    return entity;
}

}  // namespace plumbline::scene

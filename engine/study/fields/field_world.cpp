#include "engine/study/fields/field_world.h"

#include "engine/core/assert.h"
#include "engine/core/time/stopwatch.h"
#include "engine/physics/totals.h"

#include <utility>

namespace plumbline::study {
namespace {

scene::EntityDescription body_of(const std::string& name,
                                 const Vec3& position_m,
                                 const scene::Primitive& primitive,
                                 double mass_kg) {
    scene::EntityDescription entity;
    entity.name = name;
    entity.world_from_body.position = position_m;
    entity.visual = primitive;
    entity.body = scene::BodyDescription{.mass_kg = static_cast<Real>(mass_kg)};
    return entity;
}

scene::SurfaceTable one_surface() {
    scene::SurfaceTable table;
    table.surfaces.push_back({.name = "default"});
    return table;
}

PlayedScene played(const scene::OpenedScene& opened, assets::AssetLibrary& library) {
    Result<PlayedScene> made = PlayedScene::create(opened, library);
    PL_ASSERT(made.ok(), "a reference's scene that can be built");
    return std::move(*made);
}

}  // namespace

scene::EntityDescription ball_of(const std::string& name,
                                 const Vec3& position_m,
                                 double radius_m,
                                 double mass_kg) {
    return body_of(name, position_m, physics::SphereShape{static_cast<Real>(radius_m)}, mass_kg);
}

scene::EntityDescription box_of(const std::string& name,
                                const Vec3& position_m,
                                const Vec3& size_m,
                                double mass_kg) {
    return body_of(name, position_m, physics::BoxShape{size_m}, mass_kg);
}

scene::EntityDescription floor_of(const Vec3& size_m) {
    scene::EntityDescription floor = box_of("floor", {0, -size_m.y / 2, 0}, size_m, 1);
    floor.body->kind = physics::BodyKind::Static;
    return floor;
}

FieldWorld::FieldWorld(const scene::SceneDescription& description)
    : library_(std::make_unique<assets::AssetLibrary>()),
      played_(played({.description = description, .surfaces = one_surface()}, *library_)) {
    played_.start();
}

void FieldWorld::step() {
    const CpuTimer timer;
    played_.step();
    cpu_ms_ += timer.ms();
}

void FieldWorld::run_to(double seconds) {
    while (time_s() < seconds - 1e-9) step();
}

physics::BodyState FieldWorld::state(const std::string& name) const {
    const ecs::Entity entity = simulation().find(name);
    return simulation().physics.state(simulation().registry.get<scene::BodyRef>(entity).body);
}

double FieldWorld::energy_J() const {
    double sum = physics::energy(simulation().physics).total_J();
    for (const physics::ForceField* field : simulation().force_fields.all())
        sum += field->energy_J();
    return sum;
}

}  // namespace plumbline::study

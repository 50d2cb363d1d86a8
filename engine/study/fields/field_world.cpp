#include "engine/study/fields/field_world.h"

#include "engine/core/assert.h"
#include "engine/core/time/stopwatch.h"
#include "engine/effects/advance.h"
#include "engine/physics/totals.h"

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

FieldWorld::FieldWorld(const scene::SceneDescription& description) {
    auto built = scene::build_simulation(description, {}, library_, one_surface());
    PL_ASSERT(built.ok(), "a reference's scene that can be built");
    simulation_ = std::move(*built);
    effects_ = std::make_unique<effects::EffectRuntime>(*simulation_, effects::ServedDomains{});
}

void FieldWorld::step() {
    const CpuTimer timer;
    effects::advance(*simulation_, *effects_, game_, {});
    cpu_ms_ += timer.ms();
}

void FieldWorld::run_to(double seconds) {
    while (time_s() < seconds - 1e-9) step();
}

physics::BodyState FieldWorld::state(const std::string& name) const {
    const ecs::Entity entity = simulation_->find(name);
    return simulation_->physics.state(simulation_->registry.get<scene::BodyRef>(entity).body);
}

double FieldWorld::energy_J() const {
    double sum = physics::energy(simulation_->physics).total_J();
    for (const physics::ForceField* field : simulation_->force_fields.all())
        sum += field->energy_J();
    return sum;
}

}  // namespace plumbline::study

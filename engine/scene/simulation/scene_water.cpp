#include "engine/scene/simulation/scene_water.h"

#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/water_mesh.h"

#include <fmt/format.h>

namespace plumbline::scene {
namespace {

/// Of all triangles but those that look like water, which holds none.
std::vector<Vec3d> world_corners(const assets::AssetLibrary& library,
                                 const Visual& visual,
                                 const Transform& transform) {
    std::vector<Vec3d> corners_m;
    const assets::MeshData& mesh = library.mesh(visual.mesh);
    for (const assets::SubMesh& part : mesh.sub_meshes) {
        if (part.material < visual.materials.size() &&
            library.material(visual.materials[part.material]).ripple_slope > 0)
            continue;
        for (std::uint32_t i = 0; i < part.index_count; ++i) {
            const assets::Vertex& vertex = mesh.vertices[mesh.indices[part.first_index + i]];
            const Vec3 scaled = Vec3(vertex.position_body) * transform.scale;
            const Pose& pose = transform.world_from_body;
            corners_m.emplace_back(pose.position + pose.orientation * scaled);
        }
    }
    return corners_m;
}

Result<Basin> basin_of(const Simulation& simulation, const WaterDescription& description) {
    const auto refuse = [&description](const std::string& why) {
        return Error{fmt::format("{}: water {}: basin {}: {}",
                                 to_string(description.location),
                                 description.name,
                                 description.basin,
                                 why),
                     ExitCode::Refused};
    };
    const ecs::Entity entity = simulation.find(description.basin);
    if (!simulation.registry.alive(entity)) return refuse("no entity has this name");
    const auto* visual = simulation.registry.find<Visual>(entity);
    const auto* transform = simulation.registry.find<Transform>(entity);
    if (visual == nullptr || transform == nullptr) return refuse("it has no mesh");
    Basin basin(world_corners(simulation.library(), *visual, *transform),
                static_cast<double>(description.max_m.y));
    if (basin.is_empty())
        return refuse(fmt::format(
            "it holds no water at level_m = {:g}: nothing of its inside lies below that, "
            "or the water would run out",
            description.max_m.y));
    return basin;
}

Result<ecs::Entity> draw_surface(Simulation& simulation,
                                 const WaterDescription& description,
                                 const SceneWater& water) {
    EntityDescription seen;
    seen.visual = physics::BoxShape{};
    seen.material = description.material;
    seen.label = "water";
    seen.location = description.location;
    seen.casts_shadow = false;
    const Result<ecs::Entity> entity =
        simulation.builder().build(seen, description.name + "/surface");
    if (!entity) return entity;
    const std::uint32_t cells = description.surface == WaterSurface::Waves ? kWaterCells : 1;
    assets::MeshData mesh =
        water.basin ? water_mesh(*water.basin) : water_mesh(water.min_m, water.max_m, cells);
    // By name: a scene that starts anew takes the mesh that it had.
    const assets::MeshId id =
        simulation.library().add_mesh(fmt::format("water {}", entity->index), {});
    assets::MeshData& place = simulation.library().change_mesh(id);
    mesh.version = place.version + 1;
    place = std::move(mesh);
    auto& visual = simulation.registry.get<Visual>(*entity);
    visual.mesh = id;
    visual.is_static = description.surface == WaterSurface::Flat;
    return entity;
}

}  // namespace

Result<Done> add_water(Simulation& simulation, const WaterDescription& description) {
    SceneWater water{.min_m = Vec3d(description.min_m), .max_m = Vec3d(description.max_m)};
    if (!description.basin.empty()) {
        Result<Basin> basin = basin_of(simulation, description);
        if (!basin) return basin.error();
        water.min_m = basin->min_m();
        water.max_m = basin->max_m();
        water.basin = std::move(*basin);
    }
    if (!description.material.empty()) {
        const Result<ecs::Entity> surface = draw_surface(simulation, description, water);
        if (!surface) return surface.error();
        water.surface = *surface;
    }
    simulation.waters.push_back(std::move(water));
    return Done{};
}

}  // namespace plumbline::scene

#include "engine/scene/simulation/deformable_look.h"

#include <fmt/format.h>

namespace plumbline::scene {

void show(Simulation& simulation, const SceneDeformable& each, assets::MeshData mesh) {
    auto& visual = simulation.registry.get<Visual>(each.entity);
    // By name: a scene that starts anew takes the mesh that it had.
    visual.mesh =
        simulation.library().add_mesh(fmt::format("deformable {}", each.entity.index), {});
    visual.is_static = false;
    assets::MeshData& place = simulation.library().change_mesh(visual.mesh);
    mesh.version = place.version;
    place = std::move(mesh);
    each.shape_mesh(each.before_m, place);
}

}  // namespace plumbline::scene

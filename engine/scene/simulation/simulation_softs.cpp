// The soft bodies of a running scene.
#include "engine/physics/soft_grid.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/soft_mesh.h"
#include "engine/scene/simulation.h"
#include "engine/scene/simulation/deformable_look.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::scene {
namespace {

/// Sub-steps times cells that a second of simulated time may take at draft, balanced and precise.
constexpr std::array kSoftWork_ps{1e5, 4e5, 2e6};
constexpr std::array kSoftCellsAlong{4.0, 6.0, 10.0};
constexpr double kThickness_m = 1e-3;
constexpr std::uint32_t kMostCellsAlong = 100;

std::uint32_t count_of(double size_m, double cell_m, double fewest) {
    return static_cast<std::uint32_t>(
        std::clamp(std::round(size_m / cell_m), fewest, static_cast<double>(kMostCellsAlong)));
}

/// What it is made of, in its own frame. A model that is not closed, or finer than its cells: a box.
physics::SoftGrid grid_of(const SoftDescription& soft,
                          std::size_t fidelity,
                          const assets::MeshData* model) {
    const bool is_model = model != nullptr && !model->indices.empty();
    const Vec3d low = is_model ? Vec3d(model->bounds.min) : soft.size_m * -0.5;
    const Vec3d high = is_model ? Vec3d(model->bounds.max) : soft.size_m * 0.5;
    const Vec3d size_m = high - low;
    const double longest_m = std::max({size_m.x, size_m.y, size_m.z});
    const double twice = soft.form == SoftForm::Ellipsoid ? 2 : 1;  // half axes
    const double cell_m = soft.cell_m.value_or(longest_m * twice / kSoftCellsAlong[fidelity]);
    if (soft.form == SoftForm::Ellipsoid)
        return physics::ellipsoid_grid(soft.size_m,
                                       {count_of(2 * size_m.x, cell_m, 2),
                                        count_of(2 * size_m.y, cell_m, 2),
                                        count_of(2 * size_m.z, cell_m, 2)});
    if (is_model) {
        const double least_m = longest_m / kMostCellsAlong;
        physics::SoftGrid grid =
            physics::voxel_grid(low, high, std::max(cell_m, least_m), [model](const Vec3d& at) {
                return is_inside(*model, at);
            });
        if (!grid.cells.empty()) return grid;
    }
    physics::SoftGrid grid = physics::box_grid(size_m,
                                               {count_of(size_m.x, cell_m, 1),
                                                count_of(size_m.y, cell_m, 1),
                                                count_of(size_m.z, cell_m, 1)});
    for (Vec3d& point : grid.points_m) point += (low + high) / 2.0;
    return grid;
}

/// What lies in its box.
void add_soft_pins(const SoftPinDescription& pin,
                   const physics::SoftGrid& grid,
                   physics::BodyId to,
                   std::vector<physics::DeformablePin>& pins) {
    for (std::size_t i = 0; i < grid.points_m.size(); ++i) {
        const Vec3d& at = grid.points_m[i];
        const bool is_in = glm::all(glm::greaterThanEqual(at, Vec3d(pin.min_m))) &&
                           glm::all(glm::lessThanEqual(at, Vec3d(pin.max_m)));
        if (is_in) pins.push_back({.point = i, .to = to});
    }
}

EntityDescription look_of(const SoftDescription& soft) {
    EntityDescription seen;
    seen.visual = physics::BoxShape{};
    if (soft.form == SoftForm::Model)
        seen.visual = ModelVisual{.file = soft.model, .root = soft.model_root};
    seen.material = soft.material;
    seen.label = "soft body";
    seen.location = soft.location;
    return seen;
}

}  // namespace

Result<Done> Simulation::add_soft(const SoftDescription& description) {
    const auto fidelity = static_cast<std::size_t>(description_.forces.fidelity.soft);
    const Result<ecs::Entity> entity = builder_->build(look_of(description), description.name);
    if (!entity) return entity.error();
    const assets::MeshData* model = description.form == SoftForm::Model
                                        ? &library_.mesh(registry.get<Visual>(*entity).mesh)
                                        : nullptr;
    const assets::MeshData rest = model != nullptr ? *model : assets::MeshData{};
    const physics::SoftGrid local = grid_of(description, fidelity, model);
    physics::SoftGrid grid = local;
    const Quatd turn(description.pose.orientation);
    for (Vec3d& point : grid.points_m) point = Vec3d(description.pose.position) + turn * point;
    physics::DeformableDef def{
        .surface = {.thickness_m = kThickness_m, .friction = description.friction},
        .substeps_per_s = kSoftWork_ps[fidelity] / static_cast<double>(grid.cells.size()),
        .pins = {}};
    for (const SoftPinDescription& pin : description.pins) {
        const auto holder =
            holder_of(pin.to, "soft body " + description.name, description.location);
        if (!holder) return holder.error();
        add_soft_pins(pin, grid, *holder, def.pins);
    }
    auto owned = std::make_unique<physics::SoftBody>(
        physics::SoftBodyDef{.grid = std::move(grid),
                             .density_kgpm3 = description.density_kgpm3,
                             .young_Pa = description.young_Pa,
                             .poisson = description.poisson,
                             .damping_s = description.damping_s});
    const physics::SoftBody& body = *owned;
    SceneDeformable soft{
        .name = description.name,
        .entity = *entity,
        .body = std::make_unique<physics::Deformable>(physics, std::move(owned), def),
        .before_m = {body.positions_m().begin(), body.positions_m().end()},
        .shape_mesh = {}};
    if (model != nullptr) {
        soft.shape_mesh = [skin = SoftModel(local, rest)](std::span<const Vec3d> points_m,
                                                          assets::MeshData& mesh) {
            skin.shape(points_m, mesh);
        };
        show(*this, soft, rest);
    } else {
        const SoftFaces faces(local);
        soft.shape_mesh = [faces](std::span<const Vec3d> points_m, assets::MeshData& mesh) {
            faces.shape(points_m, mesh);
        };
        show(*this, soft, faces.mesh());
    }
    bodies_.softs.push_back(std::move(soft));
    return Done{};
}

}  // namespace plumbline::scene

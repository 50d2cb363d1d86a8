// The cloths of a running scene.
#include "engine/scene/build/cloth_mesh.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/simulation.h"
#include "engine/scene/simulation/deformable_look.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::scene {
namespace {

/// Sub-steps times points that a second of simulated time may take at draft, balanced and precise: what fits into a few
/// milliseconds a step.
constexpr std::array kWork_ps{1.5e6, 3e6, 12e6};
constexpr std::array kCellsAlong{10.0, 20.0, 40.0};
constexpr double kFewestCells = 4;

/// As many along the longer side as the fidelity asks for, and as long as wide; two a fold at least.
std::array<std::uint32_t, 2> cells_of(const ClothDescription& cloth, std::size_t fidelity) {
    std::array<std::uint32_t, 2> cells{};
    const double cell_m = std::max(cloth.size_m[0], cloth.size_m[1]) / kCellsAlong[fidelity];
    const std::array fewest{std::max(kFewestCells, 2.0 * cloth.folds), kFewestCells};
    for (std::size_t i = 0; i < 2; ++i)
        cells[i] = cloth.cells ? static_cast<std::uint32_t>((*cloth.cells)[i])
                               : static_cast<std::uint32_t>(
                                     std::max(fewest[i], std::round(cloth.size_m[i] / cell_m)));
    return cells;
}

/// The points from one place to another.
void add_pins(const ClothPinDescription& pin,
              const std::array<std::uint32_t, 2>& cells,
              physics::BodyId to,
              std::vector<physics::DeformablePin>& pins) {
    const auto index = [&](std::size_t axis, double share) {
        return static_cast<std::size_t>(std::lround(share * cells[axis]));
    };
    for (std::size_t row = index(1, pin.along[1]); row <= index(1, pin.along[3]); ++row) {
        for (std::size_t column = index(0, pin.along[0]); column <= index(0, pin.along[2]);
             ++column)
            pins.push_back({.point = row * (cells[0] + 1) + column, .to = to});
    }
}

}  // namespace

Result<Done> Simulation::add_cloth(const ClothDescription& description) {
    const auto fidelity = static_cast<std::size_t>(description_.forces.fidelity.cloth);
    const std::array<std::uint32_t, 2> cells = cells_of(description, fidelity);
    const physics::SheetDef sheet_def{
        .size_m = description.size_m,
        .cells = cells,
        .folds = static_cast<std::uint32_t>(description.folds),
        .gather = description.gather,
        .position_m = Vec3d(description.pose.position),
        .orientation = Quatd(description.pose.orientation),
        .density_kgpm2 = description.density_kgpm2,
        .stretch_Npm = description.stretch_Npm,
        .shear_Npm = description.shear_Npm.value_or(description.stretch_Npm / 3),
        .bend_Nm = description.bend_Nm,
        .damping_s = description.damping_s,
        .drag = description.drag,
        .air_density_kgpm3 = static_cast<double>(description_.forces.air_density_kgpm3),
        .tear_Npm = description.tear_Npm};
    physics::DeformableDef def{
        .surface = {.thickness_m = description.thickness_m, .friction = description.friction},
        .self_collision = description.self_collision,
        .substeps_per_s = kWork_ps[fidelity] / ((cells[0] + 1) * (cells[1] + 1)),
        .asleep = description.asleep,
        .pins = {}};
    for (const ClothPinDescription& pin : description.pins) {
        const auto holder = holder_of(pin.to, "cloth " + description.name, description.location);
        if (!holder) return holder.error();
        add_pins(pin, cells, *holder, def.pins);
    }
    EntityDescription seen;
    seen.visual = physics::BoxShape{};
    seen.material = description.material;
    seen.label = "cloth";
    seen.location = description.location;
    const Result<ecs::Entity> entity = builder_->build(seen, description.name);
    if (!entity) return entity.error();
    auto owned = std::make_unique<physics::Sheet>(sheet_def);
    const physics::Sheet& sheet = *owned;
    const auto thickness_m = static_cast<float>(description.thickness_m);
    SceneDeformable cloth{
        .name = description.name,
        .entity = *entity,
        .body = std::make_unique<physics::Deformable>(physics, std::move(owned), def),
        .before_m = {sheet.positions_m().begin(), sheet.positions_m().end()},
        .shape_mesh = [&sheet, thickness_m](std::span<const Vec3d> points_m,
                                            assets::MeshData& mesh) {
            shape_cloth_mesh(sheet, points_m, thickness_m, mesh);
        }};
    show(*this, cloth, cloth_mesh(sheet));
    bodies_.cloths.push_back(std::move(cloth));
    return Done{};
}

}  // namespace plumbline::scene

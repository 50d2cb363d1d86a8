// Cloth.
#include "engine/physics/sheet.h"
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kSheet_kgpm2 = 0.2;
constexpr double kHigh_m = 3;

/// A strip that hangs from its upper edge, one metre long.
scene::ClothDescription strip() {
    scene::ClothDescription cloth;
    cloth.name = "strip";
    cloth.size_m = {0.2, 1};
    cloth.pose.position = {0, static_cast<Real>(kHigh_m - 0.5), 0};
    cloth.density_kgpm2 = kSheet_kgpm2;
    cloth.drag = 0;
    cloth.pins = {{.along = {0, 0, 1, 0}, .to = {}}};
    return cloth;
}

scene::SceneDescription cloth_scene(scene::Fidelity fidelity, scene::ClothDescription cloth) {
    scene::SceneDescription scene;
    scene.gravity_mps2 = {0, static_cast<Real>(-kFieldGravity_mps2), 0};
    scene.forces.fidelity.cloth = fidelity;
    scene.forces.cloths = {std::move(cloth)};
    return scene;
}

const physics::Sheet& sheet_of(const FieldWorld& world) {
    return dynamic_cast<const physics::Sheet&>(world.simulation().cloths().front().body->body());
}

/// Of the middle of its lower edge.
Vec3d low_end_m(const FieldWorld& world) {
    const physics::Sheet& sheet = sheet_of(world);
    return sheet.positions_m()[(sheet.rows() - 1) * sheet.columns() + sheet.columns() / 2];
}

FieldOutcome cloth_stretches_by_own_weight(scene::Fidelity fidelity) {
    scene::ClothDescription cloth = strip();
    cloth.stretch_Npm = 300;
    cloth.damping_s = 0.02;
    FieldWorld world(cloth_scene(fidelity, cloth));
    world.run_to(8);
    const double exact_m = kSheet_kgpm2 * kFieldGravity_mps2 / (2 * cloth.stretch_Npm);
    return {std::abs((kHigh_m - 1 - low_end_m(world).y) / exact_m - 1), world.cpu_ms_per_s()};
}

FieldOutcome cloth_stretches_by_load(scene::Fidelity fidelity) {
    constexpr double kLoad_kg = 0.5;
    scene::ClothDescription cloth = strip();
    cloth.stretch_Npm = 1000;
    cloth.damping_s = 0.1;
    cloth.pins.push_back({.along = {0, 1, 1, 1}, .to = "load"});
    scene::SceneDescription scene = cloth_scene(fidelity, cloth);
    const Vec3 start{0, static_cast<Real>(kHigh_m - 1), 0};
    scene.entities = {box_of("load", start, {0.2_r, 0.05_r, 0.05_r}, kLoad_kg)};
    FieldWorld world(scene);
    world.run_to(8);
    const double force_N = (kLoad_kg + kSheet_kgpm2 * 0.2 / 2) * kFieldGravity_mps2;
    const double exact_m = force_N / (cloth.stretch_Npm * 0.2);
    return {std::abs((kHigh_m - 1 - world.position_m("load").y) / exact_m - 1),
            world.cpu_ms_per_s()};
}

/// Its own weight pulls it along the edge that holds it.
FieldOutcome cloth_shears(scene::Fidelity fidelity) {
    scene::ClothDescription cloth = strip();
    cloth.size_m = {2, 0.1};
    cloth.pose.position.y = static_cast<Real>(kHigh_m - 0.05);
    cloth.cells = {{20, 2}};
    cloth.stretch_Npm = 2000;
    cloth.shear_Npm = 50;
    cloth.damping_s = 0.02;
    scene::SceneDescription scene = cloth_scene(fidelity, cloth);
    scene.gravity_mps2 = {static_cast<Real>(kFieldGravity_mps2), 0, 0};
    FieldWorld world(scene);
    world.run_to(8);
    const double exact_m = kSheet_kgpm2 * kFieldGravity_mps2 * 0.1 * 0.1 / (2 * *cloth.shear_Npm);
    return {std::abs(low_end_m(world).x / exact_m - 1), world.cpu_ms_per_s()};
}

/// Clamped level, it hangs over as the heavy elastica (the angle: from its equation, by shooting).
FieldOutcome cloth_hangs_over(scene::Fidelity fidelity) {
    constexpr double kTip_deg = 39.93543;
    const int free = fidelity == scene::Fidelity::Precise ? 32 : 16;
    scene::ClothDescription cloth = strip();
    cloth.cells = {{free + 1, 2}};
    cloth.size_m = {1.0 + 1.0 / free, 0.1};
    cloth.pose.position = {0, 2, 0};
    cloth.pose.orientation = {0.70710678_r, 0.70710678_r, 0, 0};
    cloth.bend_Nm = kSheet_kgpm2 * kFieldGravity_mps2 / 5;
    cloth.damping_s = 0.1;
    cloth.pins = {{.along = {0, 0, 1.0 / (free + 1), 1}, .to = {}}};
    FieldWorld world(cloth_scene(fidelity, cloth));
    world.run_to(8);
    const physics::Sheet& sheet = sheet_of(world);
    const std::size_t tip = sheet.columns() - 1;
    const Vec3d along = sheet.positions_m()[tip] - sheet.positions_m()[tip - 1];
    const double tip_deg = std::atan2(-along.y, along.x) * 180 / kPi_rad;
    return {std::abs(tip_deg / kTip_deg - 1), world.cpu_ms_per_s()};
}

FieldOutcome cloth_swings(scene::Fidelity fidelity) {
    scene::ClothDescription cloth = strip();
    cloth.bend_Nm = 0;
    cloth.pose.orientation = glm::angleAxis(0.03_r, Vec3{1, 0, 0});
    cloth.pose.position.y = static_cast<Real>(kHigh_m);
    FieldWorld world(cloth_scene(fidelity, cloth));
    const double exact_s = 2 * kPi_rad / (1.2024 * std::sqrt(kFieldGravity_mps2));
    const double hook_m = sheet_of(world).positions_m()[0].z;
    const double swing_s = period_s(world, 60, [&] { return low_end_m(world).z - hook_m; });
    return {std::abs(swing_s / exact_s - 1), world.cpu_ms_per_s()};
}

FieldOutcome cloth_falls_level(scene::Fidelity fidelity) {
    scene::ClothDescription cloth = strip();
    cloth.size_m = {1, 1};
    cloth.pins.clear();
    cloth.pose.position = {0, 50, 0};
    cloth.pose.orientation = {0.70710678_r, 0.70710678_r, 0, 0};
    cloth.drag = 1.2;
    FieldWorld world(cloth_scene(fidelity, cloth));
    world.run_to(4);
    const double rho = static_cast<double>(scene::ForceDescription{}.air_density_kgpm3);
    const double exact_mps = std::sqrt(2 * kSheet_kgpm2 * kFieldGravity_mps2 / (rho * cloth.drag));
    const physics::Sheet& sheet = sheet_of(world);
    return {std::abs(-sheet.totals().momentum_kgmps.y / sheet.mass_kg() / exact_mps - 1),
            world.cpu_ms_per_s()};
}

constexpr std::array kClothReferences{
    FieldReference{"cloth",
                   "stretch of a strip by its weight",
                   "rho g L^2 / (2 E)",
                   kByFidelity,
                   &cloth_stretches_by_own_weight},
    FieldReference{"cloth",
                   "stretch of a strip by a load",
                   "(M + m / 2) g L / (E b)",
                   kByFidelity,
                   &cloth_stretches_by_load},
    FieldReference{
        "cloth", "shear of a strip by its weight", "rho g b^2 / (2 G)", kByFidelity, &cloth_shears},
    FieldReference{"cloth",
                   "tip of a clamped strip",
                   "39.94 deg where rho g L^3 / D = 5",
                   kByFidelity,
                   &cloth_hangs_over},
    FieldReference{"cloth",
                   "first swing of a hanging strip",
                   "2 pi / (1.2024 sqrt(g / L))",
                   kByFidelity,
                   &cloth_swings},
    FieldReference{"cloth",
                   "terminal speed of a level sheet",
                   "sqrt(2 rho_s g / (rho C))",
                   kByFidelity,
                   &cloth_falls_level},
};

}  // namespace

std::span<const FieldReference> cloth_references() {
    return kClothReferences;
}

}  // namespace plumbline::study

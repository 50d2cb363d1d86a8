// Soft bodies.
#include "engine/physics/soft_body.h"
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kBar_m = 1;
constexpr double kThick_m = 0.05;
constexpr double kBar_kgpm3 = 1000;

/// A bar along x whose left end is held, without transverse contraction.
scene::SoftDescription bar() {
    scene::SoftDescription soft;
    soft.name = "bar";
    soft.size_m = {kBar_m, kThick_m, kThick_m};
    soft.pose.position = {static_cast<Real>(kBar_m / 2), 3, 0};
    soft.density_kgpm3 = kBar_kgpm3;
    soft.poisson = 0;
    soft.cell_m = kThick_m;
    soft.pins = {{.min_m = {-0.01_r, 0, -1}, .max_m = {0.01_r, 9, 1}, .to = {}}};
    return soft;
}

scene::SceneDescription soft_scene(scene::Fidelity fidelity,
                                   scene::SoftDescription soft,
                                   const Vec3& gravity_mps2) {
    scene::SceneDescription scene;
    scene.gravity_mps2 = gravity_mps2;
    scene.forces.fidelity.soft = fidelity;
    scene.forces.softs = {std::move(soft)};
    return scene;
}

const physics::SoftBody& soft_of(const FieldWorld& world) {
    return dynamic_cast<const physics::SoftBody&>(world.simulation().softs().front().body->body());
}

/// How far its free end has moved, on average.
Vec3d end_moved_m(const FieldWorld& world) {
    const physics::SoftBody& soft = soft_of(world);
    Vec3d sum{0, 0, 0};
    int count = 0;
    for (std::size_t i = 0; i < soft.positions_m().size(); ++i) {
        const Vec3d& rest = soft.grid().points_m[i];
        if (rest.x < kBar_m - 1e-3) continue;
        sum += soft.positions_m()[i] - rest;
        ++count;
    }
    return sum / static_cast<double>(count);
}

FieldOutcome soft_stretches(scene::Fidelity fidelity) {
    scene::SoftDescription soft = bar();
    soft.size_m = {kBar_m, 0.1, 0.1};
    soft.cell_m = 0.1;
    soft.young_Pa = 1e6;
    soft.damping_s = 0.05;
    FieldWorld world(soft_scene(fidelity, soft, {static_cast<Real>(kFieldGravity_mps2), 0, 0}));
    world.run_to(4);
    const double exact_m = kBar_kgpm3 * kFieldGravity_mps2 * kBar_m * kBar_m / (2 * soft.young_Pa);
    return {std::abs(end_moved_m(world).x / exact_m - 1), world.cpu_ms_per_s()};
}

/// So little that it stays straight.
constexpr Real kLight_mps2 = 0.1_r;

/// What it swings about, by a mean over time that weighs the beginning and the end least.
FieldOutcome soft_sags(scene::Fidelity fidelity) {
    constexpr double kTime_s = 30;
    scene::SoftDescription soft = bar();
    soft.young_Pa = 4e6;
    FieldWorld world(soft_scene(fidelity, soft, {0, -kLight_mps2, 0}));
    double sag_m = 0;
    double weights = 0;
    while (world.time_s() < kTime_s) {
        world.step();
        const double weight = 1 - std::cos(2 * kPi_rad * world.time_s() / kTime_s);
        sag_m -= end_moved_m(world).y * weight;
        weights += weight;
    }
    const double bend_Nm2 = soft.young_Pa * std::pow(kThick_m, 4) / 12;
    const double load_Npm = kBar_kgpm3 * static_cast<double>(kLight_mps2) * kThick_m * kThick_m;
    const double exact_m = load_Npm * std::pow(kBar_m, 4) / (8 * bend_Nm2);
    return {std::abs(sag_m / weights / exact_m - 1), world.cpu_ms_per_s()};
}

FieldOutcome soft_swings(scene::Fidelity fidelity) {
    scene::SoftDescription soft = bar();
    soft.young_Pa = 4e6;
    FieldWorld world(soft_scene(fidelity, soft, {0, -kLight_mps2, 0}));
    const double area_m2 = kThick_m * kThick_m;
    const double bend_Nm2 = soft.young_Pa * area_m2 * area_m2 / 12;
    const double exact_s =
        2 * kPi_rad / (1.8751 * 1.8751 * std::sqrt(bend_Nm2 / (kBar_kgpm3 * area_m2)));
    const double swing_s =
        period_s(world, 30, [&] { return soft_of(world).totals().momentum_kgmps.y; });
    return {std::abs(swing_s / exact_s - 1), world.cpu_ms_per_s()};
}

/// Of nearly incompressible material, hung by one end: by how much its volume changes.
FieldOutcome soft_keeps_volume(scene::Fidelity fidelity) {
    scene::SoftDescription soft = bar();
    soft.young_Pa = 1e5;
    soft.poisson = 0.49;
    soft.damping_s = 0.02;
    FieldWorld world(soft_scene(fidelity, soft, {static_cast<Real>(kFieldGravity_mps2), 0, 0}));
    world.run_to(4);
    const physics::SoftBody& body = soft_of(world);
    return {std::abs(body.volume_m3() / body.rest_volume_m3() - 1), world.cpu_ms_per_s()};
}

/// A stiff block of 1 x 0.4 x 1 m in fresh water.
FieldOutcome soft_floats(scene::Fidelity fidelity) {
    scene::SoftDescription soft;
    soft.name = "block";
    soft.size_m = {1, 0.4, 1};
    soft.cell_m = 0.2;
    soft.young_Pa = 1e7;
    soft.density_kgpm3 = 300;
    soft.pose.position = {0, 0.1_r, 0};
    scene::SceneDescription scene =
        soft_scene(fidelity, soft, {0, static_cast<Real>(-kFieldGravity_mps2), 0});
    scene.forces.waters.push_back({.name = "pond", .min_m = {-5, -9, -5}, .max_m = {5, 0, 5}});
    FieldWorld world(scene);
    world.run_to(30);
    const physics::SoftBody& body = soft_of(world);
    const double height_m = body.totals().moment_kgm.y / body.mass_kg();
    return {std::abs((0.2 - height_m) / (0.3 * 0.4) - 1), world.cpu_ms_per_s()};
}

constexpr std::array kSoftReferences{
    FieldReference{"soft",
                   "stretch of a bar by its weight",
                   "rho g L^2 / (2 E)",
                   kByFidelity,
                   &soft_stretches},
    FieldReference{
        "soft", "sag of a clamped bar", "rho A g L^4 / (8 E I)", {0.05, 0.01, 0.005}, &soft_sags},
    FieldReference{"soft",
                   "first swing of a clamped bar",
                   "1.875^2 / (2 pi) sqrt(E I / (rho A L^4))",
                   {0.05, 0.01, 0.005},
                   &soft_swings},
    FieldReference{"soft",
                   "volume at a Poisson ratio of 0.49",
                   "kept",
                   {0.01, 0.01, 0.01},
                   &soft_keeps_volume},
    FieldReference{
        "soft", "draft of a block", "height rho_b / rho", {0.01, 0.01, 0.005}, &soft_floats},
};

}  // namespace

std::span<const FieldReference> soft_references() {
    return kSoftReferences;
}

}  // namespace plumbline::study

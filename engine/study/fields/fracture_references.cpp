// What breaks: a rod loaded in ways for which strength of materials knows the stress.
#include "engine/physics/totals.h"
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kRod_m = 2;
constexpr double kRodSide_m = 0.1;
constexpr double kRod_kg = 20;
constexpr double kStrength_Pa = 1e6;
constexpr double kRodSection_m2 = kRodSide_m * kRodSide_m;
/// So light that its own weight does not show.
constexpr double kLightRod_kg = 0.01;

/// Along x, in 20 pieces.
scene::SceneDescription rod_scene(scene::Fidelity fidelity, double mass_kg) {
    scene::SceneDescription scene;
    scene.gravity_mps2 = {0, 0, 0};
    scene::EntityDescription rod =
        box_of("rod", {0, 5, 0}, Vec3(Vec3d{kRod_m, kRodSide_m, kRodSide_m}), mass_kg);
    rod.body->fracture =
        scene::FractureDescription{.pieces = 20, .strength_Pa = static_cast<Real>(kStrength_Pa)};
    scene.entities = {rod};
    scene.forces.fidelity.fracture = fidelity;
    return scene;
}

/// The share of `exact` at which it breaks, between a half and twice as much; and what a run costs in which it holds.
template <class MakeScene>
FieldOutcome breaks_at(double exact, double seconds, const MakeScene& scene_at) {
    FieldOutcome outcome;
    double holds = 0.5;
    double breaks = 2;
    while (breaks - holds > 1e-4) {
        const double share = (holds + breaks) / 2;
        FieldWorld world(scene_at(share * exact));
        while (world.time_s() < seconds && world.simulation().find("rod")) world.step();
        if (world.simulation().find("rod")) {
            holds = share;
            outcome.cpu_ms_per_s = world.cpu_ms_per_s();
        } else {
            breaks = share;
        }
    }
    outcome.error = std::abs((holds + breaks) / 2 - 1);
    return outcome;
}

FieldOutcome rod_spins_apart(scene::Fidelity fidelity) {
    const double density_kgpm3 = kRod_kg / (kRod_m * kRodSection_m2);
    const double exact_radps = std::sqrt(8 * kStrength_Pa / density_kgpm3) / kRod_m;
    return breaks_at(exact_radps, 0.1, [&](double spin_radps) {
        scene::SceneDescription scene = rod_scene(fidelity, kRod_kg);
        scene.entities.back().body->angular_velocity_radps = {0, static_cast<Real>(spin_radps), 0};
        return scene;
    });
}

/// Glued to the world at its left end, with a load on its right one.
scene::SceneDescription loaded_rod(scene::Fidelity fidelity,
                                   double load_kg,
                                   const Vec3& gravity_mps2) {
    scene::SceneDescription scene = rod_scene(fidelity, kLightRod_kg);
    scene.gravity_mps2 = gravity_mps2;
    scene.entities.push_back(
        box_of("load", {static_cast<Real>(kRod_m / 2), 5, 0}, {0.1_r, 0.1_r, 0.1_r}, load_kg));
    for (const auto& [a, b, x_m] :
         {std::tuple{"rod", "world", -kRod_m / 2}, std::tuple{"load", "rod", kRod_m / 2}})
        scene.joints.push_back({.name = a,
                                .kind = physics::JointKind::Fixed,
                                .a = a,
                                .b = b,
                                .anchor_a_m = {static_cast<Real>(x_m), 5, 0},
                                .anchor_b_m = {static_cast<Real>(x_m), 5, 0}});
    return scene;
}

FieldOutcome column_is_pulled(scene::Fidelity fidelity) {
    const double exact_kg = kStrength_Pa * kRodSection_m2 / kFieldGravity_mps2;
    return breaks_at(exact_kg, 0.2, [&](double load_kg) {
        return loaded_rod(fidelity, load_kg, {static_cast<Real>(kFieldGravity_mps2), 0, 0});
    });
}

/// At the cut that is nearest to the wall, a piece off it.
FieldOutcome cantilever_bends(scene::Fidelity fidelity) {
    const double exact_kg =
        kStrength_Pa * kRodSection_m2 * kRodSide_m / (6 * kRod_m) / kFieldGravity_mps2;
    return breaks_at(exact_kg, 0.2, [&](double load_kg) {
        return loaded_rod(fidelity, load_kg, {0, static_cast<Real>(-kFieldGravity_mps2), 0});
    });
}

/// On two round supports, a weight on its middle.
FieldOutcome beam_bends(scene::Fidelity fidelity) {
    constexpr double kApart_m = 1.9;
    constexpr double kSupport_m = 0.1;
    const double exact_kg =
        2 * kStrength_Pa * kRodSection_m2 * kRodSide_m / (3 * kApart_m) / kFieldGravity_mps2;
    return breaks_at(exact_kg, 1, [&](double load_kg) {
        scene::SceneDescription scene = rod_scene(fidelity, kRod_kg / 20);
        scene.gravity_mps2 = {0, static_cast<Real>(-kFieldGravity_mps2), 0};
        const auto across = [](scene::EntityDescription roller, double radius_m) {
            roller.visual = scene::Primitive{
                physics::CylinderShape{.radius_m = static_cast<Real>(radius_m), .height_m = 0.3_r}};
            roller.world_from_body.orientation =
                portable_angle_axis(glm::half_pi<Real>(), Vec3{1, 0, 0});
            return roller;
        };
        const double low_m = 5 - kRodSide_m / 2 - kSupport_m;
        for (const double side : {-0.5, 0.5}) {
            scene.entities.push_back(across(box_of(side < 0 ? "left" : "right",
                                                   Vec3(Vec3d{side * kApart_m, low_m, 0}),
                                                   {1, 1, 1},
                                                   1),
                                            kSupport_m));
            scene.entities.back().body->kind = physics::BodyKind::Static;
        }
        scene.entities.push_back(
            across(box_of("load", Vec3(Vec3d{0, 5 + kRodSide_m / 2 + 0.05, 0}), {1, 1, 1}, load_kg),
                   0.05));
        scene.joints = {{.name = "guide",
                         .kind = physics::JointKind::Slider,
                         .a = "load",
                         .b = "world",
                         .anchor_a_m = scene.entities.back().world_from_body.position,
                         .anchor_b_m = scene.entities.back().world_from_body.position}};
        return scene;
    });
}

/// By which momentum, angular momentum or kinetic energy differ once it has broken into many parts.
FieldOutcome break_keeps_motion(scene::Fidelity fidelity) {
    scene::SceneDescription scene = rod_scene(fidelity, kRod_kg);
    scene::BodyDescription& body = *scene.entities.back().body;
    body.velocity_mps = {1, 2, 3};
    body.angular_velocity_radps = {2, 150, 1};
    FieldWorld world(scene);
    const physics::PhysicsWorld& physics = world.simulation().physics;
    const auto differ = [](const Vec3d& now, const Vec3d& then) {
        return glm::distance(now, then) / glm::length(then);
    };
    const Vec3d momentum = physics::momentum_kgmps(physics);
    const Vec3d angular = physics::angular_momentum_kgm2ps(physics);
    const double kinetic_J = physics::energy(physics).kinetic_J;
    world.step();
    if (world.simulation().find("rod")) return {1, world.cpu_ms_per_s()};
    return {std::max({differ(physics::momentum_kgmps(physics), momentum),
                      differ(physics::angular_momentum_kgm2ps(physics), angular),
                      std::abs(physics::energy(physics).kinetic_J / kinetic_J - 1)}),
            world.cpu_ms_per_s()};
}

/// Cuts lie up to half a piece from where the moment is largest, and not square to the rod.
constexpr std::array kWithinAPiece{0.1, 0.1, 0.1};

constexpr std::array kFractureReferences{
    FieldReference{
        "fracture", "spin that tears a rod", "sqrt(8 s / rho) / L", kByFidelity, &rod_spins_apart},
    FieldReference{"fracture", "pull on a column", "s A", kByFidelity, &column_is_pulled},
    FieldReference{
        "fracture", "load on two supports", "2 s b h^2 / (3 L)", kWithinAPiece, &beam_bends},
    FieldReference{
        "fracture", "load on a cantilever", "s b h^2 / (6 L)", kWithinAPiece, &cantilever_bends},
    FieldReference{"fracture",
                   "motion across a break",
                   "momentum, spin and energy are kept",
                   {1e-5, 1e-5, 1e-5},
                   &break_keeps_motion},
};

}  // namespace

std::span<const FieldReference> fracture_references() {
    return kFractureReferences;
}

}  // namespace plumbline::study

// The vehicles of a running scene: wheels as bodies of their own, on sprung hubs.
#include "engine/physics/force_field.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/vehicle_layout.h"
#include "engine/scene/sections/scene_parts.h"
#include "engine/scene/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::scene {
namespace {

/// Of a wheel's mass: what does not turn with it.
constexpr double kHubShare = 0.2;
constexpr double kHubRadius_m = 0.02;
/// Of what they carry: lighter wheels stick as they roll.
constexpr double kLightest = 0.01;
/// Least sub-steps of its bodies at draft, balanced and precise.
constexpr std::array kSubsteps{0, 4, 16};
/// The spring's other end: as far above the hub.
constexpr Real kStrut_m = 1;

/// A tyre is crowned: on level ground only so much of its width touches, and rolls in a curve without scrubbing.
constexpr double kTreadShare = 0.1;
constexpr double kCrownShare = 0.02;  ///< of the radius: how much lower the rest is

physics::ShapeDef tyre_of(const WheelDescription& wheel) {
    const auto cylinder = [](double radius_m, double height_m) {
        return physics::CompoundChild{
            .shape = physics::CylinderShape{.radius_m = static_cast<Real>(radius_m),
                                            .height_m = static_cast<Real>(height_m)}};
    };
    return physics::CompoundShape{{cylinder(wheel.radius_m, kTreadShare * wheel.width_m),
                                   cylinder((1 - kCrownShare) * wheel.radius_m, wheel.width_m)}};
}

/// A cylinder's axis, y, becomes the wheel's: x.
Quat cylinder_as_wheel() {
    return portable_angle_axis(glm::half_pi<Real>(), Vec3{0, 0, 1});
}

/// What hub and wheel have in common: at its place in the chassis, and moving along with it.
EntityDescription part_of(const VehicleDescription& vehicle,
                          const WheelDescription& wheel,
                          const physics::BodyState& chassis) {
    EntityDescription part;
    part.world_from_body.position = transform_point(chassis.world_from_body, wheel.position_m);
    part.world_from_body.orientation = chassis.world_from_body.orientation;
    part.label = "wheel";
    part.location = vehicle.location;
    BodyDescription body;
    body.restitution = Real{0};
    body.group = "(vehicles)";
    const Vec3 arm = part.world_from_body.position - chassis.world_from_body.position;
    body.velocity_mps = chassis.velocity_mps + glm::cross(chassis.angular_velocity_radps, arm);
    body.angular_velocity_radps = chassis.angular_velocity_radps;
    part.body = body;
    return part;
}

EntityDescription hub_of(EntityDescription part, const WheelDescription& wheel) {
    BodyDescription& body = *part.body;
    const auto size_m = static_cast<Real>(kHubRadius_m);
    const double mass_kg = kHubShare * wheel.mass_kg;
    body.shape = physics::ShapeDef{physics::SphereShape{.radius_m = size_m}};
    body.mass_kg = static_cast<Real>(mass_kg);
    body.inertia_kgm2 = Vec3(static_cast<Real>(0.1 * mass_kg * wheel.radius_m * wheel.radius_m));
    body.collides_with = {std::string(kNoGroup)};
    return part;
}

/// Turned to the side by `turn_rad`, rolling with the chassis.
EntityDescription wheel_of(EntityDescription part,
                           const VehicleDescription& vehicle,
                           const WheelDescription& wheel,
                           double turn_rad) {
    BodyDescription& body = *part.body;
    const double m = wheel.mass_kg;
    const double r2 = wheel.radius_m * wheel.radius_m;
    const double across_kgm2 = m * (r2 / 4 + wheel.width_m * wheel.width_m / 12);
    body.mass_kg = static_cast<Real>((1 - kHubShare) * m);
    body.inertia_kgm2 = Vec3(Vec3d{across_kgm2, m * r2 / 2, across_kgm2});
    body.friction = static_cast<Real>(vehicle.friction);
    body.shape = tyre_of(wheel);
    Quat& turned = part.world_from_body.orientation;
    turned = turned * portable_angle_axis(static_cast<Real>(turn_rad), Vec3{0, 1, 0});
    const Vec3 forward = turned * Vec3{0, 0, -1};
    const Real roll_radps =
        glm::dot(body.velocity_mps, forward) / static_cast<Real>(wheel.radius_m);
    body.angular_velocity_radps += turned * Vec3{-roll_radps, 0, 0};
    turned = turned * cylinder_as_wheel();
    part.visual = physics::CylinderShape{.radius_m = static_cast<Real>(wheel.radius_m),
                                         .height_m = static_cast<Real>(wheel.width_m)};
    part.material = vehicle.material;
    return part;
}

/// What is to be said of a wheel that is too light for its load; empty: nothing.
std::string light_wheel_of(const VehicleDescription& vehicle, const std::vector<double>& loads_N) {
    for (std::size_t i = 0; i < loads_N.size(); ++i) {
        const double carried_kg = loads_N[i] / physics::kStandardGravity_mps2;
        const double least_kg = kLightest * carried_kg;
        if (vehicle.wheels[i].mass_kg >= least_kg) continue;
        return fmt::format(
            "{}: vehicle {}: a wheel of {:g} kg carries {:.0f} kg and may stick as it rolls; "
            "make it {:.2g} kg or more",
            to_string(vehicle.location),
            vehicle.name,
            vehicle.wheels[i].mass_kg,
            carried_kg,
            least_kg);
    }
    return {};
}

}  // namespace

Result<Done> Simulation::add_vehicle(const VehicleDescription& description) {
    const auto refuse = [&description](const Error& why) {
        return Error{fmt::format("{}: vehicle {}: {}",
                                 to_string(description.location),
                                 description.name,
                                 why.message),
                     ExitCode::Refused};
    };
    const Result<physics::BodyId> chassis = end_of_joint(description.body);
    if (!chassis) return refuse(chassis.error());
    Vehicle vehicle{
        .name = description.name, .chassis = *chassis, .controls = description.controls};
    const physics::BodyState state = physics.state(*chassis);
    const Vec3 down = state.world_from_body.orientation * Vec3{0, -1, 0};
    const double pull_mps2 =
        std::max(glm::dot(Vec3d(physics.def().gravity_mps2), Vec3d(down)), 0.0);
    const Vec3d center_m(
        transform_point(invert(state.world_from_body), state.center_of_mass_world()));
    const std::vector<double> loads_N =
        spring_loads_N(description, center_m, static_cast<double>(state.mass.mass_kg) * pull_mps2);
    for (std::size_t i = 0; i < description.wheels.size(); ++i) {
        const WheelDescription& wheel = description.wheels[i];
        const EntityDescription part = part_of(description, wheel, state);
        const double turn_rad = wheel_turn_rad(description, i, description.controls.steer_rad);
        Wheel made{.load_N = loads_N[i] + wheel.mass_kg * pull_mps2, .turn_rad = turn_rad};
        for (const bool is_hub : {true, false}) {
            const Result<ecs::Entity> entity = builder_->build(
                is_hub ? hub_of(part, wheel) : wheel_of(part, description, wheel, turn_rad),
                fmt::format("{}.{}{}", vehicle.name, is_hub ? "hub" : "wheel", i));
            if (!entity) return entity.error();
            registry.add<PartOf>(
                *entity,
                PartOf{.whole = PartOf::Whole::Vehicle,
                       .index = static_cast<std::uint32_t>(bodies_.vehicles.size())});
            (is_hub ? made.hub : made.body) = registry.get<BodyRef>(*entity).body;
        }
        const Result<Done> joined = join_wheel(wheel, loads_N[i], *chassis, made);
        if (!joined) return refuse(joined.error());
        vehicle.wheels.push_back(made);
    }
    if (std::string light = light_wheel_of(description, loads_N); !light.empty())
        warnings.push_back(std::move(light));
    bodies_.vehicles.push_back(std::move(vehicle));
    return Done{};
}

double Simulation::spin_radps(const Wheel& wheel) const {
    if (!physics.contains(wheel.body) || !physics.contains(wheel.hub)) return 0;
    const physics::BodyState body = physics.state(wheel.body);
    // The cylinder's axis is y: the wheel's x, to the right.
    const Vec3 right = body.world_from_body.orientation * Vec3{0, -1, 0};
    const Vec3 spin_radps =
        body.angular_velocity_radps - physics.state(wheel.hub).angular_velocity_radps;
    return -static_cast<double>(glm::dot(spin_radps, right));
}

Result<Done> Simulation::join_wheel(const WheelDescription& description,
                                    double load_N,
                                    physics::BodyId chassis,
                                    Wheel& wheel) {
    const Pose hub = physics.state(wheel.hub).world_from_body;
    const Vec3 up = hub.orientation * Vec3{0, 1, 0};
    const auto turned = portable_angle_axis(static_cast<Real>(wheel.turn_rad), Vec3{0, 1, 0});
    const auto half_m = static_cast<Real>(description.travel_m / 2);
    const auto give_m =
        static_cast<Real>(description.stiffness_Npm > 0 ? load_N / description.stiffness_Npm : 0.0);
    const auto fidelity = static_cast<std::size_t>(description_.forces.fidelity.vehicles);
    const std::uint64_t mark = mark_of_vehicle(bodies_.vehicles.size());
    const Result<physics::JointId> strut =
        physics.create_joint({.kind = JointKind::Slider,
                              .a = wheel.hub,
                              .b = chassis,
                              .anchor_a_world = hub.position,
                              .anchor_b_world = hub.position,
                              .axis_world = up,
                              .limits = std::array{-half_m, half_m},
                              .user = mark});
    const Result<physics::JointId> spring =
        physics.create_joint({.kind = JointKind::Spring,
                              .a = wheel.hub,
                              .b = chassis,
                              .anchor_a_world = hub.position,
                              .anchor_b_world = hub.position + up * kStrut_m,
                              .stiffness_Npm = static_cast<Real>(description.stiffness_Npm),
                              .damping_Nspm = static_cast<Real>(description.damping_Nspm),
                              .rest_length_m = kStrut_m + give_m,
                              .user = mark});
    const Result<physics::JointId> axle =
        physics.create_joint({.kind = JointKind::Hinge,
                              .a = wheel.body,
                              .b = wheel.hub,
                              .anchor_a_world = hub.position,
                              .anchor_b_world = hub.position,
                              .axis_world = hub.orientation * (turned * Vec3{1, 0, 0}),
                              .substeps = kSubsteps[fidelity],
                              .user = mark});
    // A spring without stiffness: the two do not touch.
    const Result<physics::JointId> apart = physics.create_joint({.kind = JointKind::Spring,
                                                                 .a = wheel.body,
                                                                 .b = chassis,
                                                                 .anchor_a_world = hub.position,
                                                                 .anchor_b_world = hub.position,
                                                                 .user = mark});
    for (const auto* each : {&strut, &spring, &axle, &apart}) {
        if (!*each) return each->error();
    }
    wheel.strut = *strut;
    wheel.axle = *axle;
    return Done{};
}

}  // namespace plumbline::scene

// Ropes.
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kRopeMass_kg = 1;
constexpr double kLength_m = 2;
constexpr Vec3 kHook_m{0, 5, 0};

/// Hangs from the hook straight down; its end is free.
scene::RopeDescription rope_of(double length_m, double mass_kg) {
    scene::RopeDescription rope;
    rope.name = "rope";
    rope.a = "world";
    rope.anchor_a_m = kHook_m;
    rope.anchor_b_m = kHook_m - Vec3{0, static_cast<Real>(length_m), 0};
    rope.length_m = length_m;
    rope.mass_kg = mass_kg;
    return rope;
}

scene::SceneDescription rope_scene(scene::Fidelity fidelity, scene::RopeDescription rope) {
    scene::SceneDescription scene;
    scene.gravity_mps2 = {0, static_cast<Real>(-kFieldGravity_mps2), 0};
    scene.forces.fidelity.rope = fidelity;
    scene.forces.ropes = {std::move(rope)};
    return scene;
}

std::vector<Vec3d> points_of(const FieldWorld& world) {
    return world.simulation().points_of(world.simulation().ropes().front());
}

double length_m(const FieldWorld& world) {
    return scene::length_of(points_of(world));
}

double tension_N(const FieldWorld& world) {
    const physics::JointId first = world.simulation().ropes().front().joints.front();
    return static_cast<double>(world.simulation().physics.joint(first).state.force_N);
}

/// x of sinh(x) / x = ratio.
double catenary_parameter(double ratio) {
    double low = 1e-6;
    double high = 50;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (std::sinh(middle) / middle > ratio ? high : low) = middle;
    }
    return low;
}

constexpr double kSpan_m = 3;
constexpr double kSlackLength_m = 4;

FieldWorld hanging_between(scene::Fidelity fidelity) {
    scene::RopeDescription rope = rope_of(kSlackLength_m, kRopeMass_kg);
    rope.b = "world";
    rope.anchor_b_m = kHook_m + Vec3{static_cast<Real>(kSpan_m), 0, 0};
    FieldWorld world(rope_scene(fidelity, rope));
    world.run_to(1);
    return world;
}

FieldOutcome sags_as_catenary(scene::Fidelity fidelity) {
    const double x = catenary_parameter(kSlackLength_m / kSpan_m);
    const double exact_m = kSpan_m / (2 * x) * (std::cosh(x) - 1);
    const FieldWorld world = hanging_between(fidelity);
    double lowest_m = kHook_m.y;
    for (const Vec3d& point : points_of(world)) lowest_m = std::min(lowest_m, point.y);
    const double sag_m = static_cast<double>(kHook_m.y) - lowest_m;
    return {std::abs(sag_m / exact_m - 1), world.cpu_ms_per_s()};
}

FieldOutcome pulls_as_catenary(scene::Fidelity fidelity) {
    const double x = catenary_parameter(kSlackLength_m / kSpan_m);
    const double weight_N = kRopeMass_kg * kFieldGravity_mps2;
    const double level_N = weight_N / kSlackLength_m * kSpan_m / (2 * x);
    const double exact_N = std::sqrt(level_N * level_N + weight_N * weight_N / 4);
    const FieldWorld world = hanging_between(fidelity);
    return {std::abs(tension_N(world) / exact_N - 1), world.cpu_ms_per_s()};
}

FieldOutcome stretches_by_load(scene::Fidelity fidelity) {
    constexpr double kLoad_kg = 10;
    constexpr double kStiffness_N = 1e4;
    scene::RopeDescription rope = rope_of(kLength_m, kRopeMass_kg);
    rope.b = "load";
    rope.stiffness_N = kStiffness_N;
    rope.damping_s = 0.02;
    scene::SceneDescription scene = rope_scene(fidelity, rope);
    scene.entities = {ball_of("load", rope.anchor_b_m, 0.1, kLoad_kg)};
    FieldWorld world(scene);
    world.run_to(10);
    const double force_N = (kLoad_kg + kRopeMass_kg / 2) * kFieldGravity_mps2;
    const double exact_m = force_N * kLength_m / kStiffness_N;
    return {std::abs((length_m(world) - kLength_m) / exact_m - 1), world.cpu_ms_per_s()};
}

FieldOutcome stretches_by_own_weight(scene::Fidelity fidelity) {
    constexpr double kStiffness_N = 1000;
    scene::RopeDescription rope = rope_of(kLength_m, kRopeMass_kg);
    rope.stiffness_N = kStiffness_N;
    rope.damping_s = 0.02;
    FieldWorld world(rope_scene(fidelity, rope));
    world.run_to(10);
    const double exact_m = kRopeMass_kg * kFieldGravity_mps2 * kLength_m / (2 * kStiffness_N);
    return {std::abs((length_m(world) - kLength_m) / exact_m - 1), world.cpu_ms_per_s()};
}

/// A load of a thousand times its weight swings as a pendulum.
FieldOutcome swings_a_load(scene::Fidelity fidelity) {
    constexpr double kAngle_rad = 0.1;
    scene::RopeDescription rope = rope_of(kLength_m, 0.1);
    rope.b = "load";
    rope.anchor_b_m = kHook_m + Vec3{static_cast<Real>(kLength_m * std::sin(kAngle_rad)),
                                     static_cast<Real>(-kLength_m * std::cos(kAngle_rad)),
                                     0};
    scene::SceneDescription scene = rope_scene(fidelity, rope);
    scene.entities = {ball_of("load", rope.anchor_b_m, 0.05, 100)};
    FieldWorld world(scene);
    const double exact_s = 2 * kPi_rad * std::sqrt(kLength_m / kFieldGravity_mps2) *
                           (1 + kAngle_rad * kAngle_rad / 16);
    const double swing_s = period_s(world, 12, [&world] { return world.position_m("load").x; });
    return {std::abs(swing_s / exact_s - 1), world.cpu_ms_per_s()};
}

/// From the shape of its first mode: the Bessel function of the first kind of order 0.
FieldOutcome swings_by_itself(scene::Fidelity fidelity) {
    constexpr double kAside_m = 0.02;
    constexpr int kPoints = 100;
    const double rate_radps = 1.2024 * std::sqrt(kFieldGravity_mps2 / kLength_m);
    scene::RopeDescription rope = rope_of(kLength_m, kRopeMass_kg);
    for (int i = 0; i <= kPoints; ++i) {
        const double above_m = kLength_m * (kPoints - i) / kPoints;
        const double aside_m =
            kAside_m *
            std::cyl_bessel_j(0, 2 * rate_radps * std::sqrt(above_m / kFieldGravity_mps2));
        rope.path_m.push_back(rope.anchor_b_m +
                              Vec3{static_cast<Real>(aside_m), static_cast<Real>(above_m), 0});
    }
    rope.anchor_a_m = rope.path_m.front();
    rope.anchor_b_m = rope.path_m.back();
    FieldWorld world(rope_scene(fidelity, rope));
    const double swing_s = period_s(world, 20, [&world] { return points_of(world).back().x; });
    return {std::abs(swing_s * rate_radps / (2 * kPi_rad) - 1), world.cpu_ms_per_s()};
}

/// Stretched between two hooks, from the shape of half a sine, without gravity.
FieldOutcome sounds_as_string(scene::Fidelity fidelity) {
    constexpr double kUnstretched_m = 1.98;
    constexpr double kMass_kg = 1;
    constexpr double kStiffness_N = 1e4;
    scene::RopeDescription rope = rope_of(kUnstretched_m, kMass_kg);
    rope.b = "world";
    rope.stiffness_N = kStiffness_N;
    for (int i = 0; i <= 40; ++i) {
        rope.path_m.emplace_back(static_cast<Real>(kLength_m * i / 40),
                                 static_cast<Real>(1 + 0.005 * std::sin(kPi_rad * i / 40)),
                                 Real{0});
    }
    rope.anchor_a_m = rope.path_m.front();
    rope.anchor_b_m = rope.path_m.back();
    scene::SceneDescription scene = rope_scene(fidelity, rope);
    scene.gravity_mps2 = {0, 0, 0};
    FieldWorld world(scene);
    const double pull_N = kStiffness_N * (kLength_m - kUnstretched_m) / kUnstretched_m;
    const double exact_s = 2 * kLength_m / std::sqrt(pull_N * kLength_m / kMass_kg);
    const double swing_s = period_s(world, 2, [&world] {
        const std::vector<Vec3d> points = points_of(world);
        return points[points.size() / 2].y - 1;
    });
    return {std::abs(swing_s / exact_s - 1), world.cpu_ms_per_s()};
}

/// A rod on two pins sags under its own weight: so little that the pins hardly pull, near the origin where float32 is fine.
FieldOutcome bends_as_beam(scene::Fidelity fidelity) {
    constexpr double kMass_kg = 0.2;
    constexpr double kBend_Nm2 = 200;
    constexpr double kHeight_m = 0.5;
    scene::RopeDescription rope = rope_of(kLength_m, kMass_kg);
    rope.b = "world";
    rope.anchor_a_m = {0, static_cast<Real>(kHeight_m), 0};
    rope.anchor_b_m = {static_cast<Real>(kLength_m), static_cast<Real>(kHeight_m), 0};
    rope.stiffness_N = 4e5;
    rope.bend_Nm2 = kBend_Nm2;
    rope.damping_s = 0.02;
    FieldWorld world(rope_scene(fidelity, rope));
    world.run_to(4);
    const double load_Npm = kMass_kg * kFieldGravity_mps2 / kLength_m;
    const double exact_m = 5 * load_Npm * std::pow(kLength_m, 4) / (384 * kBend_Nm2);
    const std::vector<Vec3d> points = points_of(world);
    const double sag_m = kHeight_m - points[points.size() / 2].y;
    return {std::abs(sag_m / exact_m - 1), world.cpu_ms_per_s()};
}

/// Half round a post that stands still, a weight on either side: whether the heavier one goes down faster and faster.
struct Slip {
    bool slips{false};
    double cpu_ms_per_s{0};
};
Slip slip_of(scene::Fidelity fidelity, double friction, double ratio) {
    constexpr double kPost_m = 0.3;
    constexpr double kRope_m = 0.005;
    constexpr int kPieces = 48;
    constexpr double kDrop_m = 1;
    const double round_m = kPost_m + kRope_m;
    const double piece_m = (2 * kDrop_m + kPi_rad * round_m) / kPieces;
    // Chords of this circle touch the post.
    const double circle_m = std::sqrt(round_m * round_m + piece_m * piece_m / 4) * 1.0002;
    scene::RopeDescription rope = rope_of(0, 0.05);
    rope.a = "heavy";
    rope.b = "light";
    rope.radius_m = kRope_m;
    rope.friction = friction;
    rope.pieces = kPieces;
    const auto add = [&rope](double x, double y) {
        rope.path_m.emplace_back(static_cast<Real>(x), static_cast<Real>(y), Real{0});
    };
    add(-circle_m, 1.5 - kDrop_m);
    for (int i = 0; i <= 200; ++i) {
        const double angle = kPi_rad * i / 200;
        add(-circle_m * std::cos(angle), 1.5 + circle_m * std::sin(angle));
    }
    add(circle_m, 1.5 - kDrop_m);
    rope.anchor_a_m = rope.path_m.front();
    rope.anchor_b_m = rope.path_m.back();
    rope.length_m = 2 * kDrop_m + kPi_rad * circle_m;
    scene::SceneDescription scene = rope_scene(fidelity, rope);
    scene::EntityDescription post = ball_of("post", {0, 1.5_r, 0}, 1, 1);
    post.visual = scene::Primitive{physics::CylinderShape{static_cast<Real>(kPost_m), Real{1}}};
    post.world_from_body.orientation = Quat{0.70710678_r, 0.70710678_r, 0, 0};
    post.body->kind = physics::BodyKind::Static;
    post.body->friction = static_cast<Real>(friction);
    scene.entities = {post,
                      ball_of("heavy", rope.anchor_a_m, 0.03, ratio),
                      ball_of("light", rope.anchor_b_m, 0.03, 1)};
    FieldWorld world(scene);
    world.run_to(0.7);
    const double early_m = world.position_m("heavy").y;
    world.run_to(1);
    const double middle_m = world.position_m("heavy").y;
    world.run_to(1.3);
    const double late_m = world.position_m("heavy").y;
    const double faster_mps = ((middle_m - late_m) - (early_m - middle_m)) / 0.3;
    return {faster_mps > 0.03, world.cpu_ms_per_s()};
}

/// The ratio of the weights at which the rope begins to slip: e^(friction * angle).
FieldOutcome holds_on_post(scene::Fidelity fidelity) {
    constexpr double kFriction = 0.3;
    const double exact = std::exp(kFriction * kPi_rad);
    double holds = 0.8;
    double slips = 1.2;
    double cpu_ms_per_s = 0;
    for (int i = 0; i < 5; ++i) {
        const double middle = (holds + slips) / 2;
        const Slip slip = slip_of(fidelity, kFriction, exact * middle);
        (slip.slips ? slips : holds) = middle;
        cpu_ms_per_s = slip.cpu_ms_per_s;
    }
    return {std::abs((holds + slips) / 2 - 1), cpu_ms_per_s};
}

constexpr std::array kReferences{
    FieldReference{"rope",
                   "sag between two hooks",
                   "d / (2 x) (cosh x - 1), sinh x / x = L / d",
                   kByFidelity,
                   &sags_as_catenary},
    FieldReference{"rope",
                   "pull on a hook",
                   "sqrt(H^2 + (m g / 2)^2), H = m g d / (2 x L)",
                   kByFidelity,
                   &pulls_as_catenary},
    FieldReference{
        "rope", "stretch by a load", "(M + m / 2) g L / (E A)", kByFidelity, &stretches_by_load},
    FieldReference{"rope",
                   "stretch by its own weight",
                   "m g L / (2 E A)",
                   kByFidelity,
                   &stretches_by_own_weight},
    FieldReference{"rope",
                   "pendulum of 1000 times its mass",
                   "2 pi sqrt(L / g) (1 + a^2 / 16)",
                   kByFidelity,
                   &swings_a_load},
    FieldReference{"rope",
                   "first swing of a hanging rope",
                   "2 pi / (1.2024 sqrt(g / L))",
                   kByFidelity,
                   &swings_by_itself},
    FieldReference{
        "rope", "tone of a string", "2 L sqrt(m / (L T))", kByFidelity, &sounds_as_string},
    FieldReference{
        "rope", "sag of a rod on two pins", "5 m g L^3 / (384 E I)", kByFidelity, &bends_as_beam},
    FieldReference{"rope",
                   "weight held by half a turn on a post",
                   "e^(mu pi)",
                   {0.05, 0.05, 0.05},
                   &holds_on_post},
};

}  // namespace

std::span<const FieldReference> rope_references() {
    return kReferences;
}

}  // namespace plumbline::study

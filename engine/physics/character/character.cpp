#include "engine/physics/character.h"

#include "engine/physics/character/character_state.h"

#include <algorithm>

namespace plumbline::physics {

namespace {

constexpr Real kPinnedPace = 0.2_r;
constexpr Real kCrouchTime_s = 0.18_r;
constexpr Real kEyeStiffness_radps = 14;  // how fast stairs are smoothed away

/// A step later: towards the height of the posture at most by `rate_m`, the offset towards nothing.
Eye settled(Eye eye, Real wanted_m, Real rate_m, Real most_offset_m, Real dt) {
    eye.height_m += std::clamp(wanted_m - eye.height_m, -rate_m, rate_m);
    // Critically damped, solved exactly, so that it is the same at every step length.
    eye.offset_m = std::clamp(eye.offset_m, -most_offset_m, most_offset_m);
    const Real decay = portable_exp(-kEyeStiffness_radps * dt);
    const Real slope = eye.offset_mps + kEyeStiffness_radps * eye.offset_m;
    const Real offset = (eye.offset_m + slope * dt) * decay;
    eye.offset_mps = (eye.offset_mps - kEyeStiffness_radps * slope * dt) * decay;
    eye.offset_m = offset;
    return eye;
}

}  // namespace

Character::Impl::Impl(PhysicsWorld& physics_world, const CharacterDef& definition)
    : world(physics_world),
      def(definition),
      probe(physics_world, definition),
      dt(static_cast<Real>(physics_world.def().step_s)),
      gravity_mps2(-physics_world.def().gravity_mps2.y),
      cos_limit(portable_cos(definition.max_slope_rad)),
      eye{.height_m = definition.height_m - definition.eye_below_top_m} {
    PL_ASSERT(is_finite(definition.feet_position_m), "feet at a finite place");
    const std::array<Real, 2> heights{def.height_m, def.crouched_height_m};
    for (std::size_t i = 0; i < body_shapes.size(); ++i) {
        const Real between = heights[i] - kBodyAboveFeet_m - 2 * def.radius_m;
        const auto shape = world.create_shape(
            CapsuleShape{.radius_m = def.radius_m, .height_m = std::max(between, 0.01_r)});
        PL_ASSERT(shape.ok(), "a capsule within the limits");
        body_shapes[i] = shape.value();
    }
    teleport(definition.feet_position_m);
}

Character::Impl::~Impl() {
    if (world.contains(body)) world.destroy_body(body);
}

void Character::Impl::make_body() {
    if (world.contains(body)) world.destroy_body(body);
    body = world.create_body({.kind = BodyKind::Kinematic,
                              .shape = body_shapes[crouched ? 1 : 0],
                              .world_from_body = body_pose(0),
                              .friction = 0.5_r,
                              .filter = {.group = def.group, .collides_with = def.collides_with},
                              .user = kCharacterMark});
    probe.set_own_body(body);
}

void Character::Impl::serialize(Archive& archive) {
    BodyId own = body;
    archive(own,
            dt,
            feet,
            velocity,
            footing,
            ground,
            ride,
            crouched,
            pinned,
            since_ground_s,
            wedged_s,
            eye,
            state);
    constexpr double kFarthest_m = 1e8;
    const bool is_near =
        glm::length(feet) < kFarthest_m && glm::length(Vec3d{velocity}) < kFarthest_m;
    archive.expect(is_near && dt > 0 && dt <= 1, "the person is nowhere");
    if (!archive.reads() || archive.failed()) return;
    world.destroy_body(body);
    body = {};
    probe.set_crouched(crouched);
    if (!archive.expect(world.reserve_body(own), "the person's body has another's place")) return;
    make_body();
}

void Character::Impl::find_free_place(const Vec3& wanted) {
    constexpr int kTries = 200;
    constexpr double kApart_m = 0.1;
    feet = Vec3d(wanted);
    const auto has_floor = [&](const Vec3d& from) {
        const Vec3 at(from);
        return probe.ray(at + kUp * 0.1_r, at - kUp * 1000.0_r).has_value();
    };
    if (probe.is_free(feet) && has_floor(feet)) return;
    // In paving or in a floor: the person stands on it.
    if (const auto floor = probe.ray(wanted + kUp * def.step_up_m, wanted)) {
        feet = Vec3d(floor->point_world);
        if (probe.is_free(feet)) return;
    }
    // The nearest place above, so that a roof is the last of all.
    for (int i = 0; i < kTries; ++i) {
        feet = Vec3d(wanted) + Vec3d(kUp) * (kApart_m * i);
        if (probe.is_free(feet) && has_floor(feet)) return;
    }
    // Far below everything: the ground, if there is any, is above.
    feet = Vec3d(wanted);
    if (const auto above = probe.ray(wanted + kUp * 500.0_r, wanted))
        feet = Vec3d(above->point_world);
    for (int i = 0; i < kTries && !probe.is_free(feet); ++i) feet.y += kApart_m;
}

void Character::Impl::teleport(const Vec3& place) {
    const Vec3 wanted = is_finite(place) ? place : Vec3(feet);
    probe.set_crouched(crouched);
    find_free_place(wanted);
    velocity = {0, 0, 0};
    footing = Footing::Air;
    ground = {};
    ride.reset();
    since_ground_s = 1;
    eye.offset_m = 0;
    eye.offset_mps = 0;
    state.landing_speed_mps = 0;
    make_body();
    state = seen();
}

Vec3 Character::Impl::wish_velocity(const CharacterInput& input) const {
    Vec3 direction = is_finite(input.direction_world) ? level(input.direction_world) : Vec3{0};
    const Real length = glm::length(direction);
    if (length > 1) direction /= length;
    direction *= input.pace;
    if (crouched) return direction * def.crouch_speed_mps;
    return direction * (input.run ? def.run_speed_mps : def.walk_speed_mps);
}

void Character::Impl::change_posture(bool crouch) {
    if (crouch == crouched) return;
    if (!crouch) {
        const Real grow = def.height_m - def.crouched_height_m;
        if (probe.sweep(feet, kUp * grow)) return;  // no headroom
    }
    crouched = crouch;
    probe.set_crouched(crouch);
    make_body();
}

void Character::Impl::update(const CharacterInput& input) {
    state.landing_speed_mps = 0;
    state.crouch_wanted = input.crouch;
    probe.set_unseen({});
    const Vec3d start = feet;
    const Real ridden_yaw_rad = follow_ride();
    state.squeezed = give_way();
    // What the person still is deep in would answer every question with nonsense; the floor must
    // go on carrying meanwhile.
    const std::optional<BodyId> pinning = pinning_body();
    pinned = pinning.has_value();
    if (pinned) probe.set_unseen(*pinning);
    change_posture(input.crouch);
    Vec3 wish = wish_velocity(input);
    if (pinned) wish *= kPinnedPace;  // slower than the way out
    if (const auto up = input.jump ? jump_velocity() : std::nullopt) {
        leave_ground(*up);
        since_ground_s = 1;
        wedged_s = 0;
    }
    if (footing == Footing::Ground) {
        walk(wish);
    } else {
        lie_on(input.borne_N);
        fly(wish);
    }
    move_swept(way_to_gaps(), {});
    ride = ride_on_ground();
    press_down();
    const Real carried_yaw_rad = carry();
    state.ridden_yaw_rad = is_on_a_platform() ? ridden_yaw_rad + carried_yaw_rad : Real{0};
    if (!is_finite(Vec3(feet)) || !is_finite(velocity)) {
        feet = start;
        velocity = {0, 0, 0};
    }
    eye = settled(eye,
                  probe.height_m() - def.eye_below_top_m,
                  (def.height_m - def.crouched_height_m) / kCrouchTime_s * dt,
                  def.step_up_m,
                  dt);
    // The felt capsule climbs stairs as smoothly as the eye, so that it kicks nothing upwards.
    world.move_kinematic(body, body_pose(std::clamp(eye.offset_m, -def.step_up_m, Real{0})));
    state = seen();
}

Pose Character::Impl::body_pose(Real raised_m) const {
    const Real middle = (kBodyAboveFeet_m + probe.height_m()) / 2;
    return {.position = Vec3(feet) + kUp * (middle + raised_m)};
}

/// The state as the step leaves it.
CharacterState Character::Impl::seen() const {
    CharacterState now = state;
    const Vec3 here = Vec3(feet);
    now.feet_position_m = here;
    Real eye_m = eye.height_m + eye.offset_m;
    if (eye.offset_m > 0.05_r) {
        // On the way down a stair the eye may be above the head: not into the lintel.
        const auto lintel = probe.ray(here + kUp * eye.height_m, here + kUp * (eye_m + 0.1_r));
        if (lintel) eye_m = std::max(eye.height_m, lintel->point_world.y - here.y - 0.1_r);
    }
    now.eye_position_m = here + kUp * eye_m;
    now.velocity_mps = velocity;
    now.walking_mps = footing == Footing::Ground ? velocity : Vec3{0, 0, 0};
    if (footing == Footing::Ground && ride) now.velocity_mps += ride->velocity;
    now.footing = footing;
    now.ground_body = footing == Footing::Ground ? ground.body : BodyId{};
    now.ground_normal_world = footing == Footing::Ground ? ground.face_normal : kUp;
    now.crouched = crouched;
    return now;
}

Character::Character(PhysicsWorld& world, const CharacterDef& def)
    : impl_(std::make_unique<Impl>(world, def)) {}

Character::~Character() = default;

void Character::update(const CharacterInput& input) {
    impl_->update(input);
}

const CharacterState& Character::state() const {
    return impl_->state;
}

const CharacterDef& Character::def() const {
    return impl_->def;
}

BodyId Character::body() const {
    return impl_->body;
}

void Character::serialize(Archive& archive) {
    archive(*impl_);
}

void Character::teleport(const Vec3& feet_position_m) {
    impl_->teleport(feet_position_m);
}

}  // namespace plumbline::physics

#include "game/rules/camera_rig.h"

#include "engine/physics/query.h"
#include "game/rules/hands/aim.h"

#include <algorithm>
#include <initializer_list>

namespace plumbline::game {

namespace {

constexpr Real kNotch = 1.25_r;
constexpr Real kSprint = 3;
constexpr Real kFlySmoothing_s = 0.08_r;
constexpr Real kOrbitClearance = 0.3_r;    // of the distance, where that is less
constexpr Real kModelClearance = 0.005_r;  // of its radius; further than the near plane
constexpr Real kTouching = 1e-5_r;         // of the depth that is looked into
constexpr int kHalvings = 12;              // of a step that would end under the ground
constexpr Real kOrbitTurn_radps = 1.6_r;
constexpr Real kOrbitZoom_per_s = 1.5_r;
constexpr Real kOrbitNotch = 0.88_r;

Quat orientation_of(Real yaw_rad, Real pitch_rad) {
    return portable_angle_axis(yaw_rad, Vec3{0, 1, 0}) *
           portable_angle_axis(pitch_rad, Vec3{1, 0, 0});
}

Real clamped_pitch(Real pitch_rad) {
    return std::clamp(pitch_rad, -CameraLook::kSteepest_rad, CameraLook::kSteepest_rad);
}

/// The largest share of a step that `is_free`, which its start is.
template <class IsFree>
Real free_share(const IsFree& is_free) {
    Real free = 0;
    Real blocked = 1;
    for (int i = 0; i < kHalvings; ++i) {
        const Real middle = (free + blocked) / 2;
        (is_free(middle) ? free : blocked) = middle;
    }
    return free;
}

}  // namespace

bool GroundBelow::operator()(const Vec3& place_m) const {
    if (hidden) return true;
    const Vec3 deep_m = place_m - Vec3{0, deepest_m, 0};
    auto hit = cast_ray(world, place_m, deep_m, {.ignored = own_body});
    // What the place itself lies in may be met at once; ground is what comes after it.
    if (hit && hit->distance_m < kTouching * deepest_m) {
        hit = cast_ray(world, place_m, deep_m, {.ignored = own_body, .also_ignored = hit->body});
    }
    return hit.has_value();
}

Real travel_of(const Actions& actions, Action action) {
    if (!actions.is_held(action)) return 0;
    const Real amount = Real{actions.amount_of(action)};
    // Keys may come without an amount; sticks always carry theirs.
    return amount > 0 && amount < 1 ? amount : Real{1};
}

int KeyRepeat::acts(int presses, int direction, Real step_s) {
    constexpr Real kFirst_s = 0.4_r;
    if (presses != 0) {
        wait_s_ = kFirst_s;
        return presses;
    }
    if (direction == 0) return 0;
    wait_s_ -= step_s;
    if (wait_s_ > 1e-5_r) return 0;
    wait_s_ += every_s_;
    return direction;
}

void CameraLook::set(Real yaw_rad, Real pitch_rad) {
    yaw_rad_ = std::remainder(yaw_rad, 2 * kPi);
    pitch_rad_ = clamped_pitch(pitch_rad);
    smooth_yaw_rad_ = 0;
    smooth_pitch_rad_ = 0;
}

void CameraLook::start_from(const Quat& orientation) {
    start_ = orientation;
    set(0, 0);
}

Vec3 CameraLook::right() const {
    return start_ * level_right(yaw_rad_);
}

int notches_of(const Actions& actions, Action more, Action less) {
    const auto steps = [&](Action action) {
        return actions.is_held(action) ? 0 : actions.presses(action);
    };
    return steps(more) - steps(less);
}

void CameraLook::aim_along(const Vec3& direction) {
    const Vec3 unit = normalize_or(direction, Vec3{0, 0, -1});
    set(portable_atan2(-unit.x, -unit.z), portable_asin(std::clamp(unit.y, Real{-1}, Real{1})));
}

void CameraLook::begin_step() {
    smooth_yaw_rad_ = 0;
    smooth_pitch_rad_ = 0;
}

void CameraLook::turn(Real yaw_rad, Real pitch_rad) {
    if (!std::isfinite(yaw_rad) || !std::isfinite(pitch_rad)) return;
    yaw_rad_ = std::remainder(yaw_rad_ + yaw_rad, 2 * kPi);
    pitch_rad_ = clamped_pitch(pitch_rad_ + pitch_rad);
}

void CameraLook::turn_smoothly(Real yaw_rad, Real pitch_rad) {
    const Real before = pitch_rad_;
    turn(yaw_rad, pitch_rad);
    smooth_yaw_rad_ += yaw_rad;
    smooth_pitch_rad_ += pitch_rad_ - before;
}

Quat CameraLook::orientation() const {
    return orientation_at(yaw_rad_, pitch_rad_);
}

Quat CameraLook::orientation_at(Real yaw_rad, Real pitch_rad) const {
    return start_ * orientation_of(yaw_rad, pitch_rad);
}

Quat CameraLook::orientation(Real blend, Real pending_yaw_rad, Real pending_pitch_rad) const {
    const Real rest = 1 - blend;
    return start_ *
           orientation_of(yaw_rad_ - smooth_yaw_rad_ * rest + pending_yaw_rad,
                          clamped_pitch(pitch_rad_ - smooth_pitch_rad_ * rest + pending_pitch_rad));
}

void FlyCamera::place(const Vec3& position_m) {
    position_m_ = position_m;
    previous_m_ = position_m;
    velocity_mps_ = {0, 0, 0};
}

void FlyCamera::change_speed(int notches) {
    speed_mps_ = std::clamp(speed_mps_ * whole_power(kNotch, notches), slowest_mps_, fastest_mps_);
}

void FlyCamera::suit(Real radius_m) {
    constexpr Real kRange = 50;
    speed_mps_ = radius_m;
    slowest_mps_ = radius_m / kRange;
    fastest_mps_ = radius_m * kRange;
    clearance_m_ = radius_m * kModelClearance;
}

void FlyCamera::act(const Actions& actions,
                    const CameraLook& look,
                    const GroundBelow& ground,
                    Real step_s) {
    const Vec3 forward = look.orientation() * Vec3{0, 0, -1};
    Vec3 wish =
        forward * (travel_of(actions, Action::Forward) - travel_of(actions, Action::Back)) +
        look.right() * (travel_of(actions, Action::Right) - travel_of(actions, Action::Left));
    wish += up_ * (travel_of(actions, Action::Jump) - travel_of(actions, Action::Crouch));
    if (glm::length(wish) > 1) wish = glm::normalize(wish);
    wish *= speed_mps_ * (actions.is_held(Action::Sprint) ? kSprint : Real{1});
    velocity_mps_ += (wish - velocity_mps_) * (1 - portable_exp(-step_s / kFlySmoothing_s));
    previous_m_ = position_m_;
    position_m_ += velocity_mps_ * step_s;
    const auto is_above = [&](const Vec3& eye_m, Real clearance_m) {
        return ground(eye_m - Vec3{0, clearance_m, 0});
    };
    const Vec3 level{position_m_.x, previous_m_.y, position_m_.z};
    if (position_m_.y >= previous_m_.y || is_above(position_m_, clearance_m_)) return;
    // Past the edge of the world, or under the ground already. Half, as the last step ended near it.
    if (!is_above(level, clearance_m_ / 2)) return;
    const Vec3 down = position_m_ - level;
    const Real share =
        free_share([&](Real part) { return is_above(level + down * part, clearance_m_); });
    position_m_ = level + down * share;
    velocity_mps_.y = 0;
}

Vec3 FlyCamera::position_m(Real blend) const {
    return glm::mix(previous_m_, position_m_, blend);
}

void OrbitCamera::place(const Vec3& target_m, Real distance_m, Real pitch_rad) {
    target_m_ = target_m;
    distance_m_ = std::clamp(distance_m, nearest_m_, farthest_m_);
    previous_distance_m_ = distance_m_;
    steady_pitch_rad_ = pitch_rad;
}

void OrbitCamera::suit(Real radius_m) {
    nearest_m_ = radius_m * 0.02_r;
    farthest_m_ = radius_m * 50;
    clearance_m_ = radius_m * kModelClearance;
}

void OrbitCamera::pan(const Quat& orientation, Real yaw_rad, Real pitch_rad) {
    if (!std::isfinite(yaw_rad) || !std::isfinite(pitch_rad)) return;
    target_m_ += orientation * Vec3{yaw_rad, -pitch_rad, 0} * distance_m_;
}

void OrbitCamera::go_by_steps(Real turn_rad, Real zoom_m) {
    steps_ = Steps{.turn_rad = turn_rad, .zoom_m = zoom_m};
}

void OrbitCamera::act_smoothly(const Actions& actions, CameraLook& look, Real step_s) {
    const Real turn = kOrbitTurn_radps * step_s;
    const Real left = travel_of(actions, Action::RotateLeft) + travel_of(actions, Action::Left);
    const Real right = travel_of(actions, Action::RotateRight) + travel_of(actions, Action::Right);
    const Real up = travel_of(actions, Action::Forward) - travel_of(actions, Action::Back);
    // The camera goes to the right when its view turns to the left.
    look.turn_smoothly((right - left) * turn, -up * turn);

    const Real zoom = travel_of(actions, Action::ZoomOut) - travel_of(actions, Action::ZoomIn);
    const int notches = actions.presses(Action::Push) - actions.presses(Action::Pull) +
                        notches_of(actions, Action::ZoomIn, Action::ZoomOut);
    distance_m_ *=
        portable_exp(zoom * kOrbitZoom_per_s * step_s) * whole_power(kOrbitNotch, notches);
}

void OrbitCamera::act_by_steps(const Actions& actions, CameraLook& look, Real step_s) {
    const auto acts = [&](KeyRepeat& repeat,
                          std::initializer_list<Action> more,
                          std::initializer_list<Action> less) {
        int presses = 0;
        int direction = 0;
        for (const Action action : more) {
            presses += actions.presses(action);
            if (actions.is_held(action)) ++direction;
        }
        for (const Action action : less) {
            presses -= actions.presses(action);
            if (actions.is_held(action)) --direction;
        }
        return static_cast<Real>(repeat.acts(presses, std::clamp(direction, -1, 1), step_s));
    };
    Steps& steps = *steps_;
    const Real right =
        acts(steps.yaw, {Action::RotateRight, Action::Right}, {Action::RotateLeft, Action::Left});
    const Real down = acts(steps.pitch, {Action::Back}, {Action::Forward});
    look.turn_smoothly(right * steps.turn_rad, down * steps.turn_rad);
    const Real out =
        acts(steps.zoom, {Action::ZoomOut, Action::Pull}, {Action::ZoomIn, Action::Push});
    distance_m_ += out * steps.zoom_m;
}

void OrbitCamera::act(const Actions& actions,
                      CameraLook& look,
                      const GroundBelow& ground,
                      Real step_s) {
    previous_distance_m_ = distance_m_;
    if (steps_) {
        act_by_steps(actions, look, step_s);
    } else {
        act_smoothly(actions, look, step_s);
    }
    distance_m_ = std::clamp(distance_m_, nearest_m_, farthest_m_);
    stay_above(ground, look);
    steady_pitch_rad_ = look.pitch_rad();
}

void OrbitCamera::stay_above(const GroundBelow& ground, CameraLook& look) {
    const Real pitch = look.pitch_rad() - steady_pitch_rad_;
    const Real zoom = distance_m_ - previous_distance_m_;
    const auto is_above = [&](Real part, Real clearance_share) {
        const Real distance = previous_distance_m_ + zoom * part;
        const Vec3 eye_m =
            target_m_ + look.orientation_at(look.yaw_rad(), steady_pitch_rad_ + pitch * part) *
                            Vec3{0, 0, distance};
        const Real clearance_m = std::min(clearance_m_, kOrbitClearance * distance);
        return ground(eye_m - Vec3{0, clearance_m * clearance_share, 0});
    };
    if (is_above(1, 1) || !is_above(0, 0.5_r)) return;
    const Real share = free_share([&](Real part) { return is_above(part, 1); });
    look.turn_smoothly(0, (share - 1) * pitch);
    distance_m_ = previous_distance_m_ + zoom * share;
}

void OrbitCamera::serialize(Archive& archive) {
    archive(target_m_, distance_m_, previous_distance_m_, steady_pitch_rad_);
    if (steps_) archive(steps_->yaw, steps_->pitch, steps_->zoom);
}

Vec3 OrbitCamera::position_m(const Quat& orientation, Real blend) const {
    const Real distance = glm::mix(previous_distance_m_, distance_m_, blend);
    return target_m_ + orientation * Vec3{0, 0, distance};
}

}  // namespace plumbline::game

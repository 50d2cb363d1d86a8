// The direction of view, and the two cameras that are not a person: free flight and orbit.
//
// Cameras move in fixed steps like everything else; the frame blends between two of them. What the
// mouse turns is applied at once and never blended.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/io/pose_archive.h"
#include "engine/core/pose.h"
#include "engine/physics/physics_world.h"

#include <optional>

namespace plumbline::game {

enum class MoveMode : std::uint8_t { Walk, Fly, Orbit };

/// How far a held action is pressed: 0…1.
Real travel_of(const Actions& actions, Action action);
/// Wheel steps: presses of what is not held. `more` counts up, `less` down.
int notches_of(const Actions& actions, Action more, Action less);

/// A key that acts once a press and, while it stays down, again and again after a while.
class KeyRepeat {
public:
    explicit KeyRepeat(Real acts_per_s) : every_s_(1 / acts_per_s) {}
    /// How often it acts in this step. Of two keys against each other `presses` is the difference and
    /// `direction`, -1, 0 or 1, that of those which are down.
    int acts(int presses, int direction, Real step_s);
    void serialize(Archive& archive) { archive(wait_s_); }

private:
    Real every_s_;
    Real wait_s_{0};
};

/// Yaw about +Y (left is positive), pitch (up is positive).
class CameraLook {
public:
    static constexpr Real kSteepest_rad = radians_from_degrees(89.0_r);

    void set(Real yaw_rad, Real pitch_rad);
    /// From now on yaw and pitch turn this orientation, about its own axes, and begin at 0.
    void start_from(const Quat& orientation);
    void aim_along(const Vec3& direction);
    /// From the mouse or stick: the frame has shown it already.
    void turn(Real yaw_rad, Real pitch_rad);
    /// From keys or a turning floor: the frame blends it in.
    void turn_smoothly(Real yaw_rad, Real pitch_rad);
    void begin_step();

    Real yaw_rad() const { return yaw_rad_; }
    Real pitch_rad() const { return pitch_rad_; }
    Vec3 right() const;
    Quat orientation() const;
    Quat orientation_at(Real yaw_rad, Real pitch_rad) const;
    /// Between the last two steps, with look added that no step has seen yet.
    Quat orientation(Real blend, Real pending_yaw_rad, Real pending_pitch_rad) const;
    void serialize(Archive& archive) {
        archive(start_, yaw_rad_, pitch_rad_, smooth_yaw_rad_, smooth_pitch_rad_);
    }

private:
    Quat start_{kNoRotation};
    Real yaw_rad_{0};
    Real pitch_rad_{0};
    Real smooth_yaw_rad_{0};  ///< part of the latest step that the frame still has to show
    Real smooth_pitch_rad_{0};
};

/// What keeps cameras above the ground. Ground is whatever lies under a place, not too deep; where
/// there is none, past the edge of the world, a camera may go down.
struct GroundBelow {
    const physics::PhysicsWorld& world;
    physics::BodyId own_body{};  ///< the person's capsule is no ground
    bool hidden{false};          ///< nobody sees it: it holds no camera
    Real deepest_m{100};         ///< longer rays are less exact at their start

    bool operator()(const Vec3& place_m) const;
};

/// Flies through everything but the ground, where it looks.
class FlyCamera {
public:
    void place(const Vec3& position_m);
    void act(const Actions& actions,
             const CameraLook& look,
             const GroundBelow& ground,
             Real step_s);
    /// One notch of the wheel: +1 faster, -1 slower.
    void change_speed(int notches);
    /// For a model of another size than gardens: one radius a second at first, and bounds around it.
    void suit(Real radius_m);
    /// Which way jump and crouch take it; +Y unless said.
    void set_up(const Vec3& up) { up_ = up; }

    Vec3 position_m(Real blend) const;
    const Vec3& velocity_mps() const { return velocity_mps_; }
    Real speed_mps() const { return speed_mps_; }
    void serialize(Archive& archive) {
        archive(position_m_, previous_m_, velocity_mps_, speed_mps_);
    }

private:
    Vec3 position_m_{0, 0, 0};
    Vec3 previous_m_{0, 0, 0};
    Vec3 velocity_mps_{0, 0, 0};
    Vec3 up_{0, 1, 0};
    Real speed_mps_{5};
    Real slowest_mps_{0.1_r};
    Real fastest_mps_{200};
    Real clearance_m_{0.15_r};  ///< over the ground
};

/// Turns around a point.
class OrbitCamera {
public:
    static constexpr Real kNearest_m = 0.1_r;
    static constexpr Real kFarthest_m = 500;

    void place(const Vec3& target_m, Real distance_m, Real pitch_rad);
    /// For things of another size than gardens: how near and far it goes for that radius.
    void suit(Real radius_m);
    /// Moves what it turns around across the image, by angles as the pointer gives them.
    void pan(const Quat& orientation, Real yaw_rad, Real pitch_rad);
    /// From now on keys turn and zoom by steps: one a press, and while held ten a second.
    void go_by_steps(Real turn_rad, Real zoom_m);
    /// Turns `look` by the keys as well, and back where that would take the eye under the ground.
    void act(const Actions& actions, CameraLook& look, const GroundBelow& ground, Real step_s);

    Vec3 position_m(const Quat& orientation, Real blend) const;
    Real distance_m() const { return distance_m_; }
    const Vec3& target_m() const { return target_m_; }
    void serialize(Archive& archive);

private:
    struct Steps {
        Real turn_rad;
        Real zoom_m;
        KeyRepeat yaw{10};
        KeyRepeat pitch{10};
        KeyRepeat zoom{10};
    };
    void act_smoothly(const Actions& actions, CameraLook& look, Real step_s);
    void act_by_steps(const Actions& actions, CameraLook& look, Real step_s);
    void stay_above(const GroundBelow& ground, CameraLook& look);

    Vec3 target_m_{0, 0, 0};
    Real distance_m_{5};
    Real previous_distance_m_{5};
    Real steady_pitch_rad_{0};  ///< of the last step
    Real nearest_m_{kNearest_m};
    Real farthest_m_{kFarthest_m};
    Real clearance_m_{0.1_r};  ///< over the ground
    std::optional<Steps> steps_;
};

}  // namespace plumbline::game

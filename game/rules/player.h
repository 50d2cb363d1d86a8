// The person who walks: actions to the physics' character, and what the feet are heard doing.
#pragma once

#include "engine/core/actions.h"
#include "engine/physics/character.h"
#include "engine/scene/game.h"
#include "engine/scene/simulation.h"
#include "game/rules/camera_rig.h"
#include "game/rules/hands/grab.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace plumbline::game {

class Player {
public:
    /// The simulation must outlive the player. A blocked start is moved to the nearest free place.
    Player(scene::Simulation& simulation, const Vec3& feet_m);

    /// One step of walking where `look` points; `walks` false: stands still (another camera is on).
    void act(scene::Simulation& simulation, const Actions& actions, CameraLook& look, bool walks);
    void teleport(const Vec3& feet_m);
    /// A place on what is looked at where one can sit: a level face at the height of a seat, with room above.
    std::optional<Vec3> seat_at(const scene::Simulation& simulation, const Looked& looked) const;
    /// Sits there, until the person walks, jumps, crouches or stands up; one who drives, until the person stands up. What hangs on
    /// joints or ropes is swung by the keys of walking instead.
    void sit(const Vec3& seat_m, physics::BodyId seat, bool drives = false);
    void stand_up() { sits_ = drives_ = false; }
    bool sits() const { return sits_; }
    /// One notch of the wheel: +1 faster, -1 slower. Returns the walking speed, m/s.
    Real change_pace(int notches);

    Vec3 eye_m(Real blend) const;
    const physics::CharacterState& state() const { return character_->state(); }
    const physics::CharacterDef& def() const { return character_->def(); }
    physics::BodyId body() const { return character_->body(); }
    void serialize(Archive& archive) {
        archive(*character_, previous_eye_m_, pace_, stride_m_, sits_, drives_, seat_, lowered_m_);
    }
    /// Of the latest step.
    std::span<const scene::FootstepEvent> footsteps() const { return footsteps_; }

private:
    void listen_to_feet(const scene::Simulation& simulation);
    Vec3 eye_now_m() const;
    Real seat_away_m(const scene::Simulation& simulation) const;

    std::unique_ptr<physics::Character> character_;
    physics::ShapeId seated_{};  ///< the room that a person takes who sits
    bool sits_{false};
    bool drives_{false};
    physics::BodyId seat_{};  ///< what was sat on last
    Real lowered_m_{0};       ///< the eye, against that of a person who crouches
    Vec3 previous_eye_m_{0, 0, 0};
    Real pace_{1};
    Real stride_m_{0};  ///< gone since the last footstep
    std::vector<scene::FootstepEvent> footsteps_;
};

}  // namespace plumbline::game

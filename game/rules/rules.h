// The playground: walk, look, drop, throw, grab. All that changes the world happens in act(), from
// actions alone, so that a recording replays to the last bit.
#pragma once

#include "engine/scene/game.h"
#include "game/rules/camera_rig.h"
#include "game/rules/goal.h"
#include "game/rules/grab.h"
#include "game/rules/player.h"
#include "game/rules/things.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::game {

/// So many fields because each thing that a person can do in the playground keeps its own state here.
class PlaygroundGame final : public scene::Game {
public:
    /// For a freshly built simulation, which must outlive it. Things come from
    /// assets_folder/scenes/things.toml where the scene has no prefabs of their names.
    PlaygroundGame(scene::Simulation& simulation, const std::filesystem::path& assets_folder);

    void act(scene::Simulation& simulation, const Actions& actions) override;
    void judge(scene::Simulation& simulation) override;
    scene::ViewPoint view(const scene::Simulation& simulation,
                          Real blend,
                          float pending_yaw_rad,
                          float pending_pitch_rad) const override;
    std::span<const scene::FootstepEvent> footsteps() const override;
    /// Messages since the last call are handed over.
    scene::HudContent hud(const scene::Simulation& simulation) override;

    bool holds() const override { return grab_.holding(); }
    bool crouches() const override { return player_ && player_->state().crouch_wanted; }
    bool frees_pointer() const override { return views_model(); }
    std::string_view kind() const override { return "the playground"; }
    void serialize(Archive& archive, scene::Simulation& simulation) override;

    MoveMode mode() const { return mode_; }
    const Player* player() const { return player_ ? &*player_ : nullptr; }
    const Things& things() const { return things_; }
    const Grab& grab() const { return grab_; }
    const Goal* goal() const { return goal_ ? &*goal_ : nullptr; }

private:
    // rules.cpp
    void move(scene::Simulation& simulation, const Actions& actions);
    void change_speed(const Actions& actions);
    void next_mode(scene::Simulation& simulation);
    void zoom(const Actions& actions);
    Vec3 eye_m(Real blend, const Quat& orientation) const;
    Vec3 viewer_velocity_mps() const;
    Aim aim() const;
    void say(std::string message);

    // rules_viewer.cpp
    /// A model by itself is turned, not played with, until the mode is changed.
    bool views_model() const { return model_radius_m_ > 0 && mode_ == MoveMode::Orbit; }
    /// A JSON scene is only looked at, in every mode.
    bool views_scene() const { return viewer_radius_m_ > 0; }
    void begin_view(const scene::SceneDescription& scene);
    /// Flying or orbiting: nobody walks where nothing bears.
    void next_view(const scene::ViewerDescription& viewer);
    void show_lit(scene::Simulation& simulation, const Actions& actions);
    void turn_model(const Actions& actions);
    void switch_aids(scene::Simulation& simulation, const Actions& actions);

    // rules_things.cpp
    void begin_goal(const scene::Simulation& simulation);
    void choose(const Actions& actions);
    void drop(scene::Simulation& simulation, const Actions& actions);
    void put_one(scene::Simulation& simulation, const Vec3& velocity_mps);
    void charge_and_throw(scene::Simulation& simulation, const Actions& actions);
    void launch(scene::Simulation& simulation, Real charge);
    void hold(scene::Simulation& simulation, const Actions& actions);
    void freeze(scene::Simulation& simulation);
    void remove_looked_at(scene::Simulation& simulation);
    /// What the hands may not touch: says so.
    bool is_guarded(ecs::Entity entity);

    // rules_forces.cpp
    void shoot(scene::Simulation& simulation, const Actions& actions);
    void lift(scene::Simulation& simulation, const Actions& actions);
    void explode(scene::Simulation& simulation, const Actions& actions);

    // rules_light.cpp
    void light(scene::Simulation& simulation, const Actions& actions);
    void change_fog(scene::Simulation& simulation, const Actions& actions);
    void aim_spot(scene::Simulation& simulation, const Actions& actions);

    Real step_s_;
    MoveMode mode_{MoveMode::Walk};
    CameraLook look_;
    FlyCamera fly_;
    OrbitCamera orbit_;
    std::optional<Player> player_;
    Things things_;
    Grab grab_;
    std::optional<Goal> goal_;
    Vec3 start_feet_m_{0, 0, 0};
    Real base_fov_rad_;
    Real fov_rad_;
    Real previous_fov_rad_;
    KeyRepeat drop_repeat_{6};
    Real throw_held_s_{-1};  ///< how long throw is down; negative: it is not
    bool grab_was_held_{false};
    bool chooses_{true};                           ///< among the things to drop
    std::optional<std::array<float, 2>> pointer_;  ///< as the latest step was told
    physics::BodyId lifted_{};
    physics::ShapeId explosion_{};  ///< the ball it reaches; none before the first
    bool look_turns_held_{false};
    Real model_radius_m_{0};   ///< 0: the scene is more than a model
    Real viewer_radius_m_{0};  ///< 0: it is no JSON scene
    bool drags_view_{false};
    static constexpr Real kDragGain = 4;  // a drag across the window turns a model about once
    std::vector<std::string> messages_;
};

}  // namespace plumbline::game

// The playground: walk, look, drop, throw, grab. All that changes the world happens in act(), from
// actions alone, so that a recording replays to the last bit.
#pragma once

#include "engine/scene/game.h"
#include "game/rules/camera_rig.h"
#include "game/rules/drive.h"
#include "game/rules/goal.h"
#include "game/rules/hands/grab.h"
#include "game/rules/hands/things.h"
#include "game/rules/hands/tying.h"
#include "game/rules/player.h"
#include "game/rules/use.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::game {

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
    /// Round what the hands would take or use, and where a dropped thing would land, while things are put.
    void add_lines(const scene::Simulation& simulation, Real blend, LineList& lines) const override;
    /// Messages since the last call are handed over.
    scene::HudContent hud(const scene::Simulation& simulation) override;

    bool holds() const override { return grab_.holding(); }
    bool crouches() const override {
        return player_ && player_->state().crouch_wanted && !player_->sits();
    }
    bool frees_pointer() const override { return views_model(); }
    std::string_view kind() const override { return "the playground"; }
    void serialize(Archive& archive, scene::Simulation& simulation) override;

    MoveMode mode() const { return mode_; }
    const Player* player() const { return player_ ? &*player_ : nullptr; }
    const Things& things() const { return things_; }
    const Grab& grab() const { return grab_; }
    std::optional<double> won_in_s() const override {
        return goal_ ? goal_->won_in_s() : std::nullopt;
    }
    const Goal* goal() const { return goal_ ? &*goal_ : nullptr; }

private:
    // rules.cpp
    /// Looks up, once a step, every id that a rule keeps from one step to the next: those of what left
    /// the world are null or off their lists from here on. Again after a rule takes something out.
    void forget_gone(scene::Simulation& simulation);
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
    bool views_model() const { return viewed_.model_radius_m > 0 && mode_ == MoveMode::Orbit; }
    /// A JSON scene is only looked at, in every mode.
    bool views_scene() const { return viewed_.scene_radius_m > 0; }
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
    /// In the hand, or looked at. Null: it was said why.
    ecs::Entity thing_to(std::string_view verb, const scene::Simulation& simulation);
    void freeze(scene::Simulation& simulation);
    void tie(scene::Simulation& simulation, const Actions& actions);
    void remove_looked_at(scene::Simulation& simulation);
    /// What the hands may not touch: says so.
    bool is_guarded(ecs::Entity entity);

    // rules_use.cpp
    /// What the use key would do now, at most one of them.
    struct Use {
        std::optional<Swing> door{};
        ecs::Entity lamp{};
        std::optional<Vec3> seat_m{};
        std::optional<DriverSeat> drive{};
        ecs::Entity entity{};  ///< what is used: the leaf, the lamp, what is sat on
    };
    Use use_at(const scene::Simulation& simulation, const Aim& aim) const;
    void use(scene::Simulation& simulation, const Actions& actions);
    std::string use_words(const scene::Simulation& simulation, const Use& use) const;

    // rules_forces.cpp
    void shoot(scene::Simulation& simulation, const Actions& actions);
    void lift(scene::Simulation& simulation, const Actions& actions);
    void explode(scene::Simulation& simulation, const Actions& actions);

    // rules_light.cpp
    void light(scene::Simulation& simulation, const Actions& actions);
    void change_fog(scene::Simulation& simulation, const Actions& actions);
    void aim_spot(scene::Simulation& simulation, const Actions& actions);

    struct FieldOfView {
        Real base_rad;
        Real now_rad;
        Real previous_rad;  ///< before the latest step
        void serialize(Archive& archive) { archive(base_rad, now_rad, previous_rad); }
    };
    /// What the keys of the hands did in the steps before.
    struct HandKeys {
        Real throw_s{-1};  ///< how long throw is down; negative: it is not
        bool grabbed{false};
        bool look_turns_held{false};
        physics::BodyId lifted{};  ///< what the lift key took; null: nothing
        void serialize(Archive& archive) { archive(throw_s, grabbed, look_turns_held, lifted); }
    };
    struct Dropping {
        KeyRepeat repeat{6};
        bool chooses{true};      ///< among the things to drop
        Real preview_left_s{0};  ///< how long the place of the next drop is shown
        void serialize(Archive& archive) { archive(repeat, preview_left_s); }
    };
    /// What is only looked at.
    struct Viewed {
        static constexpr Real kDragGain = 4;  ///< a drag across the window turns a model about once
        Real model_radius_m{0};               ///< 0: the scene is more than a model
        Real scene_radius_m{0};               ///< 0: it is no JSON scene
        bool is_dragged{false};
    };

    Real step_s_;
    MoveMode mode_{MoveMode::Walk};
    CameraLook look_;
    FlyCamera fly_;
    OrbitCamera orbit_;
    FieldOfView fov_;
    std::optional<Player> player_;
    Vec3 start_feet_m_{0, 0, 0};
    Things things_;
    Dropping dropping_;
    Grab grab_;
    HandKeys keys_;
    Tying tying_;
    Doors doors_;
    Driver driver_;
    physics::ShapeId explosion_{};  ///< the ball it reaches; none before the first
    std::optional<Goal> goal_;
    std::optional<std::array<float, 2>> pointer_;  ///< as the latest step was told
    Viewed viewed_;
    std::vector<std::string> messages_;
};

}  // namespace plumbline::game

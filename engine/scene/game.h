// What a game adds to a step and to a frame. The engine calls it; it knows no game.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/lines.h"
#include "engine/core/pose.h"
#include "engine/scene/simulation.h"
#include "engine/scene/simulation/simulation_archive.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

/// Where the frame is seen from, and where the flashlight is held.
struct ViewPoint {
    Pose world_from_camera{};
    Pose world_from_hand{};  ///< the flashlight's; looks down -Z
    Real fov_y_rad{radians_from_degrees(70.0_r)};
    Vec3 velocity_mps{0, 0, 0};
    bool has_player{false};
    Real blend{1};  ///< the frame's instant: this share of the way from the last step but one
};

/// Where a scene's camera stands, and how it is turned.
Pose camera_pose(const CameraDescription& camera);

/// A footstep or landing: effects turn it into sound.
struct FootstepEvent {
    Vec3 position_m{0, 0, 0};
    std::uint16_t surface{0};
    Real speed_mps{0};
};

enum class GoalEnd : std::uint8_t { Open, Won, Lost };

/// How a scene's [goal] stands.
struct GoalState {
    std::string text;
    int counted{0};
    int wanted{0};
    GoalEnd end{GoalEnd::Open};
    double passed_s{0};                   ///< on the goal's clock; at its end, once it ended
    std::optional<double> holds_for_s{};  ///< enough of them count, and must for so long yet
    std::optional<double> left_s{};       ///< absent: there is time without end
    std::optional<int> throws_left{};     ///< absent: as many as one likes
};

/// What the HUD says for the game; the app draws it.
struct HudContent {
    bool crosshair{true};
    float charge{0.0F};        ///< 0…1 while a throw is charged
    std::string chosen_thing;  ///< "barrel"; empty: nothing can be dropped
    std::string looking_at;    ///< what is in reach, for people: "oak crate, 30 kg"; or empty
    std::string use;           ///< what the use key would do: "open"; or empty
    std::optional<GoalState> goal{};
    std::optional<PlaqueReading> plaque{};  ///< that is looked at
    std::vector<std::string> messages;      ///< newest last; the app fades them
};

class Game {
public:
    virtual ~Game() = default;
    /// Before effects and physics: intent becomes forces, velocities and new entities.
    virtual void act(Simulation&, const Actions&) {}
    /// After physics and effects: goals, limits.
    virtual void judge(Simulation&) {}
    /// Between the last two steps; pending look is added so that the mouse turns the view at once.
    virtual ViewPoint view(const Simulation&,
                           Real blend,
                           float pending_yaw_rad,
                           float pending_pitch_rad) const = 0;
    virtual std::span<const FootstepEvent> footsteps() const { return {}; }
    /// Something is in the player's hand: a toggled grab that finds or keeps nothing is let go.
    virtual bool holds() const { return false; }
    /// The player wants to crouch: a toggled crouch goes on after a load.
    virtual bool crouches() const { return false; }
    /// The pointer stays the person's: the view follows it while a button is down.
    virtual bool frees_pointer() const { return false; }
    virtual HudContent hud(const Simulation&) { return {}; }
    /// In which the scene's goal was reached, on its clock; none: not yet, or there is none.
    virtual std::optional<double> won_in_s() const { return {}; }
    /// Outlines that belong to the HUD, of an instant between the last two steps.
    virtual void add_lines(const Simulation&, Real /*blend*/, LineList&) const {}

    /// Only a game of the same kind goes on from a saved one: "playground".
    virtual std::string_view kind() const { return "no game"; }
    /// The simulation's entities and all that the game decides by, for saved games. When read: the
    /// simulation is freshly built, and so is this.
    virtual void serialize(Archive& archive, Simulation& simulation) {
        serialize_entities(simulation, archive, {});
    }
};

/// No player, nobody acts: what `simulate` and `render` run.
class NoGame final : public Game {
public:
    explicit NoGame(const CameraDescription& camera);
    ViewPoint view(const Simulation&,
                   Real blend,
                   float pending_yaw_rad,
                   float pending_pitch_rad) const override;

private:
    ViewPoint view_;
};

}  // namespace plumbline::scene

// The small game that a scene's [goal] describes: what counts, the clock, how it ends. Judged once a
// step from the world's state and what was done in it, so that a replay ends the same way.
#pragma once

#include "engine/scene/game.h"
#include "engine/scene/simulation.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {
constexpr GoalEnd last_of(GoalEnd) {
    return GoalEnd::Lost;
}
}  // namespace plumbline::scene

namespace plumbline::game {

class Goal {
public:
    /// The simulation is freshly built from a scene with [goal].
    explicit Goal(const scene::Simulation& simulation);

    /// Something was taken, thrown or dropped: the clock runs from here.
    void begin(const scene::Simulation& simulation);
    /// Another thing may be thrown or dropped. Says why not, or nothing.
    std::optional<std::string> refusal() const;
    /// ... and was.
    void count_throw(const scene::Simulation& simulation);
    /// Hands must leave it alone.
    bool guards(ecs::Entity entity) const;

    /// After a step. What is in the hand does not count. A message for the person when it was won or lost in it.
    std::optional<std::string> judge(const scene::Simulation& simulation, ecs::Entity in_hand);
    /// On the clock; none: it is not won.
    std::optional<double> won_in_s() const;
    scene::GoalState state(const scene::Simulation& simulation) const;
    void serialize(Archive& archive) {
        archive(things_, wanted_, counted_, thrown_, start_s_, last_throw_s_);
        archive(reached_s_, end_, ended_s_);
    }

private:
    bool counts(const scene::Simulation& simulation, ecs::Entity thing) const;
    double passed_s(const scene::Simulation& simulation) const;
    std::string end(scene::GoalEnd how, double at_s);

    scene::GoalDescription goal_;
    std::vector<ecs::Entity> things_;
    int wanted_{0};
    int counted_{0};
    int thrown_{0};
    std::optional<double> start_s_{};
    double last_throw_s_{0};
    std::optional<double> reached_s_{};  ///< since when enough of them count
    scene::GoalEnd end_{scene::GoalEnd::Open};
    double ended_s_{0};  ///< on the clock
};

}  // namespace plumbline::game

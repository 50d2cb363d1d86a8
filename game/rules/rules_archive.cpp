// What the playground decides by, as fields of an archive.
#include "engine/scene/simulation/simulation_archive.h"
#include "game/rules/rules.h"

namespace plumbline::game {

constexpr MoveMode last_of(MoveMode) {
    return MoveMode::Orbit;
}

void PlaygroundGame::serialize(Archive& archive, scene::Simulation& simulation) {
    if (!archive.reads()) forget_gone(simulation);
    // The person's body first gives up its place: a thing may have had it.
    bool walks = player_.has_value();
    if (archive.reads()) player_.reset();
    serialize_entities(simulation, archive, [&](const std::string& kind, const std::string& name) {
        return things_.make_again(simulation, kind, name);
    });
    archive(walks, start_feet_m_);
    if (archive.failed()) return;
    if (archive.reads() && walks) player_.emplace(simulation, start_feet_m_);
    if (player_) archive(*player_);
    archive(step_s_, mode_, look_, fly_, orbit_, things_);
    archive.expect(step_s_ > 0 && step_s_ <= 1 && (player_ || mode_ != MoveMode::Walk),
                   "nobody is there who walks");
    if (archive.failed()) return;
    grab_.serialize(archive, simulation);
    archive(doors_, driver_, tying_);
    driver_.forget_gone(simulation);
    tying_.forget_gone(simulation);
    if (goal_) archive(*goal_);
    archive(fov_, dropping_, keys_, pointer_, viewed_.is_dragged);
}

}  // namespace plumbline::game

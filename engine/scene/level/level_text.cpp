#include "engine/scene/level/level_text.h"

#include "engine/core/text/toml_text.h"
#include "engine/scene/build/array_copies.h"
#include "engine/scene/build/fragments.h"
#include "engine/scene/level/shipped_things.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace plumbline::scene {
namespace {

// What moved less stays as it is described: things settle a little.
constexpr Real kMoved_m = 1e-3_r;
constexpr Real kTurned = 1e-6_r;  // 1 - |cos| of half the angle: 3 mrad

std::string numbers(const Vec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}
std::string numbers(const Quat& q) {
    return fmt::format("[{}, {}, {}, {}]", q.w, q.x, q.y, q.z);
}
std::string pose_lines(const Pose& pose) {
    return fmt::format(
        "position_m = {}\norientation = {}\n", numbers(pose.position), numbers(pose.orientation));
}

/// Where every entity with a body begins by the file, by name, in its order.
class Beginnings {
public:
    explicit Beginnings(const SceneDescription& scene) {
        for (const EntityDescription& entity : scene.entities) {
            if (entity.body) add(entity.name, entity.world_from_body);
        }
        for (const ArrayDescription& array : scene.arrays) {
            if (!array.prefab.body) continue;
            visit_copies(array, [this](const std::string& name, const Pose& pose) {
                add(name, pose);
                return true;
            });
        }
        for (const ChangeDescription& change : scene.changes) {
            Began& began = poses_[change.of];
            if (change.world_from_body) began.pose = *change.world_from_body;
            began.frozen = change.frozen.value_or(began.frozen);
        }
    }

    struct Began {
        Pose pose{};
        bool frozen{false};
    };
    const std::vector<std::string>& names() const { return names_; }
    const Began& of(const std::string& name) const { return poses_.at(name); }

private:
    void add(const std::string& name, const Pose& pose) {
        names_.push_back(name);
        poses_[name].pose = pose;
    }
    std::vector<std::string> names_;
    std::map<std::string, Began> poses_;
};

bool is_moved(const Pose& from, const Pose& to) {
    return glm::distance(from.position, to.position) > kMoved_m ||
           std::abs(glm::dot(from.orientation, to.orientation)) < 1 - kTurned;
}

struct LevelWriter {
    const Simulation& simulation;
    std::string things{};
    std::string changes{};
    std::set<std::string> foreign{};  ///< prefabs that the scene does not have
    std::set<std::string> names{};    ///< of things, each once

    physics::BodyState state_of(ecs::Entity entity) const {
        return simulation.physics.state(simulation.registry.get<BodyRef>(entity).body);
    }

    void add_change(const std::string& of, const std::string& lines) {
        changes += fmt::format("\n[[change]]\nof = {}\n{}", toml_text(of), lines);
    }

    void write_described() {
        const Beginnings beginnings(simulation.description());
        for (const std::string& name : beginnings.names()) {
            const ecs::Entity entity = simulation.find(name);
            const bool is_there = entity && simulation.registry.find<BodyRef>(entity) != nullptr;
            if (!is_there) {
                add_change(name, "gone = true\n");
                continue;
            }
            // Paths and parts of models go on by themselves.
            if (simulation.registry.find<MotionPath>(entity) != nullptr) continue;
            const physics::BodyState state = state_of(entity);
            const Beginnings::Began& began = beginnings.of(name);
            const bool moved = is_moved(began.pose, state.world_from_body);
            if (!moved && state.frozen == began.frozen) continue;
            add_change(
                name,
                (moved ? pose_lines(state.world_from_body) : "") +
                    (state.frozen == began.frozen ? ""
                                                  : fmt::format("frozen = {}\n", state.frozen)));
        }
    }

    /// "crate#3" becomes "crate-3": numbers after # are given in play.
    std::string name_of_thing(const std::string& name) {
        std::string own = name;
        std::ranges::replace(own, '#', '-');
        while (simulation.find(own) || !names.insert(own).second) own += "'";
        return own;
    }

    void write_made() {
        for (const MovingBody& moving : things_made_in_play(simulation)) {
            const std::string name =
                name_of_thing(simulation.registry.get<Name>(moving.entity).text);
            const std::string& prefab = simulation.registry.get<Spawned>(moving.entity).description;
            const physics::BodyState state = simulation.physics.state(moving.body);
            if (!simulation.description().prefabs.contains(prefab)) foreign.insert(prefab);
            things += fmt::format("\n[[entity]]\nname = {}\nprefab = {}\n{}",
                                  toml_text(name),
                                  toml_text(prefab),
                                  pose_lines(state.world_from_body));
            if (state.frozen) add_change(name, "frozen = true\n");
        }
    }

    std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        std::size_t tied = 0;
        for (const Rope& rope : simulation.ropes()) tied += rope.tied ? 1U : 0U;
        if (tied > 0) notes.emplace_back("ropes tied in play are left out");
        const bool broke = std::ranges::any_of(simulation.moving_bodies(), [&](const auto& moving) {
            const auto* fragile = simulation.registry.find<Fragile>(moving.entity);
            return fragile != nullptr &&
                   is_fragment(*simulation.wholes()[fragile->whole], *fragile);
        });
        if (broke) notes.emplace_back("fragments of what broke are left out");
        return notes;
    }
};

}  // namespace

LevelText level_text(const Simulation& simulation, std::string_view title, std::string_view base) {
    LevelWriter writer{simulation};
    writer.write_described();
    writer.write_made();
    const char* include = writer.foreign.empty() ? "" : "include = [\"things.toml\"]\n";
    return {.toml = fmt::format("# Made in play from {}.\n[scene]\ntitle = {}\nbase = {}\n{}{}{}",
                                base,
                                toml_text(title),
                                toml_text(base),
                                include,
                                writer.things,
                                writer.changes),
            .notes = writer.notes()};
}

}  // namespace plumbline::scene

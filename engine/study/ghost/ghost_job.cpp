#include "engine/core/files.h"
#include "engine/effects/advance.h"
#include "engine/scene/json_read.h"
#include "engine/scene/open_scene.h"
#include "engine/study/ghost/ghost_state.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

namespace plumbline::study {
namespace {

using nlohmann::json;

/// The ghost's world, stepped as the programs step theirs.
class GhostWorld {
public:
    explicit GhostWorld(const GhostStart& start) {
        const Result<DataFolders> folders = find_data_folders();
        if (!folders) throw std::runtime_error(folders.error().message);
        Diagnostics faults;
        const Result<scene::OpenedScene> opened = scene::open_scene(
            start.scene, {.folders = *folders, .overrides = overrides(start.setting)}, faults);
        if (!opened) throw std::runtime_error(opened.error().message);
        auto built = opened->build(library_);
        if (!built) throw std::runtime_error(built.error().message);
        simulation_ = std::move(*built);
        simulation_->set_time(start.time_s);
        place_bodies(start.bodies);
        game_.emplace(simulation_->description().camera);
        effects_.emplace(*simulation_, effects::ServedDomains{.picture = false, .sound = false});
    }

    GhostState go_on(double seconds) {
        const auto steps = std::max(1L, std::lround(seconds / simulation_->step_s()));
        GhostState state;
        for (long i = 0; i < steps; ++i) {
            effects::advance(*simulation_, *effects_, *game_, {});
            state.cpu_ms += simulation_->physics.cost().total_ms;
        }
        state.time_s = simulation_->time_s();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (bodies_[i] && simulation_->physics.contains(*bodies_[i])) {
                const Pose pose = simulation_->physics.state(*bodies_[i]).world_from_body;
                last_[i] = {.position_m = Vec3d(pose.position),
                            .orientation = Quatd(pose.orientation)};
            }
            state.bodies.push_back(last_[i]);
        }
        return state;
    }

private:
    void place_bodies(const std::vector<GhostBody>& bodies) {
        std::vector<ecs::Entity> kept;
        for (const GhostBody& body : bodies) {
            last_.push_back(body);
            last_.back().name.clear();
            const ecs::Entity entity = simulation_->find(body.name);
            if (!simulation_->registry.alive(entity) ||
                !simulation_->registry.has<scene::BodyRef>(entity)) {
                bodies_.emplace_back();
                continue;
            }
            kept.push_back(entity);
            const physics::BodyId id = simulation_->registry.get<scene::BodyRef>(entity).body;
            bodies_.emplace_back(id);
            simulation_->physics.set_pose(id, {Vec3(body.position_m), Quat(body.orientation)});
            simulation_->physics.set_velocity(
                id, Vec3(body.velocity_mps), Vec3(body.angular_velocity_radps));
        }
        for (const scene::MovingBody& moving : simulation_->moving_bodies()) {
            if (std::ranges::find(kept, moving.entity) == kept.end())
                simulation_->registry.mark_for_destruction(moving.entity);
        }
        simulation_->destroy_marked();
    }

    assets::AssetLibrary library_;
    std::unique_ptr<scene::Simulation> simulation_;
    std::optional<scene::NoGame> game_;
    std::optional<effects::EffectRuntime> effects_;
    std::vector<std::optional<physics::BodyId>> bodies_;
    std::vector<GhostBody> last_;
};

void write(json& list, const Vec3d& v) {
    for (int i = 0; i < 3; ++i) list.push_back(v[i]);
}
void write(json& list, const Quatd& q) {
    for (const double part : {q.w, q.x, q.y, q.z}) list.push_back(part);
}
Vec3d read_vector(const json& list, std::size_t at) {
    return {
        list.at(at).get<double>(), list.at(at + 1).get<double>(), list.at(at + 2).get<double>()};
}
Quatd read_turn(const json& list, std::size_t at) {
    return {list.at(at).get<double>(),
            list.at(at + 1).get<double>(),
            list.at(at + 2).get<double>(),
            list.at(at + 3).get<double>()};
}

json setting_json(const Setting& setting) {
    return {{"solver", physics::solver_name(setting.solver)},
            {"step_hz", setting.step_hz},
            {"substeps", setting.substeps},
            {"substeps_max", setting.substeps_max},
            {"iterations", setting.iterations}};
}

GhostStart parse_start(const json& from) {
    const json& setting = from.at("setting");
    const auto solver = physics::solver_from_name(setting.at("solver").get<std::string>());
    if (!solver) throw std::runtime_error("no such solver");
    GhostStart start{.scene = from.at("scene").get<std::string>(),
                     .setting = {.solver = *solver,
                                 .step_hz = setting.at("step_hz").get<int>(),
                                 .substeps = setting.at("substeps").get<int>(),
                                 .substeps_max = setting.at("substeps_max").get<int>(),
                                 .iterations = setting.at("iterations").get<int>()},
                     .time_s = from.at("time_s").get<double>()};
    for (const json& body : from.at("bodies")) {
        const json& numbers = body.at("state");
        start.bodies.push_back({.name = body.at("name").get<std::string>(),
                                .position_m = read_vector(numbers, 0),
                                .orientation = read_turn(numbers, 3),
                                .velocity_mps = read_vector(numbers, 7),
                                .angular_velocity_radps = read_vector(numbers, 10)});
    }
    return start;
}

std::string state_body(const GhostState& state) {
    json poses = json::array();
    for (const GhostBody& body : state.bodies) {
        write(poses, body.position_m);
        write(poses, body.orientation);
    }
    return json{{"time_s", state.time_s}, {"cpu_ms", state.cpu_ms}, {"poses", std::move(poses)}}
        .dump();
}

}  // namespace

std::string start_body(const GhostStart& start) {
    json bodies = json::array();
    for (const GhostBody& body : start.bodies) {
        json numbers = json::array();
        write(numbers, body.position_m);
        write(numbers, body.orientation);
        write(numbers, body.velocity_mps);
        write(numbers, body.angular_velocity_radps);
        bodies.push_back({{"name", body.name}, {"state", std::move(numbers)}});
    }
    return json{{"start",
                 {{"scene", start.scene.string()},
                  {"setting", setting_json(start.setting)},
                  {"time_s", start.time_s},
                  {"bodies", std::move(bodies)}}}}
        .dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string go_on_body(double seconds) {
    return json{{"go_on_s", seconds}}.dump();
}

Result<GhostState> parse_ghost_state(const std::string& body) {
    constexpr std::size_t kNumbers = 7;
    try {
        const json from = scene::read_json<json>(body);
        GhostState state{.time_s = from.at("time_s").get<double>(),
                         .cpu_ms = from.at("cpu_ms").get<double>()};
        const json& poses = from.at("poses");
        for (std::size_t at = 0; at + kNumbers <= poses.size(); at += kNumbers) {
            state.bodies.push_back(
                {.position_m = read_vector(poses, at), .orientation = read_turn(poses, at + 3)});
        }
        return state;
    } catch (const std::exception&) {
        return Error{.message = "the ghost's process answered with something that is no state"};
    }
}

RunJob ghost_jobs() {
    return [world = std::make_shared<std::optional<GhostWorld>>()](const std::string& body) {
        const json asked = scene::read_json<json>(body);
        if (asked.contains("start")) {
            world->reset();
            const GhostStart start = parse_start(asked.at("start"));
            world->emplace(start);
            return state_body({.time_s = start.time_s, .bodies = start.bodies});
        }
        if (!*world) throw std::runtime_error("a ghost goes on only after it was started");
        return state_body((*world)->go_on(asked.at("go_on_s").get<double>()));
    };
}

}  // namespace plumbline::study

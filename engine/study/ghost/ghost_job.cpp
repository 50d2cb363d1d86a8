#include "engine/scene/formats/json_read.h"
#include "engine/scene/simulation/simulation_archive.h"
#include "engine/study/ghost/ghost_state.h"
#include "engine/study/played_scene.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace plumbline::study {
namespace {

using nlohmann::json;

/// The ghost's world, stepped as the programs step theirs.
class GhostWorld {
public:
    explicit GhostWorld(const GhostStart& start) {
        const Result<scene::OpenedScene> opened =
            open_for_study(start.scene, overrides(start.setting));
        if (!opened) throw std::runtime_error(opened.error().message);
        Result<PlayedScene> scene = PlayedScene::create(*opened, library_);
        if (!scene) throw std::runtime_error(scene.error().message);
        scene_.emplace(std::move(*scene));
        take_up(start.state);
        scene_->simulation().set_time(start.time_s);
        find_bodies(start.bodies);
        scene_->start();
    }

    GhostState go_on(double seconds) {
        const scene::Simulation& simulation = scene_->simulation();
        const auto steps = std::max(1L, std::lround(seconds / simulation.step_s()));
        GhostState state;
        for (long i = 0; i < steps; ++i) {
            scene_->step();
            state.cpu_ms += simulation.physics.report().cost.total_ms;
        }
        state.time_s = simulation.time_s();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (bodies_[i] && simulation.physics.contains(*bodies_[i])) {
                const Pose pose = simulation.physics.state(*bodies_[i]).world_from_body;
                last_[i] = {.position_m = Vec3d(pose.position),
                            .orientation = Quatd(pose.orientation)};
            }
            state.bodies.push_back(last_[i]);
        }
        return state;
    }

private:
    /// What the visible world carries goes on at the ghost's own accuracy.
    void take_up(const std::string& state) {
        scene::Simulation& simulation = scene_->simulation();
        physics::WorldDef own = simulation.physics.def();
        Archive archive(state);
        serialize_bodies_of_scene(simulation, archive);
        if (archive.failed()) throw std::runtime_error("its state: " + archive.fault());
        own.gravity_mps2 = simulation.physics.def().gravity_mps2;
        simulation.set_accuracy(own);
    }

    void find_bodies(const std::vector<GhostBody>& bodies) {
        for (const GhostBody& body : bodies) {
            last_.push_back(body);
            last_.back().name.clear();
            const ecs::Entity entity = scene_->simulation().find(body.name);
            const auto* ref = scene_->simulation().registry.find<scene::BodyRef>(entity);
            bodies_.push_back(ref != nullptr ? std::optional(ref->body) : std::nullopt);
        }
    }

    assets::AssetLibrary library_;
    std::optional<PlayedScene> scene_;
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

/// JSON holds text only.
std::string hex_of_bytes(std::string_view bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string hex;
    hex.reserve(2 * bytes.size());
    for (const char byte : bytes) {
        hex += kDigits[static_cast<std::uint8_t>(byte) >> 4U];
        hex += kDigits[static_cast<std::uint8_t>(byte) & 15U];
    }
    return hex;
}
std::string bytes_of_hex(std::string_view hex) {
    std::string bytes;
    for (; hex.size() >= 2; hex.remove_prefix(2)) {
        unsigned value = 0;
        if (std::from_chars(hex.data(), hex.data() + 2, value, 16).ptr != hex.data() + 2)
            throw std::runtime_error("its state is no hexadecimal number");
        bytes += static_cast<char>(value);
    }
    return bytes;
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
                     .time_s = from.at("time_s").get<double>(),
                     .state = bytes_of_hex(from.at("world").get<std::string>())};
    for (const json& body : from.at("bodies")) {
        const json& numbers = body.at("state");
        start.bodies.push_back({.name = body.at("name").get<std::string>(),
                                .position_m = read_vector(numbers, 0),
                                .orientation = read_turn(numbers, 3)});
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
        bodies.push_back({{"name", body.name}, {"state", std::move(numbers)}});
    }
    return json{{"start",
                 {{"scene", start.scene.string()},
                  {"setting", setting_json(start.setting)},
                  {"time_s", start.time_s},
                  {"bodies", std::move(bodies)},
                  {"world", hex_of_bytes(start.state)}}}}
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

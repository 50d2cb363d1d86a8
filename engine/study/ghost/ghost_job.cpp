#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/ghost/ghost_state.h"
#include "engine/study/played_scene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace plumbline::study {
namespace {

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
        if (const Result<Done> taken = take_up(start.from, *scene_); !taken)
            throw std::runtime_error(taken.error().message);
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

}  // namespace

void fields(const auto& field, Like<GhostBody> auto& body) {
    field("name", body.name);
    field("position_m", body.position_m);
    field("orientation", body.orientation);
}

/// All but the state, which is no text.
void fields(const auto& field, Like<GhostStart> auto& start) {
    field("scene", start.scene);
    field("setting", start.setting);
    field("time_s", start.from.time_s);
    field("bodies", start.bodies);
}

void fields(const auto& field, Like<GhostState> auto& state) {
    field("time_s", state.time_s);
    field("bodies", state.bodies);
    field("cpu_ms", state.cpu_ms);
}

std::string start_body(const GhostStart& start) {
    Json body{{"start", start}};
    body["start"]["world"] = hex_of_bytes(start.from.state);
    return text_of(body);
}

std::string go_on_body(double seconds) {
    return text_of(Json{{"go_on_s", seconds}});
}

Result<GhostState> parse_ghost_state(const std::string& body) {
    Result<GhostState> state = read_text<GhostState>(body, "no state");
    if (!state)
        return Error{.message = "the ghost's process answered with something that is no state"};
    return state;
}

RunJob ghost_jobs() {
    return [world = std::make_shared<std::optional<GhostWorld>>()](
               const std::string& body) -> Result<std::string> {
        const Json asked = scene::read_json<Json>(body);
        if (asked.contains("start")) {
            world->reset();
            auto start = asked.at("start").get<GhostStart>();
            start.from.state = bytes_of_hex(asked.at("start").at("world").get<std::string>());
            world->emplace(start);
            return text_of(Json(GhostState{.time_s = start.from.time_s, .bodies = start.bodies}));
        }
        if (!*world) throw std::runtime_error("a ghost goes on only after it was started");
        return text_of(Json((*world)->go_on(asked.at("go_on_s").get<double>())));
    };
}

}  // namespace plumbline::study

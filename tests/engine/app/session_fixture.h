// A session of a small scene in a folder of its own.
#pragma once

#include "engine/app/session.h"
#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

namespace plumbline::app {

/// Holds a body while it is there, as a hand would.
class HoldingGame final : public scene::Game {
public:
    explicit HoldingGame(scene::Simulation& simulation, std::string name)
        : game_(simulation.description().camera), held_(std::move(name)) {}
    void act(scene::Simulation& simulation, const Actions& actions) override {
        if (actions.presses(Action::Grab) > 0)
            holds_ = simulation.registry.alive(simulation.find(held_));
    }
    bool holds() const override { return holds_; }
    scene::ViewPoint view(const scene::Simulation& simulation,
                          Real blend,
                          float pending_yaw_rad,
                          float pending_pitch_rad) const override {
        return game_.view(simulation, blend, pending_yaw_rad, pending_pitch_rad);
    }

private:
    scene::NoGame game_;
    std::string held_;
    bool holds_{false};
};

/// An [[entity]] of a scene: a cube that falls.
inline std::string cube_text(std::string_view name, std::string_view position_m) {
    return fmt::format(
        "[[entity]]\nname = \"{}\"\nposition_m = [{}]\n"
        "primitive = {{ box = [1, 1, 1] }}\n[entity.body]\nkind = \"dynamic\"\n",
        name,
        position_m);
}

inline const std::string kTwoCubes =
    "[scene]\ntitle = \"two cubes\"\n" + cube_text("one", "0, 5, 0") + cube_text("two", "3, 9, 0");

class SessionTest : public testing::Test {
protected:
    SessionTest() {
        folder_.write("config/surfaces.toml", "[wood]\nfriction = 0.5\n");
        folder_.write("scene.toml", kTwoCubes);
    }
    std::unique_ptr<Session> open(std::optional<double> hour = {}) {
        Result<std::unique_ptr<Session>> session = Session::open(
            {.scene = folder_.path() / "scene.toml",
             .folders = {.assets = folder_.path() / "assets",
                         .shaders = {},
                         .config = folder_.path() / "config"},
             .hour = hour,
             .make_game = [](scene::Simulation& simulation) -> std::unique_ptr<scene::Game> {
                 return std::make_unique<HoldingGame>(simulation, "two");
             }});
        EXPECT_TRUE(session.ok()) << (session.ok() ? "" : session.error().message);
        return session ? std::move(*session) : nullptr;
    }

    test::TemporaryFolder folder_;
    test::ScopedVariable cache_{"XDG_CACHE_HOME", (folder_ / "cache").string()};
};

}  // namespace plumbline::app

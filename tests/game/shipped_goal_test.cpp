// SOURCES B36: the small game that ships can be won, and is lost by who does nothing useful.
#include "engine/effects/advance.h"
#include "engine/scene/open_scene.h"
#include "game/rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace plumbline::game {
namespace {

using scene::GoalEnd;

/// The scene as `play` runs it, and a person who throws well.
class Cans : public testing::Test {
protected:
    void SetUp() override {
        const std::filesystem::path assets = std::filesystem::path(PL_SOURCE_DIR) / "assets";
        Diagnostics faults;
        const auto opened = scene::open_scene(
            assets / "scenes/cans.toml",
            {.folders = {.assets = assets,
                         .config = std::filesystem::path(PL_SOURCE_DIR) / "config"}},
            faults);
        ASSERT_TRUE(opened.ok()) << opened.error().message;
        auto built = opened->build(library_);
        ASSERT_TRUE(built.ok()) << built.error().message;
        simulation_ = std::move(*built);
        game_ = std::make_unique<PlaygroundGame>(*simulation_, assets);
        effects_ = std::make_unique<effects::EffectRuntime>(*simulation_, effects::ServedDomains{});
        run(1);
    }

    void run(double seconds, const Actions& actions = {}) {
        for (int i = 0; i < static_cast<int>(seconds * 60 + 0.5); ++i)
            effects::advance(*simulation_, *effects_, *game_, actions);
    }
    scene::GoalState state() const { return game_->goal()->state(*simulation_); }
    Vec3 place(const std::string& name) const {
        return simulation_->registry.get<scene::Placement>(simulation_->find(name))
            .world_from_body.position;
    }
    /// As hard as it goes, after a second of charging: a little high, for what gravity takes, and
    /// ahead of what moves.
    void throw_at(const std::string& name) {
        constexpr Real kSpeed_mps = 25;
        Actions turn;
        const Vec3 before = place(name);
        run(0.1);
        const Vec3 velocity = (place(name) - before) / 0.1_r;
        const auto view = game_->view(*simulation_, 1, 0, 0);
        const Vec3 eye = view.world_from_camera.position;
        const Real flight_s = glm::distance(place(name), eye) / kSpeed_mps;
        const Vec3 target = place(name) + velocity * (flight_s + 1.15_r) +
                            Vec3{0, 9.81_r / 2 * flight_s * flight_s, 0};
        const Vec3 way = glm::normalize(target - eye);
        const Vec3 forward = view.world_from_camera.orientation * Vec3{0, 0, -1};
        turn.look_yaw_rad = std::atan2(-way.x, -way.z) - std::atan2(-forward.x, -forward.z);
        turn.look_pitch_rad = std::asin(way.y) - std::asin(forward.y);
        run(1.0 / 60, turn);
        Actions held;
        held.held.set(index_of(Action::Throw));
        held.pressed[index_of(Action::Throw)] = 1;
        run(1.0 / 60, held);
        held.pressed = {};
        run(1.1, held);
        run(1.2);
    }
    bool stands(const std::string& name) const { return place(name).y > 0.6_r; }

    assets::AssetLibrary library_;
    std::unique_ptr<scene::Simulation> simulation_;
    std::unique_ptr<PlaygroundGame> game_;
    std::unique_ptr<effects::EffectRuntime> effects_;
};

TEST_F(Cans, StandAndRideUntilSomebodyThrows) {
    run(20);
    EXPECT_EQ(state().counted, 0) << "none falls by itself";
    EXPECT_EQ(state().wanted, 10);
    EXPECT_EQ(state().left_s, 60.0);
}

TEST_F(Cans, CanBeWon) {
    const std::vector<std::string> tins{"tin.low.1.0.0",
                                        "tin.low.0.0.0",
                                        "tin.low.2.0.0",
                                        "tin.middle_1",
                                        "tin.middle_2",
                                        "tin.top",
                                        "tin.on_barrel_1",
                                        "tin.on_barrel_2",
                                        "tin.riding_1",
                                        "tin.riding_2"};
    while (state().end == GoalEnd::Open && *state().throws_left > 0) {
        const auto next =
            std::ranges::find_if(tins, [&](const std::string& name) { return stands(name); });
        if (next == tins.end()) break;
        throw_at(*next);
    }
    run(2);
    EXPECT_EQ(state().end, GoalEnd::Won) << state().counted << " of 10, " << *state().throws_left
                                         << " balls left after " << state().passed_s << " s";
    EXPECT_LT(state().passed_s, 60);
}

TEST_F(Cans, AreLostByThrowingPast) {
    Actions away;
    away.look_yaw_rad = 2.0F;
    run(1.0 / 60, away);
    for (int i = 0; i < 12; ++i) {
        Actions tap;
        tap.pressed[index_of(Action::Throw)] = 1;
        run(1.0 / 60, tap);
        run(0.5);
    }
    run(6.5);
    EXPECT_EQ(state().end, GoalEnd::Lost);
}

}  // namespace
}  // namespace plumbline::game

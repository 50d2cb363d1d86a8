// SOURCES B36: the small games that ship can be won, and are lost by who does nothing useful.
#include "engine/effects/advance.h"
#include "engine/scene/open_scene.h"
#include "game/rules/rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::game {
namespace {

using scene::GoalEnd;

/// A scene as `play` runs it, and a person who throws well.
class ShippedGoal : public testing::Test {
protected:
    /// `feet_m`: where the person has walked to, if not where the scene begins.
    void open(const char* scene, const std::optional<Vec3>& feet_m = {}) {
        const std::filesystem::path assets = std::filesystem::path(PL_SOURCE_DIR) / "assets";
        Diagnostics faults;
        auto opened = scene::open_scene(
            assets / "scenes" / scene,
            {.folders = {.assets = assets,
                         .config = std::filesystem::path(PL_SOURCE_DIR) / "config"}},
            faults);
        ASSERT_TRUE(opened.ok()) << opened.error().message;
        if (feet_m) opened->description.player->feet_position_m = *feet_m;
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
        return simulation_->registry.get<scene::Transform>(simulation_->find(name))
            .world_from_body.position;
    }
    /// What a thing that rides does by its carrier's path in a time from now.
    Vec3 ridden(const std::string& carrier, Real duration_s) const {
        const auto& path = simulation_->registry.get<scene::MotionPath>(simulation_->find(carrier));
        const double now_s = simulation_->time_s();
        return scene::pose_on_path(path, now_s + static_cast<double>(duration_s)).position -
               scene::pose_on_path(path, now_s).position;
    }
    /// As hard as it goes, after a second of charging: a little high, for what gravity takes, and
    /// ahead of what moves.
    void throw_at(const std::string& name) {
        constexpr Real kSpeed_mps = 25;
        constexpr Real kCharging_s = 1.15_r;
        Actions turn;
        const auto view = game_->view(*simulation_, 1, 0, 0);
        const Vec3 eye = view.world_from_camera.position;
        const Real flight_s = glm::distance(place(name), eye) / kSpeed_mps;
        Vec3 target = place(name) + Vec3{0, 9.81_r / 2 * flight_s * flight_s, 0};
        if (name.starts_with("tin.riding")) target += ridden("tray", kCharging_s + flight_s);
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
    /// Throws at one thing after the other that does not count yet, until it is decided.
    void throw_at_all(const std::vector<std::string>& things) {
        const Real below_m = *simulation_->description().goal->below_m;
        while (state().end == GoalEnd::Open && *state().throws_left > 0) {
            const auto next = std::ranges::find_if(
                things, [&](const std::string& name) { return place(name).y > below_m; });
            if (next == things.end()) break;
            throw_at(*next);
        }
        run(2);
    }

    assets::AssetLibrary library_;
    std::unique_ptr<scene::Simulation> simulation_;
    std::unique_ptr<PlaygroundGame> game_;
    std::unique_ptr<effects::EffectRuntime> effects_;
};

class Cans : public ShippedGoal {
protected:
    void SetUp() override { open("cans.toml"); }
};

TEST_F(Cans, StandAndRideUntilSomebodyThrows) {
    run(20);
    EXPECT_EQ(state().counted, 0) << "none falls by itself";
    EXPECT_EQ(state().wanted, 10);
    EXPECT_EQ(state().left_s, 60.0);
}

TEST_F(Cans, CanBeWon) {
    throw_at_all({"tin.low.1.0.0",
                  "tin.low.0.0.0",
                  "tin.low.2.0.0",
                  "tin.middle_1",
                  "tin.middle_2",
                  "tin.top",
                  "tin.on_barrel_1",
                  "tin.on_barrel_2",
                  "tin.riding_1",
                  "tin.riding_2"});
    EXPECT_EQ(state().counted, 10)
        << *state().throws_left << " balls left after " << state().passed_s << " s";
    EXPECT_EQ(state().end, GoalEnd::Won);
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

/// At the counter of the fairground's shooting gallery.
class Gallery : public ShippedGoal {
protected:
    void SetUp() override { open("fairground.toml", Vec3{6.3_r, 0.03_r, 1.2_r}); }
};

TEST_F(Gallery, StandsUntilSomebodyThrows) {
    run(20);
    EXPECT_EQ(state().counted, 0) << "none falls by itself";
    EXPECT_EQ(state().wanted, 9);
    EXPECT_EQ(state().left_s, 60.0);
}

TEST_F(Gallery, CanBeWon) {
    throw_at_all({"target.1",
                  "target.2",
                  "target.3",
                  "target.4",
                  "target.5",
                  "tin.1",
                  "tin.2",
                  "tin.3",
                  "tin.6",
                  "tin.4",
                  "tin.5"});
    EXPECT_EQ(state().end, GoalEnd::Won) << state().counted << " of 9, " << *state().throws_left
                                         << " balls left after " << state().passed_s << " s";
    EXPECT_LT(state().passed_s, 60);
    for (int i = 1; i <= 5; ++i)
        EXPECT_LT(place("target." + std::to_string(i)).y, 1.05_r) << "a target stays down";
}

class Tower : public ShippedGoal {
protected:
    void SetUp() override { open("games/tower.toml"); }
    void put(const std::string& name, const Vec3& place_m) {
        const auto& body = simulation_->registry.get<scene::BodyRef>(simulation_->find(name));
        simulation_->physics.set_pose(body.body, {.position = place_m});
        simulation_->physics.set_velocity(body.body, {0, 0, 0}, {0, 0, 0});
    }
};

TEST_F(Tower, NothingCountsUntilSomethingIsBuilt) {
    run(10);
    EXPECT_EQ(state().counted, 0);
    EXPECT_EQ(state().left_s, 180.0);
}

TEST_F(Tower, FiveBlocksStandInTheWindAndWin) {
    const std::array<const char*, 5> blocks{"block.left.0.0.0",
                                            "block.left.0.0.1",
                                            "block.left.0.0.2",
                                            "block.right.0.0.0",
                                            "block.right.0.0.1"};
    for (std::size_t i = 0; i < blocks.size(); ++i)
        put(blocks[i], {0, 0.04_r + 0.25_r + 0.5_r * static_cast<Real>(i), 0});
    run(4);
    EXPECT_EQ(state().counted, 1);
    EXPECT_EQ(state().end, GoalEnd::Open) << "it must stand for 5 s";
    run(2);
    EXPECT_EQ(state().end, GoalEnd::Won);
}

TEST_F(Tower, FourAreNotEnough) {
    for (int i = 0; i < 3; ++i)
        put("block.left.0.0." + std::to_string(i), {0, 0.29_r + 0.5_r * static_cast<Real>(i), 0});
    put("block.right.0.0.0", {0, 1.79_r, 0});
    run(8);
    EXPECT_EQ(state().counted, 0);
}

class Ferry : public ShippedGoal {
protected:
    void SetUp() override { open("games/ferry.toml"); }
    /// Off from one bank, and drawn in from the other, to which somebody walks in a quarter of a minute.
    void bring_over() {
        push_raft({0, 0, -80}, 3);
        run(15);
        push_raft({0, 0, -40}, 6);
        run(3);
    }
    void push_raft(const Vec3& force_N, double seconds) {
        const auto& body = simulation_->registry.get<scene::BodyRef>(simulation_->find("raft"));
        for (int i = 0; i < static_cast<int>(seconds * 60); ++i) {
            simulation_->physics.apply_force(body.body, force_N);
            run(1.0 / 60);
        }
    }
};

TEST_F(Ferry, TheChestsStayDryWhileNobodyPushes) {
    run(60);
    EXPECT_EQ(state().counted, 0);
    EXPECT_GT(place("raft").z, 2) << "the wind blows from the far bank";
    for (int i = 0; i < 3; ++i) EXPECT_GT(place("chest." + std::to_string(i) + ".0.0").y, 0.2);
}

TEST_F(Ferry, ARaftThatIsPushedWins) {
    bring_over();
    EXPECT_EQ(state().counted, 3) << place("raft").z << ' ' << place("chest.0.0.0").y;
    EXPECT_EQ(state().end, GoalEnd::Won);
}

TEST_F(Ferry, AChestInTheWaterIsLost) {
    const auto& body = simulation_->registry.get<scene::BodyRef>(simulation_->find("chest.0.0.0"));
    simulation_->physics.set_pose(body.body, {.position = {-3, 0, -3}});
    bring_over();
    EXPECT_LT(state().counted, 3);
    EXPECT_EQ(state().end, GoalEnd::Open);
}

}  // namespace
}  // namespace plumbline::game

// The garden as one hears it: its effects through a mixer that renders, judged by level, spectrum and
// decay.
#include "engine/audio/mixer.h"
#include "engine/effects/sound/room_probe.h"
#include "tests/scenarios/scene_run.h"
#include "tests/support/sound_measures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace plumbline {
namespace {

using test::rms_of;
using test::share_above;

constexpr int kRate_hz = audio::Mixer::kOfflineRate_hz;
const Vec3 kInTheOpen{0, 1.6_r, 11};
const Vec3 kInTheHouse{-1.6_r, 1.7_r, -5.2_r};

class GardenHeard : public testing::Test {
protected:
    test::SceneRun run_{"garden.toml", {}, {.frame = false, .sound = true}};
    audio::Mixer mixer_{{.offline = true}, run_.library};
    double now_s_{1.0};

    void SetUp() override { ASSERT_TRUE(run_.simulation); }

    scene::Simulation& simulation() { return *run_.simulation; }
    std::uint64_t mark_of(const std::string& name) {
        return scene::mark_of(simulation().find(name));
    }

    using Choose = std::function<void(effects::SoundFrame&)>;
    /// Of loops only the one of an entity, and no cues.
    Choose only(const std::string& name) {
        return [mark = mark_of(name)](effects::SoundFrame& sound) {
            std::erase_if(sound.loops, [&](const audio::LoopCue& loop) {
                return loop.made_by[0] != mark && loop.made_by[1] != mark;
            });
            sound.cues.clear();
        };
    }

    /// Both sides' mean at an ear that looks down -Z, a step of the world to each 735 samples.
    std::vector<double> listen(double seconds, const Vec3& ear, const Choose& choose) {
        std::vector<double> heard;
        scene::ViewPoint view;
        view.world_from_camera.position = ear;
        while (static_cast<double>(heard.size()) < seconds * kRate_hz) {
            run_.step(1);
            effects::SoundFrame sound = run_.effects->sound(simulation(), view);
            choose(sound);
            mixer_.play(sound.cues,
                        sound.loops,
                        {.position_world = Vec3f(ear), .room = sound.room},
                        now_s_);
            now_s_ += 1.0 / 60.0;
            std::vector<float> samples(2 * 735);
            mixer_.render(samples);
            for (std::size_t i = 0; i < samples.size(); i += 2)
                heard.push_back(static_cast<double>(samples[i] + samples[i + 1]) / 2);
        }
        return heard;
    }
};

// 8 m from the fountain each: on the path, and in the living room behind the closed door.
TEST_F(GardenHeard, TheFountainIsDullBehindTheWallsOfTheHouse) {
    listen(1, kInTheOpen, only("fountain"));
    const std::vector<double> open = listen(2, kInTheOpen, only("fountain"));
    listen(2, kInTheHouse, only("fountain"));
    const std::vector<double> inside = listen(2, kInTheHouse, only("fountain"));
    EXPECT_GT(rms_of(open), 1e-3);
    EXPECT_LT(rms_of(inside), 0.25 * rms_of(open));
    EXPECT_GT(rms_of(inside), 0.0);
    EXPECT_LT(share_above(inside, kRate_hz, 2'000), 0.5 * share_above(open, kRate_hz, 2'000));
}

/// One clap at a place.
audio::SoundCue clap_at(const Vec3& place, assets::AssetLibrary& library) {
    audio::SoundCue cue;
    const std::filesystem::path file = test::repository() / "assets/sounds/impact_plank_0.ogg";
    cue.sound = *library.sound(file);
    cue.position_world = Vec3f(place);
    return cue;
}

TEST_F(GardenHeard, TheLivingRoomReverberatesAndTheLawnDoesNot) {
    effects::RoomProbe probe;
    probe.cast(simulation(), kInTheHouse, effects::RoomProbe::kDirections);
    const effects::RoomEstimate estimate = probe.estimate(kInTheHouse);
    EXPECT_GT(estimate.volume_m3, 15.0F);
    EXPECT_LT(estimate.volume_m3, 120.0F);
    EXPECT_LT(estimate.openness, 0.1F);
    const auto expected_s = static_cast<double>(effects::room_of(estimate).decay_s);

    const Choose nothing = [](effects::SoundFrame& sound) {
        sound.loops.clear();
        sound.cues.clear();
    };
    bool is_first = true;
    const auto clap = [&](const Vec3& ear) -> Choose {
        is_first = true;
        return [&, ear](effects::SoundFrame& sound) {
            nothing(sound);
            if (std::exchange(is_first, false))
                sound.cues.push_back(clap_at(ear + Vec3{0, 0, -1}, run_.library));
        };
    };
    listen(3, kInTheHouse, nothing);
    const std::vector<double> inside = listen(3, kInTheHouse, clap(kInTheHouse));
    listen(4, kInTheOpen, nothing);
    const std::vector<double> outside = listen(3, kInTheOpen, clap(kInTheOpen));
    // What comes straight is over after 0.35 s, its own length.
    const auto tail = [](const std::vector<double>& heard) {
        return std::vector<double>(heard.begin() + 35 * kRate_hz / 100, heard.end());
    };
    EXPECT_GT(rms_of(tail(inside)), 30.0 * rms_of(tail(outside)));
    EXPECT_NEAR(test::decay_60dB_s(tail(inside), kRate_hz) / expected_s, 1.0, 0.25) << expected_s;
}

TEST_F(GardenHeard, TheGateCreaksWhileItTurns) {
    const Vec3 ear{-0.6_r, 1.6_r, 15.5_r};
    run_.step(60 * 4);
    EXPECT_LT(rms_of(listen(1, ear, only("gate_left"))), 1e-6);
    const ecs::Entity gate = simulation().find("gate_left");
    const physics::BodyId body = simulation().registry.get<scene::BodyRef>(gate).body;
    simulation().physics.apply_impulse(
        body, {0, 0, -8}, run_.state("gate_left").world_from_body.position + Vec3{0.8_r, 0.5_r, 0});
    EXPECT_GT(rms_of(listen(1, ear, only("gate_left"))), 1e-3);
    listen(5, ear, only("gate_left"));
    EXPECT_LT(rms_of(listen(1, ear, only("gate_left"))), 1e-6) << "it rests again";
}

TEST_F(GardenHeard, ADryFountainIsSilent) {
    listen(1, kInTheOpen, only("fountain"));
    EXPECT_GT(rms_of(listen(1, kInTheOpen, only("fountain"))), 1e-3);
    simulation().switches.turn("fountain", false);
    listen(1, kInTheOpen, only("fountain"));
    EXPECT_EQ(rms_of(listen(1, kInTheOpen, only("fountain"))), 0.0);
}

}  // namespace
}  // namespace plumbline

// What recordings keep of a request, and what they may say.
#include "engine/app/world_request.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::app {
namespace {

const std::vector<WorldRequest> kOneOfEach{
    StartAgain{},
    SwitchEffect{"lamps", false},
    SwitchEffect{"fog", std::nullopt},
    SetFog{.density_scale = 1.25F, .color = 3},
    SetLight{.scale = 0.64F},
    SetHour{.hour = 21.75},
    SetAccuracy{{.solver = physics::Solver::BulletSi, .step_hz = 120, .substeps = 1}},
    SetAnimation{.time_s = 0.1, .paused = true, .next = true}};

std::string bytes_of(WorldRequest request) {
    Archive archive;
    archive(request);
    return archive.take();
}

TEST(WorldRequestTest, EachKindIsReadAsItWasWritten) {
    for (const WorldRequest& request : kOneOfEach) {
        const std::string bytes = bytes_of(request);
        Archive archive(bytes);
        WorldRequest read;
        archive(read);
        EXPECT_FALSE(archive.failed()) << archive.fault();
        EXPECT_EQ(archive.left(), 0U);
        EXPECT_EQ(read, request) << request.index();
    }
}

TEST(WorldRequestTest, WhatIsOutOfRangeIsRefused) {
    const float nan = std::nanf("");
    for (const WorldRequest& request :
         std::vector<WorldRequest>{SwitchEffect{"", true},
                                   SwitchEffect{std::string(65, 'x'), true},
                                   SetFog{.density_scale = nan},
                                   SetFog{.density_scale = 0},
                                   SetFog{.color = 6},
                                   SetLight{.scale = nan},
                                   SetLight{.scale = 1e9F},
                                   SetHour{.hour = -0.25},
                                   SetHour{.hour = std::nan("")},
                                   SetAccuracy{{.solver = static_cast<physics::Solver>(99)}},
                                   SetAccuracy{{.step_hz = 0}},
                                   SetAccuracy{{.substeps = -1}},
                                   SetAccuracy{{.substeps_max = 65}},
                                   SetAccuracy{{.iterations = 0}},
                                   SetAnimation{.time_s = -1},
                                   SetAnimation{.time_s = HUGE_VAL}}) {
        const std::string bytes = bytes_of(request);
        Archive archive(bytes);
        WorldRequest read;
        archive(read);
        EXPECT_TRUE(archive.failed()) << request.index();
    }
}

TEST(WorldRequestTest, UnknownKindsAndWhatBreaksOffAreRefused) {
    for (const WorldRequest& request : kOneOfEach) {
        std::string bytes = bytes_of(request);
        bytes.pop_back();
        Archive archive(bytes);
        WorldRequest read;
        archive(read);
        EXPECT_TRUE(archive.failed()) << request.index();
    }
    const std::string unknown(1, static_cast<char>(kOneOfEach.size()));
    Archive archive(unknown);
    WorldRequest read;
    archive(read);
    EXPECT_EQ(archive.fault(), "a kind of request");
}

}  // namespace
}  // namespace plumbline::app

// Runs of scenes that are written for the test.
#pragma once

#include "engine/study/scenes/scene_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace plumbline::study {

inline constexpr std::string_view kFalling = R"([[entity]]
name = "ball"
position_m = [1, 100, 0]
[entity.body]
kind = "dynamic"
shape = { sphere = 0.5 }
mass_kg = 2
velocity_mps = [3, 0, 0]
)";

class SceneRunTest : public testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(file_); }

    SceneRun run_of(std::string_view text) const {
        std::ofstream(file_, std::ios::binary) << text;
        return {.scene = file_, .moments = {15, 30}};
    }

    std::filesystem::path file_{std::filesystem::temp_directory_path() /
                                ("plumbline_scene_run_" + std::to_string(getpid()) + ".toml")};
};

}  // namespace plumbline::study

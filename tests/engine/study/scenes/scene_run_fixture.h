// Runs of scenes that are written for the test.
#pragma once

#include "engine/study/scenes/scene_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
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

/// A scene of a text as studies play it.
class PlayedSceneTest : public SceneRunTest {
protected:
    /// Started.
    PlayedScene& play(std::string_view text) {
        std::ofstream(file_, std::ios::binary) << text;
        const Result<scene::OpenedScene> opened = open_for_study(file_);
        EXPECT_TRUE(opened);
        Result<PlayedScene> made = PlayedScene::create(*opened, library_);
        EXPECT_TRUE(made);
        scene_.emplace(std::move(*made));
        scene_->start();
        return *scene_;
    }

    assets::AssetLibrary library_;
    std::optional<PlayedScene> scene_;
};

}  // namespace plumbline::study

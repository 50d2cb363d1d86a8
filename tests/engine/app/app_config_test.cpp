#include "engine/app/app_config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace plumbline::app {
namespace {
namespace fs = std::filesystem;

class AppConfigTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / "app_config_test";
        fs::create_directories(folder_ / "user");
    }
    void TearDown() override { fs::remove_all(folder_); }

    AppConfig load(const std::string& user_text) {
        std::ofstream(folder_ / "user" / "app.toml") << user_text;
        return load_app_config(fs::path(PL_SOURCE_DIR) / "config", folder_ / "user", faults_);
    }

    std::string only_fault() const {
        return faults_.list().size() == 1 ? to_string(faults_.list().front()) : "not one fault";
    }

    fs::path folder_;
    Diagnostics faults_;
};

TEST_F(AppConfigTest, TheShippedFileIsCleanAndSaysTheDefaults) {
    const AppConfig shipped = load("");
    EXPECT_TRUE(faults_.list().empty());
    const AppConfig built_in;
    EXPECT_EQ(shipped.width, built_in.width);
    EXPECT_EQ(shipped.max_steps_per_frame, built_in.max_steps_per_frame);
    EXPECT_EQ(shipped.master_gain, built_in.master_gain);
}

TEST_F(AppConfigTest, TheUsersLineWins) {
    EXPECT_EQ(load("[window]\nwidth = 800\n").width, 800);
    EXPECT_TRUE(faults_.list().empty());
}

TEST_F(AppConfigTest, ABadEntryCostsOnlyItself) {
    const AppConfig config = load("[window]\nwidth = \"wide\"\nheight = 480\n");
    EXPECT_EQ(config.width, 1280);
    EXPECT_EQ(config.height, 480);
    EXPECT_EQ(only_fault(),
              "app.toml:2:9: warning: window.width: expected a whole number from 64 to 16384; the "
              "value before it stands");
}

TEST_F(AppConfigTest, NotFiniteIsOutOfRange) {
    EXPECT_EQ(load("[sound]\nmaster_gain = nan\n").master_gain, 1.0F);
    EXPECT_EQ(only_fault(),
              "app.toml:2:15: warning: sound.master_gain: expected a number from 0 to 1; the value "
              "before it stands");
}

TEST_F(AppConfigTest, AnUnknownKeyNamesTheNearest) {
    load("[window]\nwitdh = 800\n");
    EXPECT_EQ(
        only_fault(),
        "app.toml:2:9: warning: window.witdh: no such setting. Nearest: \"width\". Line ignored.");
}

TEST_F(AppConfigTest, ASyntaxErrorLeavesTheLowerLayerStanding) {
    EXPECT_EQ(load("[window\nwidth = 1\n").width, 1280);
    ASSERT_EQ(faults_.list().size(), 1U);
    EXPECT_EQ(faults_.list().front().line, 1);
}

TEST_F(AppConfigTest, MissingFilesMeanDefaults) {
    Diagnostics faults;
    EXPECT_EQ(load_app_config(folder_ / "none", {}, faults).height, 720);
    EXPECT_TRUE(faults.list().empty());
}

}  // namespace
}  // namespace plumbline::app

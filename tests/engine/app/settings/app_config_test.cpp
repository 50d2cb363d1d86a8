#include "engine/app/settings/app_config.h"

#include "engine/app/settings/live_config.h"

#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>

namespace plumbline::app {
namespace {
namespace fs = std::filesystem;

/// As in most of Europe: what a stream under the global locale would print.
struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
};

class AppConfigTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::create_directories(folder_ / "user");
    }
    void TearDown() override { fs::remove_all(folder_); }

    AppConfig load(const std::string& user_text) {
        std::ofstream(folder_ / "user" / "app.toml") << user_text;
        return load_app_config(
            {fs::path(PL_SOURCE_DIR) / "config" / "app.toml", folder_ / "user" / "app.toml"},
            faults_);
    }

    std::string only_fault() const {
        return faults_.list().size() == 1 ? to_string(faults_.list().front()) : "not one fault";
    }

    fs::path folder_;
    Diagnostics faults_;
};

TEST_F(AppConfigTest, TheShippedFileIsCleanAndSaysTheDefaults) {
    EXPECT_EQ(load(""), AppConfig{});
    EXPECT_TRUE(faults_.list().empty());
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
              "app.toml:2:9: warning: window.width: expected a whole number from 64 to 16384; "
              "keeping the previous value");
}

TEST_F(AppConfigTest, NotFiniteIsOutOfRange) {
    EXPECT_EQ(load("[sound]\nmaster_gain = nan\n").master_gain, 1.0F);
    EXPECT_EQ(only_fault(),
              "app.toml:2:15: warning: sound.master_gain: expected a number from 0 to 1; "
              "keeping the previous value");
}

TEST_F(AppConfigTest, AnUnknownKeyNamesTheNearest) {
    load("[window]\nwitdh = 800\n");
    EXPECT_EQ(
        only_fault(),
        "app.toml:2:9: warning: window.witdh: unknown setting. Nearest: \"width\". Line ignored.");
}

TEST_F(AppConfigTest, AKeyAboveItsTableNamesTheTable) {
    load("level = \"low\"\n");
    EXPECT_EQ(only_fault(), "app.toml:1:9: warning: level: expected below [image]. Line ignored.");
}

TEST_F(AppConfigTest, AnOldFileWithTheStepLimitIsReadWithOneWarning) {
    EXPECT_EQ(load("[time]\nmax_steps_per_frame = 4\n[window]\nwidth = 800\n").width, 800);
    EXPECT_EQ(only_fault(),
              "app.toml:2:23: warning: time.max_steps_per_frame: this setting was removed. Line "
              "ignored.");
}

TEST_F(AppConfigTest, TheOldNameOfATableIsReadWithOneWarning) {
    const AppConfig config = load("[picture]\nlevel = \"low\"\nfov_deg = 60\n");
    EXPECT_EQ(config.quality_level, QualityLevel::Low);
    EXPECT_EQ(config.fov_deg, 60.0F);
    EXPECT_EQ(only_fault(), "app.toml:1:2: warning: picture: \"picture\" was renamed to \"image\"");
}

TEST_F(AppConfigTest, ASyntaxErrorLeavesTheLowerLayerStanding) {
    EXPECT_EQ(load("[window\nwidth = 1\n").width, 1280);
    ASSERT_EQ(faults_.list().size(), 1U);
    EXPECT_EQ(faults_.list().front().line, 1);
}

TEST_F(AppConfigTest, MissingFilesMeanDefaults) {
    Diagnostics faults;
    EXPECT_EQ(load_app_config({folder_ / "none" / "app.toml"}, faults).height, 720);
    EXPECT_TRUE(faults.list().empty());
}

TEST_F(AppConfigTest, ALevelIsAWord) {
    EXPECT_EQ(load("[image]\nlevel = \"low\"\n").quality_level, QualityLevel::Low);
    EXPECT_TRUE(faults_.list().empty());
    EXPECT_EQ(load("[image]\nanti_aliasing = \"msaa4\"\n").anti_aliasing, EdgeWish::Msaa4);
    EXPECT_EQ(load("[image]\nlevel = \"best\"\n").quality_level, QualityLevel::Auto);
    EXPECT_EQ(only_fault(),
              "app.toml:2:9: warning: image.level: expected one of auto, low, medium, high; "
              "keeping the previous value");
}

TEST_F(AppConfigTest, TheWrittenTextHoldsOnlyWhatDiffersAndReadsBack) {
    AppConfig wanted;
    wanted.quality_level = QualityLevel::Medium;
    wanted.fov_deg = 92.5F;
    wanted.mute = true;
    wanted.max_fps = 60;
    const std::string text = ui_config_text(AppConfig{}, wanted);
    EXPECT_EQ(text.substr(text.find("format")),
              "format = 1\n\n[window]\nmax_fps = 60\n\n[image]\nlevel = \"medium\"\n"
              "fov_deg = 92.5\n\n[sound]\nmute = true\n");
    EXPECT_EQ(load(text), wanted);
    EXPECT_TRUE(faults_.list().empty());
}

// EXPERIENCE D21
TEST_F(AppConfigTest, NumbersAreWrittenAndReadWithAPointWhateverTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
        if (std::setlocale(LC_ALL, name) != nullptr) break;
    }
    const std::locale global_before =
        std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    AppConfig wanted;
    wanted.master_gain = 0.25F;
    const std::string text = ui_config_text(AppConfig{}, wanted);
    const AppConfig read = load(text);
    std::locale::global(global_before);
    std::setlocale(LC_ALL, before.c_str());
    EXPECT_NE(text.find("master_gain = 0.25\n"), std::string::npos) << text;
    EXPECT_EQ(read, wanted);
}

class LiveConfigTest : public AppConfigTest {
protected:
    LiveConfig open() const { return LiveConfig({}, folder_ / "user"); }
    std::string written() const {
        std::ifstream file(folder_ / "user" / "app.ui.toml");
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

TEST_F(LiveConfigTest, AChangeIsStoredAtOnceAndTheHandWrittenFileStays) {
    load("[sound]\nmaster_gain = 0.5\n");
    LiveConfig config = open();
    AppConfig wanted = config.current();
    wanted.fov_deg = 100.0F;
    ASSERT_TRUE(config.change(wanted));
    EXPECT_EQ(open().current(), wanted);
    EXPECT_EQ(written().find("master_gain"), std::string::npos);

    // Back at what the layers below say, nothing of it is left.
    ASSERT_TRUE(config.change(config.below()));
    EXPECT_EQ(open().current().fov_deg, 70.0F);
    EXPECT_EQ(open().current().master_gain, 0.5F);
    std::ifstream by_hand(folder_ / "user" / "app.toml");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(by_hand), {}),
              "[sound]\nmaster_gain = 0.5\n");
}

// What is saved by hand holds at once; a fault costs its line or, if nothing can be read, nothing.
TEST_F(LiveConfigTest, IsReadAgainWhenTheHandWrittenFileIsSaved) {
    load("[sound]\nmaster_gain = 0.5\n");
    LiveConfig config = open();
    double now_s = 0.0;
    const auto saved = [&](const std::string& text) {
        load(text);
        bool changed = false;
        // It is quiet for a while before it is read.
        for (int i = 0; i < 4; ++i, now_s += 0.2) changed |= config.reload_if_changed(now_s);
        return changed;
    };
    EXPECT_FALSE(config.reload_if_changed(now_s));
    EXPECT_TRUE(saved("[sound]\nmaster_gain = 0.25\n[image]\nfov_deg = 90.0\n"));
    EXPECT_EQ(config.current().master_gain, 0.25F);
    EXPECT_EQ(config.current().fov_deg, 90.0F);
    EXPECT_EQ(config.below().fov_deg, 90.0F);
    EXPECT_TRUE(config.faults().list().empty());

    EXPECT_TRUE(saved("[sound]\nmaster_gain = 0.75\n[image]\nfov_deg = \"wide\"\n"));
    EXPECT_EQ(config.current().master_gain, 0.75F);
    EXPECT_EQ(config.current().fov_deg, 70.0F);
    ASSERT_EQ(config.faults().list().size(), 1U);
    EXPECT_EQ(to_string(config.faults().list()[0]),
              "app.toml:4:11: warning: image.fov_deg: expected a number from 30 to 120; "
              "keeping the previous value");

    EXPECT_TRUE(saved("[sound\nmaster_gain = 0.1\n"));
    EXPECT_EQ(config.current().master_gain, 0.75F) << "what was in force stays";
    ASSERT_TRUE(config.faults().has_errors());
    EXPECT_EQ(config.faults().list()[0].line, 1);
    EXPECT_TRUE(saved("[sound]\nmaster_gain = 0.1\n"));
    EXPECT_EQ(config.current().master_gain, 0.1F);
    EXPECT_TRUE(config.faults().list().empty());
}

TEST_F(LiveConfigTest, ReadAgainItKeepsWhatThePagesChose) {
    load("[sound]\nmaster_gain = 0.5\n");
    LiveConfig config = open();
    AppConfig wanted = config.current();
    wanted.fov_deg = 100.0F;
    ASSERT_TRUE(config.change(wanted));
    bool changed = false;
    double now_s = 0.0;
    const auto wait = [&] {
        for (int i = 0; i < 8; ++i, now_s += 0.2) changed |= config.reload_if_changed(now_s);
    };
    wait();
    EXPECT_FALSE(changed) << "the program's own saves are nothing new";
    load("[sound]\nmute = true\n");
    wait();
    EXPECT_TRUE(changed);
    EXPECT_EQ(config.current().fov_deg, 100.0F);
    EXPECT_EQ(config.below().fov_deg, 70.0F);
    EXPECT_EQ(config.current().master_gain, 1.0F);
    EXPECT_TRUE(config.current().mute);
    // Gone is not the same as empty: what was in force stays.
    fs::remove(folder_ / "user" / "app.toml");
    wait();
    EXPECT_TRUE(config.current().mute);
}

// EXPERIENCE D1
TEST_F(LiveConfigTest, NothingIsWrittenUntilAChange) {
    LiveConfig config = open();
    ASSERT_TRUE(config.change(config.current()));
    EXPECT_FALSE(fs::exists(folder_ / "user" / "app.ui.toml"));
}

TEST_F(LiveConfigTest, TheCommandLinesLevelHoldsUntilAnotherIsChosenAndIsNotStored) {
    LiveConfig config = open();
    config.put_level(QualityLevel::High);
    AppConfig wanted = config.current();
    EXPECT_EQ(wanted.quality_level, QualityLevel::High);
    wanted.mute = true;
    ASSERT_TRUE(config.change(wanted));
    EXPECT_EQ(config.current().quality_level, QualityLevel::High);
    EXPECT_EQ(open().current().quality_level, QualityLevel::Auto) << "another setting was changed";
    wanted.quality_level = QualityLevel::Low;
    ASSERT_TRUE(config.change(wanted));
    EXPECT_EQ(config.current().quality_level, QualityLevel::Low);
    EXPECT_EQ(open().current().quality_level, QualityLevel::Low);
}

// EXPERIENCE D16: a file stands where the folder should be, so that root cannot make it either.
TEST_F(LiveConfigTest, WhereNothingCanBeWrittenTheChangeLastsForTheSession) {
    std::ofstream(folder_ / "blocked") << "a file";
    for (const fs::path& user : {folder_ / "blocked", folder_ / "blocked" / "deeper", fs::path()}) {
        LiveConfig config({}, user);
        AppConfig wanted = config.current();
        wanted.mute = true;
        const Result<Done> stored = config.change(wanted);
        ASSERT_FALSE(stored);
        EXPECT_TRUE(stored.error().message.starts_with(
            "settings cannot be saved and last for this session only: "))
            << stored.error().message;
        EXPECT_TRUE(config.current().mute);
    }
}

}  // namespace
}  // namespace plumbline::app

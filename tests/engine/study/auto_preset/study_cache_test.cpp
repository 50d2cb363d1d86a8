#include "engine/study/auto_preset/study_cache.h"

#include "engine/core/io/files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

namespace plumbline::study {
namespace {

namespace fs = std::filesystem;

class StudyCacheTest : public testing::Test {
protected:
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_{fs::temp_directory_path() /
                     ("plumbline_study_cache_" + std::to_string(getpid()))};
    StudyKey key_{.scene = 17, .program = 23, .machine = "a processor, 2 cores"};
};

CachedStudy study(double error) {
    CachedStudy cached{.made_on = "2026-11-21"};
    Subject& subject = cached.study.subject;
    subject.id = "pile.toml";
    subject.tier = Tier::Spread;
    subject.metrics = {{"position", "the scene's size, 3 m"}};
    Point point;
    point.setting.step_hz = 120;
    point.errors = {error};
    point.cost.ms_per_s_min = 0.1 + 0.2;
    point.cost.repeats = 5;
    subject.points = {point};
    cached.study.seconds = 2.0 / 3.0;
    cached.study.subject.uncertainty = 1e-4 / 3.0;
    cached.study.chaotic = true;
    return cached;
}

TEST_F(StudyCacheTest, WhatIsKeptIsFoundToTheLastBit) {
    ASSERT_TRUE(keep_study(folder_, key_, study(1.0 / 3.0)));
    const auto found = find_study(folder_, key_);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->study.subject.points.at(0).errors, std::vector{1.0 / 3.0});
    EXPECT_EQ(found->study.subject.points.at(0).cost.ms_per_s_min, 0.1 + 0.2);
    EXPECT_EQ(found->study.subject.points.at(0).setting.step_hz, 120);
    EXPECT_EQ(found->study.subject.tier, Tier::Spread);
    EXPECT_EQ(found->study.seconds, 2.0 / 3.0);
    EXPECT_EQ(found->study.subject.uncertainty, 1e-4 / 3.0);
    EXPECT_TRUE(found->study.chaotic);
    EXPECT_EQ(found->made_on, "2026-11-21");
}

TEST_F(StudyCacheTest, AnotherSceneProgramOrMachineFindsNothing) {
    ASSERT_TRUE(keep_study(folder_, key_, study(0.1)));
    StudyKey other = key_;
    other.scene = 18;
    EXPECT_FALSE(find_study(folder_, other));
    other = key_;
    other.program = 24;
    EXPECT_FALSE(find_study(folder_, other));
    other = key_;
    other.machine = "another";
    EXPECT_FALSE(find_study(folder_, other));
    EXPECT_TRUE(find_study(folder_, key_));
}

TEST_F(StudyCacheTest, AQuickStudyDoesNotReplaceAFullOne) {
    CachedStudy quick = study(0.2);
    quick.grid = GridSize::Quick;
    ASSERT_TRUE(keep_study(folder_, key_, quick));
    EXPECT_EQ(find_study(folder_, key_)->grid, GridSize::Quick);
    ASSERT_TRUE(keep_study(folder_, key_, study(0.1)));
    ASSERT_TRUE(keep_study(folder_, key_, quick));
    const auto found = find_study(folder_, key_);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->grid, GridSize::Full);
    EXPECT_EQ(found->study.subject.points.at(0).errors, std::vector{0.1});
}

// Cut off, overwritten, of another kind: none is used, and a new study takes the place.
TEST_F(StudyCacheTest, WhatCannotBeReadIsIgnored) {
    ASSERT_TRUE(keep_study(folder_, key_, study(0.1)));
    const fs::path file = study_file(folder_, key_);
    const std::string whole = read_file(file, 1 << 20).value();
    for (const std::string& text : {whole.substr(0, whole.size() / 2),
                                    std::string("\xff\xfe no JSON"),
                                    std::string("[]"),
                                    std::string("{\"format\": 99}"),
                                    std::string()}) {
        std::ofstream(file, std::ios::binary) << text;
        EXPECT_FALSE(find_study(folder_, key_)) << text.substr(0, 40);
    }
    ASSERT_TRUE(keep_study(folder_, key_, study(0.1)));
    EXPECT_TRUE(find_study(folder_, key_));
}

// Whoever believed such a file would stop at an assert, or hang, at every start with "auto".
TEST_F(StudyCacheTest, SettingsThatNoSceneMayAskForAreThrownAway) {
    for (const Setting& wrong : {Setting{.step_hz = 0},
                                 Setting{.step_hz = 29},
                                 Setting{.step_hz = 1001},
                                 Setting{.substeps = 65},
                                 Setting{.substeps_max = 0},
                                 Setting{.iterations = 0},
                                 Setting{.iterations = 1001}}) {
        CachedStudy kept = study(0.1);
        kept.study.subject.points.at(0).setting = wrong;
        ASSERT_TRUE(keep_study(folder_, key_, kept));
        EXPECT_FALSE(find_study(folder_, key_)) << setting_text(wrong);
        EXPECT_FALSE(fs::exists(study_file(folder_, key_))) << setting_text(wrong);
    }
    for (const Setting& right : {Setting{.step_hz = 30, .substeps = 64, .iterations = 1000},
                                 Setting{.step_hz = 1000, .substeps_max = 64}}) {
        CachedStudy kept = study(0.1);
        kept.study.subject.points.at(0).setting = right;
        ASSERT_TRUE(keep_study(folder_, key_, kept));
        EXPECT_TRUE(find_study(folder_, key_)) << setting_text(right);
    }
}

TEST_F(StudyCacheTest, NumbersThatAreNoneAreThrownAway) {
    ASSERT_TRUE(keep_study(folder_, key_, study(0.1)));
    const fs::path file = study_file(folder_, key_);
    const std::string whole = read_file(file, 1 << 20).value();
    const std::size_t at = whole.find("\"step_hz\": ") + 11;
    for (const char* number : {"1e67", "-60", "60.5", "null", "\"60\""}) {
        std::string text = whole;
        text.replace(at, text.find_first_of(",\n", at) - at, number);
        std::ofstream(file, std::ios::binary) << text;
        EXPECT_FALSE(find_study(folder_, key_)) << number;
        EXPECT_FALSE(fs::exists(file)) << number;
    }
}

TEST_F(StudyCacheTest, DeepJsonIsThrownAwayNotCrashedOn) {
    ASSERT_TRUE(keep_study(folder_, key_, study(0.1)));
    const fs::path file = study_file(folder_, key_);
    std::ofstream(file, std::ios::binary) << std::string(200'000, '[') << std::string(200'000, ']');
    EXPECT_FALSE(find_study(folder_, key_));
    EXPECT_FALSE(fs::exists(file));
}

TEST_F(StudyCacheTest, AFileOfAnotherKeyInItsPlaceIsNotUsed) {
    ASSERT_TRUE(keep_study(folder_, key_, study(0.1)));
    StudyKey other = key_;
    other.scene = 18;
    fs::copy_file(study_file(folder_, key_), study_file(folder_, other));
    EXPECT_FALSE(find_study(folder_, other));
}

TEST_F(StudyCacheTest, WithoutAFolderNothingIsKeptOrFound) {
    EXPECT_FALSE(find_study({}, key_));
    EXPECT_FALSE(keep_study({}, key_, study(0.1)));
}

TEST(StudyKey, NamesTheRunningProgram) {
    const scene::OpenedScene scene;
    const StudyKey key = study_key(scene);
    EXPECT_EQ(key.scene, scene.motion_hash());
    EXPECT_NE(key.program, 0U);
    EXPECT_FALSE(key.machine.empty());
    EXPECT_EQ(study_key(scene).program, key.program);
}

}  // namespace
}  // namespace plumbline::study

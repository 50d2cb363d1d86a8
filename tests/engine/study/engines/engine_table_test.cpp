#include "engine/study/engines/engine_table.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

TEST(EngineTable, NamesAreReadInTheirOrderAndOnce) {
    const auto engines = engines_from("ode,bullet,ode");
    ASSERT_TRUE(engines);
    ASSERT_EQ(engines->size(), 2U);
    EXPECT_EQ((*engines)[0]->name, "ode");
    EXPECT_EQ((*engines)[1]->name, "bullet");
    EXPECT_EQ(engines_from("all")->size(), engine_table().size());
}

TEST(EngineTable, AnUnknownNameIsRefusedWithTheNearest) {
    for (const char* names : {"bulet", "jolt,bulet", "jolt,", ""}) {
        const auto engines = engines_from(names);
        ASSERT_FALSE(engines) << names;
        EXPECT_EQ(engines.error().exit_code, ExitCode::BadUsage);
        EXPECT_NE(engines.error().message.find("jolt, rapier"), std::string::npos);
    }
    EXPECT_NE(engines_from("bulet").error().message.find("bullet"), std::string::npos);
}

TEST(EngineTable, ASettingIsTold) {
    EXPECT_EQ(engine_setting_text({"jolt", 120, {}}), "120 Hz");
    EXPECT_EQ(engine_setting_text({"jolt", 60, {{"iterations", 50}}}), "60 Hz, 50 iterations");
    EXPECT_EQ(engine_setting_text({"ode", 60, {{"direct", 1}}}), "60 Hz, direct");
}

TEST(EngineTable, EveryLadderStartsWithTheDefaults) {
    for (const EngineRow& row : engine_table()) {
        ASSERT_FALSE(row.ladder.empty());
        EXPECT_TRUE(row.ladder.front().knobs.empty());
        for (const EngineSetting& setting : row.ladder) EXPECT_EQ(setting.engine, row.name);
    }
}

TEST(EngineTable, AskedForNothingThereIsNothing) {
    const auto engines = installed_engines("");
    ASSERT_TRUE(engines);
    EXPECT_TRUE(engines->empty());
}

}  // namespace
}  // namespace plumbline::study

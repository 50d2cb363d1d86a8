#include "engine/study/scenes/effects_cost.h"

#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace plumbline::study {
namespace {

TEST(EffectsCost, JobsThatAreNoneAreRefused) {
    for (const char* body : {"", "[]", "{}", R"({"scene": 3})"}) {
        const Result<std::string> answer = run_effect_job(body);
        ASSERT_FALSE(answer.ok()) << body;
        EXPECT_TRUE(answer.error().message.starts_with("expected an effect to measure: ")) << body;
    }
    EXPECT_FALSE(
        run_effect_job(R"({"scene": "/nowhere.toml", "effect": "", "seconds": 1, "pairs": 1})")
            .ok());
}

// A scene of a ball that flies: swept while it is fast, and nothing else.
TEST(EffectsCost, AScenesEffectsAreListedAndMeasuredInPairs) {
    ::setenv("PLUMBLINE_DATA", PL_SOURCE_DIR, 1);
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "a.toml";
    std::ofstream(file) << "[[entity]]\nname = \"ball\"\n[entity.body]\nshape = { sphere = 0.1 }\n"
                           "velocity_mps = [200, 0, 0]\n";
    const auto job = [&](const std::string& effect) {
        return run_effect_job(
                   fmt::format(R"({{"scene": "{}", "effect": "{}", "seconds": 0.1, "pairs": 2}})",
                               file.string(),
                               effect))
            .value();
    };
    const std::string listed = job("");
    EXPECT_NE(listed.find("\"name\":\"continuous_collision\""), std::string::npos) << listed;
    EXPECT_NE(listed.find("\"calls\":6"), std::string::npos) << listed;
    EXPECT_EQ(listed.find("footsteps"), std::string::npos) << listed;
    const std::string measured = job("continuous_collision");
    // Two of each: one comma in each list.
    for (const char* key : {"\"step_ms\":[", "\"step_ms_without\":[", "\"frame_ms\":["}) {
        const std::size_t at = measured.find(key);
        ASSERT_NE(at, std::string::npos) << key;
        const std::string list = measured.substr(at, measured.find(']', at) - at);
        EXPECT_EQ(std::ranges::count(list, ','), 1) << list;
    }
}

TEST(EffectsCost, FidelitiesAreMeasuredAgainstPrecise) {
    ::setenv("PLUMBLINE_DATA", PL_SOURCE_DIR, 1);
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "a.toml";
    std::ofstream(file) << "[[entity]]\nname = \"ball\"\n[entity.body]\nshape = { sphere = 0.1 }\n"
                           "mass_kg = 0.1\nvelocity_mps = [40, 0, 0]\ndrag = { coefficient = 2 }\n";
    const Result<std::string> answer = run_effect_job(fmt::format(
        R"({{"scene": "{}", "effect": "drag", "seconds": 0.2, "pairs": 1}})", file.string()));
    ASSERT_TRUE(answer.ok()) << answer.error().message;
    const auto fidelities = nlohmann::json::parse(*answer)["fidelities"];
    ASSERT_EQ(fidelities.size(), 3U);
    EXPECT_EQ(fidelities[2]["largest_m"], 0.0);
    EXPECT_GT(fidelities[0]["largest_m"].get<double>(), 1e-5);
    EXPECT_GT(fidelities[0]["largest_m"], fidelities[1]["largest_m"]);
    EXPECT_GT(fidelities[1]["step_ms"].get<double>(), 0);
}

}  // namespace
}  // namespace plumbline::study

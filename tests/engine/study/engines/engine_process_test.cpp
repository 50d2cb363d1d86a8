// Engines that answer as they should, and those that do not: shell scripts.
#include "engine/study/engines/engine_process.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

ChildDef script(const std::string& text) {
    return {.program = "sh", .arguments = {"-c", text}, .silent = true};
}

std::string refusal(const Result<EngineMoved>& result) {
    return result ? "not refused" : result.error().message;
}

TEST(EngineProcess, AsksAndTakesTheAnswers) {
    auto engine = EngineProcess::start(script(
        R"(echo '{"version":"1.2"}'; read a; echo '{}'; read b; echo '{"cpu_ms":3,"step_ms":[1,2],"states":[1,null]}')"));
    ASSERT_TRUE(engine);
    EXPECT_EQ(engine->version(), "1.2");
    EXPECT_TRUE(engine->make(R"({"scene":{}})"));
    const Result<EngineMoved> moved = engine->advance({.steps = 2}, 10);
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->cpu_ms, 3);
    EXPECT_EQ(moved->step_ms, (std::vector<float>{1, 2}));
    EXPECT_EQ(moved->states.size(), 2U);
    EXPECT_FALSE(moved->is_finite);
}

TEST(EngineProcess, WhatWillNotStartIsRefused) {
    EXPECT_FALSE(EngineProcess::start({.program = "/nonexistent/engine", .silent = true}));
    for (const char* text :
         {"exit 3", "echo nonsense", "echo '{}'", "echo '{\"version\":7}'", "kill -9 $$"}) {
        const auto engine = EngineProcess::start(script(text));
        ASSERT_FALSE(engine) << text;
        EXPECT_EQ(engine.error().exit_code, ExitCode::Refused);
    }
    const auto missing =
        EngineProcess::start(script(R"(echo '{"failed":"its package is not installed"}')"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().message, "its package is not installed");
}

TEST(EngineProcess, WhatItLacksIsSaid) {
    auto engine = EngineProcess::start(
        script(R"(echo '{"version":"1"}'; read a; echo '{"lacks":"a cone"}')"));
    ASSERT_TRUE(engine);
    const Result<Done> made = engine->make(R"({"scene":{}})");
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().message, "it lacks a cone");
}

TEST(EngineProcess, ACrashAHangAndNonsenseEndARun) {
    const std::string head = R"(echo '{"version":"1"}'; read a; )";
    auto crashes = EngineProcess::start(script(head + "kill -11 $$"));
    ASSERT_TRUE(crashes);
    EXPECT_NE(refusal(crashes->advance({}, 10)).find("signal 11"), std::string::npos);
    auto hangs = EngineProcess::start(script(head + "sleep 30"));
    ASSERT_TRUE(hangs);
    EXPECT_EQ(refusal(hangs->advance({}, 0.2)), "it took longer than 0.2 s");
    for (const char* words :
         {"nonsense", "{}", "[1", R"({"cpu_ms":1,"step_ms":[1],"states":["a"]})"}) {
        auto engine = EngineProcess::start(script(head + "echo '" + words + "'"));
        ASSERT_TRUE(engine);
        EXPECT_NE(refusal(engine->advance({}, 10)).find("cannot be read"), std::string::npos)
            << words;
    }
}

}  // namespace
}  // namespace plumbline::study

// "stability" as far as it runs nothing: refusals, and what merged tables are judged to be.
#include "game/commands/stability_command.h"

#include "tests/engine/study/gallery/sample_table.h"
#include "tests/game/commands/command_run.h"

namespace plumbline::game {
namespace {

using test::CommandRun;
using test::CommandTest;
using test::ran;

class StabilityCommand : public CommandTest {
protected:
    StabilityCommand() {
        folder_.write("assets/scenes/hard/H01.toml",
                      "[scene]\ntitle = \"H01 a box\"\n"
                      "[hard_case]\nid = \"H01\"\nshows = \"A box.\"\nseconds = 1\n"
                      "known_to_fail = \"nobody\"\n"
                      "[[hard_case.pass]]\nmeasure = \"speed_mps\"\nbelow = 1\n"
                      "[[entity]]\nname = \"box\"\n[entity.body]\nmass_kg = 1\n"
                      "shape = { box = [1, 1, 1] }\n");
    }

    CommandRun judged(const StabilityOptions& options) {
        return ran([&] { return run_stability(options); });
    }
    /// The only part of a table of one run by small_step, whose rule allows 1.
    void write_part(double reached) {
        study::StabilityTable table =
            study::plan_table({study::entry("H01")}, {physics::Solver::SmallStep}, {60});
        table.build = "of a test";
        table.shard = study::Shard{.index = 1, .of = 1, .what = "plumbline stability H01"};
        table.runs[0].result = study::result(reached <= 1, 1 - reached);
        folder_.write("one/stability.json", study::stability_json(table));
    }
};

TEST_F(StabilityCommand, AnUnknownCaseIsToldTheNearest) {
    const CommandRun run = judged({.cases = {"H02"}, .out = folder_ / "out"});
    EXPECT_EQ(run.code, ExitCode::BadUsage);
    EXPECT_EQ(run.said, "plumbline: error: there is no hard case \"H02\"; did you mean H01?\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "nothing is made before";
}

TEST_F(StabilityCommand, WhatPassedIsGreen) {
    install_page();
    write_part(0.5);
    const CommandRun run = judged({.out = folder_ / "all",
                                   .merge = {folder_ / "one"},
                                   .images = false,
                                   .expect_green = true});
    EXPECT_EQ(run.code, ExitCode::Good) << run.said;
    EXPECT_EQ(run.said, "");
    EXPECT_TRUE(run.out.ends_with((folder_ / "all/stability.html").string() + "\n")) << run.out;
    EXPECT_NE(folder_.read("all/stability.json").find("plumbline stability H01"),
              std::string::npos);
    EXPECT_NE(folder_.read("all/stability.html").find("H01"), std::string::npos);
}

TEST_F(StabilityCommand, ABrokenRuleIsANoteUnlessGreenIsExpected) {
    write_part(2);
    const CommandRun noted = judged({.merge = {folder_ / "one"}});
    EXPECT_EQ(noted.code, ExitCode::Good);
    EXPECT_EQ(
        noted.said,
        "plumbline: info: H01: \"sag_m at most 1\" is broken (2), and no known_red says why\n");
    write_part(3);
    const CommandRun strict = judged({.merge = {folder_ / "one"}, .expect_green = true});
    EXPECT_EQ(strict.code, ExitCode::Differs);
    EXPECT_EQ(
        strict.said,
        "plumbline: error: H01: \"sag_m at most 1\" is broken (3), and no known_red says why\n");
}

TEST_F(StabilityCommand, ATableThatIsNotThereIsNamed) {
    EXPECT_EQ(judged({.merge = {folder_ / "none"}}).said,
              "plumbline: error: cannot open " + (folder_ / "none/stability.json").string() +
                  ": No such file or directory\n");
    std::filesystem::remove(folder_ / "assets/scenes/hard/H01.toml");
    EXPECT_EQ(
        judged({}).said,
        "plumbline: error: no hard cases in " + (folder_ / "assets/scenes/hard").string() + "\n");
}

}  // namespace
}  // namespace plumbline::game

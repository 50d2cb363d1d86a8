// The words of "simulate", and the solvers that --solver knows.
#include "game/commands/simulate_cli.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::game {
namespace {

/// Empty, or what is wrong with the words.
std::string parsed(std::vector<std::string> words, SimulateOptions& options) {
    CLI::App app;
    add_simulate(app, options);
    std::ranges::reverse(words);
    try {
        app.parse(words);
    } catch (const CLI::ParseError& error) {
        return error.what();
    }
    return {};
}

TEST(SimulateCli, EverySolverGoesByItsName) {
    for (const char* name :
         {"small_step", "bullet_si", "bullet_nncg", "bullet_dantzig", "bullet_pgs"}) {
        std::optional<physics::Solver> solver;
        take_solver(name, solver);
        ASSERT_TRUE(solver.has_value()) << name;
        EXPECT_EQ(physics::solver_name(*solver), name);
    }
}

TEST(SimulateCli, AnUnknownSolverIsToldTheNearestAndAll) {
    const std::string known =
        "; known: small_step, bullet_si, bullet_nncg, bullet_dantzig, bullet_pgs";
    SimulateOptions options;
    EXPECT_EQ(parsed({"simulate", "pile", "--solver", "smal_step"}, options),
              "--solver: there is no \"smal_step\"; the nearest is \"small_step\"" + known);
    EXPECT_EQ(parsed({"simulate", "pile", "--solver", "quaternion"}, options),
              "--solver: there is no \"quaternion\"" + known);
}

TEST(SimulateCli, WordsBecomeOptions) {
    SimulateOptions options;
    EXPECT_EQ(parsed({"simulate",    "pile", "--seconds", "2.5",     "--solver",     "bullet_si",
                      "--hz",        "240",  "--every",   "0.5",     "--seed",       "7",
                      "--drive-fps", "144",  "--trace",   "t.jsonl", "--substeps",   "1000",
                      "--state",     "-",    "--save",    "s.save",  "--iterations", "1"},
                     options),
              "");
    EXPECT_EQ(options.scene, "pile");
    EXPECT_EQ(options.seconds, 2.5);
    EXPECT_EQ(options.solver, physics::Solver::BulletSi);
    EXPECT_EQ(options.step_hz, 240);
    EXPECT_EQ(options.substeps, 1000);
    EXPECT_EQ(options.iterations, 1);
    EXPECT_EQ(options.seed, 7U);
    EXPECT_EQ(options.trace_every_s, 0.5);
    EXPECT_EQ(options.trace_file, "t.jsonl");
    EXPECT_EQ(options.state_file, "-");
    EXPECT_EQ(options.save_file, "s.save");
    EXPECT_EQ(options.drive_fps, 144.0);
    EXPECT_FALSE(options.expect_hash.has_value());
}

TEST(SimulateCli, NumbersOutOfRangeAndSettingsOfASavedGameAreRefused) {
    for (const auto& [option, value] : {std::pair{"--seconds", "-1"},
                                        {"--seconds", "nan"},
                                        {"--hz", "0"},
                                        {"--substeps", "0"},
                                        {"--substeps", "1001"},
                                        {"--iterations", "10001"},
                                        {"--every", "-0.1"},
                                        {"--drive-fps", "0.9"},
                                        {"--drive-fps", "100001"}}) {
        SimulateOptions options;
        const std::string said = parsed({"simulate", "pile", option, value}, options);
        EXPECT_TRUE(said.find(option) != std::string::npos) << value << ": " << said;
    }
    for (const auto& [option, value] : {std::pair{"--solver", "bullet_si"},
                                        {"--hz", "60"},
                                        {"--substeps", "2"},
                                        {"--iterations", "2"},
                                        {"--seed", "2"}}) {
        SimulateOptions options;
        EXPECT_EQ(parsed({"simulate", "pile", "--load", "x", option, value}, options),
                  std::string(option) + " excludes --load");
    }
    SimulateOptions options;
    EXPECT_EQ(parsed({"simulate"}, options), "scene is required");
}

}  // namespace
}  // namespace plumbline::game

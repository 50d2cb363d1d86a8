// "study" as far as it runs nothing: lists, refusals, and shards put together.
#include "game/commands/study/study_command.h"

#include "engine/study/findings/findings_json.h"
#include "tests/game/commands/command_run.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace plumbline::game {
namespace {

using test::CommandRun;
using test::CommandTest;
using test::ran;

class StudyCommand : public CommandTest {
protected:
    CommandRun studied(const StudyOptions& options) {
        return ran([&] { return run_study(options); });
    }
};

TEST_F(StudyCommand, TheListNamesEveryScenarioAndWhatIsLeftOut) {
    const CommandRun run = studied({.list = true});
    EXPECT_EQ(run.code, ExitCode::Good);
    EXPECT_TRUE(run.out.starts_with("A01 ")) << run.out.substr(0, 40);
    EXPECT_NE(run.out.find("\nA20 H=1 e=0.5      A ball falls and bounces\n"), std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("\nNot run:\n"), std::string::npos);
}

TEST_F(StudyCommand, AWordThatNothingBeginsWithIsToldTheNearest) {
    const CommandRun run = studied({.cases = {"A2O"}});
    EXPECT_EQ(run.code, ExitCode::BadUsage);
    EXPECT_EQ(run.said,
              "plumbline: error: there is no scenario and no scene \"A2O\"; the nearest is "
              "\"A20\"; run `plumbline study --list` to list all scenarios\n");
    const CommandRun far = studied({.cases = {"quaternions"}});
    EXPECT_EQ(far.said,
              "plumbline: error: there is no scenario and no scene \"quaternions\"; run "
              "`plumbline study --list` to list all scenarios\n");
    // What looks like a file is meant as one.
    const CommandRun file = studied({.cases = {"A2O.toml"}});
    EXPECT_EQ(file.code, ExitCode::Refused);
    EXPECT_TRUE(file.said.starts_with("plumbline: error: there is no scene \"A2O.toml\""))
        << file.said;
}

TEST_F(StudyCommand, EffectsWithoutASceneAreHeldToTheirReferences) {
    install_page();
    const std::filesystem::path folder = folder_ / "references";
    const CommandRun run = studied({.out = folder, .quiet = true, .effects = true});
    EXPECT_EQ(run.code, ExitCode::Good) << run.said;
    EXPECT_NE(run.out.find("\ndrag       a fall"), std::string::npos) << run.out;
    std::ifstream file(folder / "findings.json");
    const nlohmann::json errors = nlohmann::json::parse(file);
    ASSERT_TRUE(errors.is_array());
    EXPECT_GT(errors.size(), 80U);
    for (const nlohmann::json& each : errors) {
        EXPECT_LE(each["error"].get<double>(), each["tolerance"].get<double>()) << each;
        EXPECT_GT(each["cpu_ms_per_s"].get<double>(), 0) << each;
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "report.html"));
}

TEST_F(StudyCommand, EnginesRunScenes) {
    const CommandRun scenario = studied({.cases = {"A20"}, .engines = "bullet"});
    EXPECT_EQ(scenario.code, ExitCode::BadUsage);
    EXPECT_EQ(scenario.said, "plumbline: error: --engines needs a scene\n");
}

TEST_F(StudyCommand, ImagesAreOfScenes) {
    EXPECT_EQ(studied({.image = true}).said, "plumbline: error: --picture needs a scene\n");
    const CommandRun scenario = studied({.cases = {"A20"}, .image = true});
    EXPECT_EQ(scenario.code, ExitCode::Refused);
    EXPECT_TRUE(scenario.said.starts_with("plumbline: error: there is no scene \"A20\""))
        << scenario.said;
}

TEST_F(StudyCommand, ShardsMakeTheFilesOfTheWhole) {
    install_page();
    study::Findings part{.command = "plumbline study --shard 1/1", .build = "of a test"};
    part.shard = study::Shard{.index = 1, .of = 1, .what = "plumbline study A01"};
    folder_.write("one/findings.json", study::findings_to_json(part));
    const CommandRun run = studied({.out = folder_ / "all", .merge = {folder_ / "one"}});
    EXPECT_EQ(run.code, ExitCode::Good) << run.said;
    EXPECT_EQ(run.out, (folder_ / "all/report.html").string() + "\n");
    const auto whole = study::findings_from_json(folder_.read("all/findings.json"));
    ASSERT_TRUE(whole.ok()) << whole.error().message;
    EXPECT_EQ(whole->command, "plumbline study A01");
    EXPECT_FALSE(whole->shard.has_value());
    EXPECT_NE(folder_.read("all/findings.csv"), "");
    EXPECT_NE(folder_.read("all/report.html").find("plumbline study A01"), std::string::npos);
}

TEST_F(StudyCommand, ABadShardIsNamed) {
    folder_.write("one/findings.json", "[]");
    const CommandRun run = studied({.out = folder_ / "all", .merge = {folder_ / "one"}});
    EXPECT_EQ(run.code, ExitCode::Refused);
    EXPECT_TRUE(
        run.said.starts_with("plumbline: error: " + (folder_ / "one/findings.json").string() +
                             ": not what a study writes: "))
        << run.said;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "all")) << "nothing is made before";
    EXPECT_EQ(studied({.out = folder_ / "all", .merge = {folder_ / "two"}}).said,
              "plumbline: error: cannot open " + (folder_ / "two/findings.json").string() +
                  ": No such file or directory\n");
}

}  // namespace
}  // namespace plumbline::game

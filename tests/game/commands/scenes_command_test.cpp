// The list of scenes, in lines and as JSON.
#include "game/commands/scenes_command.h"

#include "tests/game/commands/command_run.h"

#include <nlohmann/json.hpp>

namespace plumbline::game {
namespace {

using test::CommandRun;
using test::CommandTest;
using test::ran;

class ScenesCommand : public CommandTest {
protected:
    ScenesCommand() {
        folder_.write("assets/scenes/slope.toml",
                      "[scene]\ntitle = \"A slope\"\ndescription = \"Steep.\"\n[camera]\n");
        folder_.write("assets/scenes/hard/H01.toml", "[scene]\ntitle = \"A stack\"\n[camera]\n");
        folder_.write("assets/scenes/z.toml", "[scene]\ndescription = \"No title\"\n[camera]\n");
    }
};

TEST_F(ScenesCommand, ALineEachInColumns) {
    const CommandRun run = ran([] { return run_scenes(false); });
    EXPECT_EQ(run.code, ExitCode::Good);
    EXPECT_EQ(run.out,
              "slope     A slope: Steep.\n"
              "z         No title\n"
              "hard/H01  A stack\n");
}

TEST_F(ScenesCommand, JsonHasItInPieces) {
    const CommandRun run = ran([] { return run_scenes(true); });
    EXPECT_EQ(run.code, ExitCode::Good);
    const nlohmann::json scenes = nlohmann::json::parse(run.out);
    ASSERT_EQ(scenes.size(), 3U);
    EXPECT_EQ(scenes[0],
              (nlohmann::json{{"name", "slope"},
                              {"title", "A slope"},
                              {"description", "Steep."},
                              {"file", (folder_ / "assets/scenes/slope.toml").string()}}));
    EXPECT_EQ(scenes[1]["title"], "");
    EXPECT_EQ(scenes[2]["name"], "hard/H01");
}

TEST_F(ScenesCommand, NamesCannotSteerTheTerminal) {
    folder_.write("assets/scenes/b.toml", "[scene]\ntitle = \"\\u001b[2J\"\n[camera]\n");
    const CommandRun run = ran([] { return run_scenes(false); });
    EXPECT_EQ(run.out.find('\x1b'), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("b         "), std::string::npos) << run.out;
}

TEST(ScenesCommandWithoutData, SaysWhatIsMissing) {
    const test::ScopedVariable data("PLUMBLINE_DATA", "/dev");
    const CommandRun run = ran([] { return run_scenes(true); });
    EXPECT_EQ(run.code, ExitCode::RunFailed);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.said,
              "plumbline: error: PLUMBLINE_DATA (or --data) names /dev, which does not hold the "
              "program's data: assets, shaders and config\n");
}

}  // namespace
}  // namespace plumbline::game

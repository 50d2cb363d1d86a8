// "check" and "controls": what they print, and how they end.
#include "game/commands/other_commands.h"

#include "tests/game/commands/command_run.h"

namespace plumbline::game {
namespace {

using test::CommandRun;
using test::CommandTest;
using test::ran;

class OtherCommands : public CommandTest {
protected:
    CommandRun checked(const std::vector<std::filesystem::path>& files) {
        return ran([&] { return run_check(files); });
    }
    /// A scene with a word that no scene knows.
    std::filesystem::path bad_scene() {
        return folder_.write("bad.toml", "[scene]\ntitle = \"Bad\"\n[sun]\nintensty = 1\n");
    }
    std::filesystem::path good_scene() {
        return folder_.write("good.toml", "[scene]\ntitle = \"Good\"\n");
    }
};

TEST_F(OtherCommands, AGoodFileIsSaidToBeGood) {
    const auto bindings = folder_.write("bindings.toml", "format = 1\n");
    const CommandRun run = checked({good_scene(), bindings});
    EXPECT_EQ(run.code, ExitCode::Good) << run.out;
    EXPECT_EQ(run.out,
              (folder_ / "good.toml").string() + ": good\n" + bindings.string() + ": good\n");
    EXPECT_EQ(checked({}).code, ExitCode::Good);
}

TEST_F(OtherCommands, AFaultIsSaidWithItsPlace) {
    const CommandRun run = checked({bad_scene()});
    EXPECT_EQ(run.code, ExitCode::Refused);
    EXPECT_TRUE(run.out.starts_with((folder_ / "bad.toml").string() + ":4:1: error: ")) << run.out;
    EXPECT_NE(run.out.find("intensity"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("good"), std::string::npos) << run.out;
}

TEST_F(OtherCommands, AFileIsReadAsWhatItsNameSays) {
    // A scene, which is none of the others.
    const std::string scene = "[scene]\ntitle = \"Not here\"\n";
    for (const auto& [name, fault] :
         {std::pair{"app.toml", "scene.title: unknown setting"},
          {"app.ui.toml", "scene.title: unknown setting"},
          {"surfaces.toml", "scene.title: unknown key; known: absorption"},
          {"bindings.toml", "no table [scene]"},
          {"bindings_mine.toml", "no table [scene]"},
          {"controls/mine.toml", "no table [scene]"}}) {
        const CommandRun run = checked({folder_.write(name, scene)});
        EXPECT_EQ(run.code, ExitCode::BadUsage) << name << ": " << run.out;
        EXPECT_NE(run.out.find(fault), std::string::npos) << name << ": " << run.out;
    }
    EXPECT_EQ(checked({folder_.write("my_bindings.toml", scene)}).code, ExitCode::Good);
}

TEST_F(OtherCommands, TheWorstFileDecides) {
    const auto app = folder_.write("app.toml", "[nothing]\na = 1\n");
    const CommandRun run = checked({good_scene(), bad_scene(), app});
    EXPECT_EQ(run.code, ExitCode::Refused);
    EXPECT_TRUE(run.out.starts_with((folder_ / "good.toml").string() + ": good\n")) << run.out;
    const std::string fault = (folder_ / "app.toml").string() + ":2:5: warning: nothing.a: ";
    EXPECT_NE(run.out.find(fault), std::string::npos) << run.out;
    EXPECT_EQ(checked({app, good_scene()}).code, ExitCode::BadUsage);
}

TEST_F(OtherCommands, AFileThatCannotBeReadIsSaidOnce) {
    const CommandRun scene = checked({folder_ / "none.toml"});
    EXPECT_EQ(scene.code, ExitCode::Refused);
    EXPECT_EQ(scene.out,
              (folder_ / "none.toml").string() + ": error: cannot open " +
                  (folder_ / "none.toml").string() + ": No such file or directory\n");
    const CommandRun bindings = checked({folder_ / "bindings.toml"});
    EXPECT_EQ(bindings.code, ExitCode::BadUsage);
    EXPECT_EQ(bindings.said,
              "plumbline: error: cannot open " + (folder_ / "bindings.toml").string() +
                  ": No such file or directory\n");
}

TEST_F(OtherCommands, ControlsAreThoseInForce) {
    folder_.write("config/bindings.toml", "format = 1\n[walk]\njump = [\"k\"]\n");
    const CommandRun shipped = ran([] { return run_controls({}); });
    EXPECT_EQ(shipped.code, ExitCode::Good) << shipped.said;
    EXPECT_NE(shipped.out.find("jump = [\"k\"] "), std::string::npos) << shipped.out;
    CommonOptions options;
    options.binds = {"jump=j"};
    EXPECT_NE(ran([&] { return run_controls(options); }).out.find("jump = [\"j\"] "),
              std::string::npos);
    options.binds = {"jmp=j"};
    const CommandRun wrong = ran([&] { return run_controls(options); });
    EXPECT_EQ(wrong.code, ExitCode::BadUsage);
    EXPECT_NE(wrong.said.find("jump"), std::string::npos) << wrong.said;
    EXPECT_NE(wrong.out.find("jump = [\"k\"] "), std::string::npos) << "what is in force is shown";
}

TEST_F(OtherCommands, OnlyAKnownSceneIsExplained) {
    const CommandRun run = ran([] { return run_explain("nowhere", false); });
    EXPECT_EQ(run.code, ExitCode::Refused);
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(run.said.starts_with("plumbline: error: there is no scene \"nowhere\""))
        << run.said;
}

}  // namespace
}  // namespace plumbline::game

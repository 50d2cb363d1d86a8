// `plumbline export`: files that come back, and how it ends.
#include "game/commands/export/export_command.h"

#include "engine/scene/scene_file.h"
#include "game/commands/simulate_command.h"
#include "tests/game/commands/command_run.h"

namespace plumbline::game {
namespace {

namespace fs = std::filesystem;

class ExportCommand : public test::CommandTest {
protected:
    fs::path scene() {
        return folder_.write(
            "s.toml",
            "[scene]\ntitle = \"Drop\"\n[[entity]]\nname = \"ball\"\n"
            "position_m = [0, 10, 0]\nprimitive = { sphere = 0.5 }\n[entity.body]\n"
            "[wind]\n");
    }
    test::CommandRun exported(const ExportOptions& options) {
        return test::ran([&] { return run_export(options); });
    }
    static Result<scene::SceneDescription> read(const fs::path& file) {
        Diagnostics faults;
        return scene::read_description(file, {}, faults);
    }
    test::ScopedVariable real_data_{"PLUMBLINE_DATA", PL_SOURCE_DIR};
};

TEST_F(ExportCommand, WritesASceneAndSaysWhatIsNotInIt) {
    const fs::path out = folder_ / "s.glb";
    const test::CommandRun run = exported({.scene = scene().string(), .out = out});
    EXPECT_EQ(run.code, ExitCode::Good) << run.said;
    EXPECT_NE(run.said.find("export: wind is left out"), std::string::npos) << run.said;
    const auto read_back = read(out);
    ASSERT_TRUE(read_back.ok()) << read_back.error().message;
    EXPECT_EQ(read_back->title, "Drop");
    EXPECT_EQ(read_back->entities.front().name, "ball");
}

TEST_F(ExportCommand, GoesOnFromASavedGame) {
    const fs::path saved = folder_ / "s.save";
    const fs::path out = folder_ / "s.glb";
    const test::CommandRun simulated = test::ran([&] {
        return run_simulate({.scene = scene().string(), .seconds = 1.0, .save_file = saved});
    });
    ASSERT_EQ(simulated.code, ExitCode::Good) << simulated.said;
    const test::CommandRun run = exported({.scene = scene().string(), .out = out, .load = saved});
    ASSERT_EQ(run.code, ExitCode::Good) << run.said;
    const auto read_back = read(out);
    ASSERT_TRUE(read_back.ok()) << read_back.error().message;
    const scene::EntityDescription& ball = read_back->entities.front();
    EXPECT_NEAR(static_cast<double>(ball.world_from_body.position.y), 10 - 9.81 / 2, 0.01);
    EXPECT_NEAR(static_cast<double>(ball.body->velocity_mps.y), -9.81, 0.01);
}

TEST_F(ExportCommand, RefusesWhatItCannotWrite) {
    EXPECT_EQ(exported({.scene = scene().string(), .out = folder_ / "s.obj"}).code,
              ExitCode::BadUsage);
    EXPECT_EQ(exported({.scene = "nosuch", .out = folder_ / "s.glb"}).code, ExitCode::Refused);
    EXPECT_EQ(exported({.scene = scene().string(), .out = folder_ / "s.glb", .load = scene()}).code,
              ExitCode::Refused);
    EXPECT_NE(exported({.scene = scene().string(), .out = folder_ / "none/s.glb"}).code,
              ExitCode::Good);
    EXPECT_FALSE(fs::exists(folder_ / "s.glb"));
}

}  // namespace
}  // namespace plumbline::game

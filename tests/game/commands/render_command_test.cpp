// What "render" and "tour" refuse before they draw, and where their files go.
#include "game/commands/render_command.h"

#include "tests/game/commands/command_run.h"

namespace plumbline::game {
namespace {

using test::CommandRun;
using test::CommandTest;
using test::ran;

class RenderCommand : public CommandTest {
protected:
    /// How a run with these options ends that draws nothing, since its scene is not there.
    CommandRun refused(RenderOptions options) {
        scene_ += 'e';  // the log says nothing twice
        options.scene = scene_;
        return ran([&] { return run_render(options, {}); });
    }
    /// What it says when all the rest was good.
    std::string no_scene() const {
        return "plumbline: error: there is no scene \"" + scene_ + "\" here, in " +
               (folder_ / "users/plumbline/scenes").string() + " or in " +
               (folder_ / "assets/scenes").string() + "; plumbline scenes lists them\n";
    }

    std::string scene_ = "nowher";
};

TEST_F(RenderCommand, AShadingHasOneOfThreeNames) {
    const CommandRun run = refused({.out = folder_ / "a.png", .shading = "toon"});
    EXPECT_EQ(run.code, ExitCode::BadUsage);
    EXPECT_EQ(run.said, "plumbline: error: --shading toon: expected pbr, blinn_phong or unlit\n");
    for (const char* known : {"", "pbr", "blinn_phong", "unlit"}) {
        const CommandRun on =
            refused({.out = folder_ / (std::string(known) + ".png"), .shading = known});
        EXPECT_EQ(on.code, ExitCode::Refused) << known;
    }
}

TEST_F(RenderCommand, WhatItReadsAndWritesIsLookedAtFirst) {
    const CommandRun path =
        refused({.out = folder_ / "a.png", .camera_path = folder_ / "none.path"});
    EXPECT_EQ(path.said,
              "plumbline: error: cannot open " + (folder_ / "none.path").string() +
                  ": No such file or directory\n");
    const CommandRun report = refused({.out = folder_ / "a.png", .report = folder_ / "assets"});
    EXPECT_EQ(
        report.said,
        "plumbline: error: cannot write " + (folder_ / "assets").string() + ": Is a directory\n");
    const CommandRun good = refused({.out = folder_ / "a.png", .report = folder_ / "report"});
    EXPECT_EQ(good.code, ExitCode::Refused);
    EXPECT_EQ(good.said, no_scene());
}

TEST_F(RenderCommand, ManyFramesMayGoToAFolder) {
    std::filesystem::create_directory(folder_ / "frames");
    std::filesystem::create_directory(folder_ / "frames.png");
    const auto is_a_folder = [&](const char* name) {
        return "plumbline: error: cannot write " + (folder_ / name).string() + ": Is a directory\n";
    };
    EXPECT_EQ(refused({.out = folder_ / "frames", .frames = 1}).said, is_a_folder("frames"));
    const CommandRun many = refused({.out = folder_ / "frames", .frames = 2});
    EXPECT_EQ(many.said, no_scene());
    EXPECT_EQ(refused({.out = folder_ / "frames.png", .frames = 2}).said,
              is_a_folder("frames.png"));
}

TEST_F(RenderCommand, AnImageWithoutANameGoesToTheUsersFolder) {
    EXPECT_EQ(refused({}).code, ExitCode::Refused);
    EXPECT_TRUE(std::filesystem::is_directory(folder_ / "users/plumbline/shots"));
}

TEST_F(RenderCommand, OnlyAReportWantsNoImage) {
    EXPECT_EQ(refused({.report = folder_ / "report"}).code, ExitCode::Refused);
    EXPECT_EQ(refused({.video = folder_ / "film.mp4"}).code, ExitCode::Refused);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "users"));
}

TEST_F(RenderCommand, ASizeIsTwoSides) {
    folder_.write("assets/scenes/empty.toml", "[scene]\ntitle = \"Nothing\"\n");
    const CommandRun run = ran([&] {
        return run_render({.scene = "empty", .out = folder_ / "a.png", .size = "640"}, {});
    });
    EXPECT_EQ(run.code, ExitCode::BadUsage);
    EXPECT_EQ(run.said, "plumbline: error: --size 640: expected WIDTHxHEIGHT, 1 to 16384 each\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

TEST_F(RenderCommand, ATourNeedsAFolderForItsSheet) {
    const auto file = folder_.write("file", "");
    const CommandRun run = ran([&] { return run_tour({.scene = "nowhere", .out = file}, {}); });
    EXPECT_EQ(run.code, ExitCode::RunFailed);
    EXPECT_TRUE(run.said.starts_with("plumbline: error: cannot make the folder " + file.string()))
        << run.said;
    std::filesystem::create_directories(folder_ / "tour/contact_sheet.png");
    const CommandRun sheet =
        ran([&] { return run_tour({.scene = "nowhere", .out = folder_ / "tour"}, {}); });
    EXPECT_EQ(sheet.said,
              "plumbline: error: cannot write " + (folder_ / "tour/contact_sheet.png").string() +
                  ": Is a directory\n");
    EXPECT_EQ(ran([&] { return run_tour({.scene = scene_, .out = folder_ / "new"}, {}); }).said,
              no_scene());
}

}  // namespace
}  // namespace plumbline::game

// Options that every command takes.
#include "game/command_line/command_line.h"

#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <optional>

namespace plumbline::game {
namespace {

TEST(CommandLine, ASizeIsTwoSidesOf1To16384) {
    int width = 0;
    int height = 0;
    EXPECT_TRUE(parse_size("1280x720", width, height));
    EXPECT_EQ(width, 1280);
    EXPECT_EQ(height, 720);
    EXPECT_TRUE(parse_size("1x16384", width, height));
    for (const char* bad : {"",
                            "x",
                            "1280",
                            "1280x",
                            "x720",
                            "0x5",
                            "5x0",
                            "16385x1",
                            "-5x5",
                            "1280X720",
                            "1280x720x3",
                            "12 x 7",
                            "99999999999x1"})
        EXPECT_FALSE(parse_size(bad, width, height)) << bad;
}

TEST(CommandLine, SafeModeReadsNoFolderOfTheUsers) {
    CommonOptions options;
    options.config_folder = "mine";
    options.binds = {"jump=k", "fog=j"};
    options.profile = "book";
    EXPECT_EQ(user_settings_folder(options), "mine");
    const app::BindingsDef def = bindings_def(options, {.config = "shipped"});
    EXPECT_EQ(def.shipped_folder, "shipped");
    EXPECT_EQ(def.user_folder, "mine");
    EXPECT_EQ(def.profile, "book");
    EXPECT_EQ(def.command_line, options.binds);
    EXPECT_FALSE(def.safe);
    options.safe = true;
    EXPECT_EQ(user_settings_folder(options), "");
    EXPECT_TRUE(bindings_def(options, {}).safe);
}

TEST(CommandLine, OptionsThatContradictEachOtherAreRefused) {
    const test::TemporaryFolder folder;
    const auto parses = [&](std::vector<std::string> words) {
        CLI::App app;
        CommonOptions options;
        add_common_options(app, options);
        std::reverse(words.begin(), words.end());
        try {
            app.parse(words);
            return true;
        } catch (const CLI::ParseError&) {
            return false;
        }
    };
    const std::string there = folder.path().string();
    EXPECT_TRUE(parses({"--config", there, "--quiet", "--bind", "a=b", "--bind", "c=d"}));
    EXPECT_FALSE(parses({"--config", there, "--safe"}));
    EXPECT_FALSE(parses({"--config", there + "/none"}));
    EXPECT_FALSE(parses({"--quiet", "--verbose"}));
    EXPECT_FALSE(parses({"--bind", "a=b", "c=d"})) << "one a word";
}

TEST(CommandLine, WhatWasGivenNoNameGetsOneInTheUsersFolder) {
    const test::TemporaryFolder folder;
    const test::ScopedVariable data("XDG_DATA_HOME", folder.path().string());
    const auto file = default_output("shots", "garden", ".png");
    ASSERT_TRUE(file.ok()) << file.error().message;
    EXPECT_EQ(file->parent_path(), folder.path() / "plumbline" / "shots");
    EXPECT_TRUE(std::filesystem::is_directory(file->parent_path()));
    EXPECT_TRUE(file->filename().string().starts_with("garden_")) << *file;
    EXPECT_EQ(file->extension(), ".png");
}

TEST(CommandLine, WithoutAHomeItSaysWhatToName) {
    const test::ScopedVariable data("XDG_DATA_HOME", std::nullopt);
    const test::ScopedVariable home("HOME", std::nullopt);
    EXPECT_EQ(default_output("shots", "garden", ".png").error().message,
              "no output folder: neither XDG_DATA_HOME nor HOME is set; use --out");
}

}  // namespace
}  // namespace plumbline::game

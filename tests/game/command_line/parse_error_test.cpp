// How a mistake on the command line is answered.
#include "game/command_line/parse_error.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace plumbline::game {
namespace {

class ParseErrorTest : public testing::Test {
protected:
    ParseErrorTest() {
        app_.add_flag("--quiet", quiet_, "Says less");
        CLI::App* drop = app_.add_subcommand("drop", "Drops it");
        drop->add_option("--speed", speed_, "How fast");
        app_.add_subcommand("throw", "Throws it")->add_option("--angle", speed_);
        app_.add_subcommand("secret", "For itself")->group("");
    }
    /// What is printed where errors go.
    std::string answer(std::vector<std::string> words, ExitCode code = ExitCode::BadUsage) {
        std::reverse(words.begin(), words.end());
        testing::internal::CaptureStderr();
        try {
            app_.parse(words);
            ADD_FAILURE() << "no mistake";
        } catch (const CLI::ParseError& error) {
            EXPECT_EQ(answer_parse_error(app_, error), code);
        }
        return testing::internal::GetCapturedStderr();
    }
    static std::string line(const std::string& words) {
        return "fall: " + words + "\nfall --help lists commands and options\n";
    }

    CLI::App app_{"Shows how things fall", "fall"};
    bool quiet_{false};
    double speed_{0};
};

TEST_F(ParseErrorTest, AnUnknownOptionNamesTheNearestOfTheCommandsInUse) {
    EXPECT_EQ(answer({"--quite"}), line("unknown option \"--quite\"; the nearest is \"--quiet\""));
    EXPECT_EQ(answer({"drop", "--sped", "3"}),
              line("unknown option \"--sped\"; the nearest is \"--speed\""));
    EXPECT_EQ(answer({"drop", "--angel"}), line("unknown option \"--angel\""))
        << "another command's";
    EXPECT_EQ(answer({"--xyzxyzxyz"}), line("unknown option \"--xyzxyzxyz\""));
}

TEST_F(ParseErrorTest, AnUnknownWordNamesTheCommandsThatAreShown) {
    EXPECT_EQ(answer({"dorp"}), line("unexpected word \"dorp\"; the commands are drop, throw"));
}

TEST_F(ParseErrorTest, WhatWasTypedIsShortenedAndSendsNothingToTheTerminal) {
    EXPECT_EQ(
        answer({std::string(100, 'x')}),
        line("unexpected word \"" + std::string(60, 'x') + "...\"; the commands are drop, throw"));
    const std::string said = answer({"\x1b[2J"});
    EXPECT_EQ(said.find('\x1b'), std::string::npos);
    EXPECT_NE(said.find("\\x1b[2J"), std::string::npos) << said;
}

TEST_F(ParseErrorTest, AValueThatIsNoneIsTheParsersOwnLine) {
    const std::string said = answer({"drop", "--speed", "fast"});
    EXPECT_TRUE(said.starts_with("fall: ")) << said;
    EXPECT_NE(said.find("--speed"), std::string::npos) << said;
    EXPECT_NE(said.find("fast"), std::string::npos) << said;
}

TEST_F(ParseErrorTest, AskingForHelpIsNoMistake) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(answer({"--help"}, ExitCode::Good), "");
    EXPECT_NE(testing::internal::GetCapturedStdout().find("Shows how things fall"),
              std::string::npos);
}

}  // namespace
}  // namespace plumbline::game

#include "game/command_line/command_docs.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace plumbline::game {
namespace {

/// A program with one option of its own, a command with a positional word, and one that is hidden.
class CommandDocs : public testing::Test {
protected:
    CommandDocs() {
        app.add_flag("--quiet", quiet, "Says less: it's silent");
        CLI::App* fall = app.add_subcommand("fall", "Lets [things] fall");
        fall->add_option("thing", thing, "What falls")->required();
        fall->add_option("-s,--speed", speed, ".5 is slow");
        app.add_subcommand("secret", "For itself")->group("");
    }

    CLI::App app{"Shows how things fall", "fall-f64"};
    bool quiet{false};
    std::string thing;
    double speed{0};
};

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(CommandDocs, ManPageHasEveryCommandAndOption) {
    const std::string page = man_page(app, "fall 1.0");
    EXPECT_TRUE(
        page.starts_with(".TH FALL\\-F64 1 \"\" \"fall 1.0\" \"User Commands\"\n.SH NAME\n"
                         "fall\\-f64 \\- Shows how things fall\n"))
        << page;
    EXPECT_TRUE(holds(page, ".TP\n\\fB\\-\\-quiet\\fR\nSays less: it's silent\n")) << page;
    EXPECT_TRUE(holds(page, ".SS fall thing\nLets [things] fall.\n")) << page;
    EXPECT_TRUE(holds(page, "\n.TP\n\\fBthing\\fR\nWhat falls\n")) << page;
    // A line that begins with a point would be a command of roff.
    EXPECT_TRUE(holds(page, "\\fB\\-s, \\-\\-speed\\fR \\fIFLOAT\\fR\n\\&.5 is slow\n")) << page;
    EXPECT_FALSE(holds(page, "secret"));
}

TEST_F(CommandDocs, BashOffersWordsOfTheCommandThatStandsThere) {
    const std::string script = bash_completion(app);
    EXPECT_TRUE(holds(script, "words='fall -h --help --quiet'")) << script;
    EXPECT_TRUE(holds(script, "        fall) words='-s --speed -h --help --quiet' ;;\n")) << script;
    EXPECT_TRUE(holds(script, "case $before in --speed | -s)")) << script;
    EXPECT_TRUE(holds(script, "complete -o filenames -F _fall_f64 fall-f64\n"));
    EXPECT_FALSE(holds(script, "secret"));
}

}  // namespace
}  // namespace plumbline::game

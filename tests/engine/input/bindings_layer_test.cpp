// A bindings file as it was written: what is read of it, and what is said of the rest.
#include "engine/input/bindings_layer.h"

#include "tests/engine/input/loaded.h"

#include <gtest/gtest.h>

namespace plumbline::input {
namespace {

TEST(BindingsLayer, UnknownNamesAreNamedWithTheNearest) {  // D4
    const Loaded loaded(
        "[view]\nflashligt = [\"f\"]\nfog = [\"k\"]\n[wlak]\njump = [\"k\"]\n[tuning]\n"
        "pad_curv = 1\n[hold]\ncrouhc = \"hold\"\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Fog), "k");
    const std::string messages = loaded.messages();
    for (const char* line :
         {"bindings.toml:2:1: warning: no action \"flashligt\" in [view]. Nearest: \"flashlight\". "
          "Line ignored.\n",
          "warning: no table [wlak]. Nearest: \"walk\". Table ignored.\n",
          "bindings.toml:7:1: warning: no key \"pad_curv\" in [tuning]. Nearest: \"pad_curve\". "
          "Line ignored.\n",
          "bindings.toml:9:1: warning: no action \"crouhc\" in [hold]. Nearest: \"crouch\". "
          "Line ignored.\n"})
        EXPECT_NE(messages.find(line), std::string::npos) << line << "in\n" << messages;
    EXPECT_FALSE(loaded.faults.has_errors());
}

TEST(BindingsLayer, EmptyMarkedAndWindowsFilesAreAccepted) {  // D2
    EXPECT_EQ(Loaded("").messages(), "");
    EXPECT_EQ(
        joined_words(Loaded("\xEF\xBB\xBF[walk]\r\njump = [\"k\"]\r\n").bindings, Action::Jump),
        "k");
}

TEST(BindingsLayer, ABrokenFileIsLeftOutWhole) {  // D3, D8, D9
    for (const char* text : {"[walk]\njump = [\"k\"]\nback = [\"x\n",
                             "[walk]\njump = [\"k\"]\njump = [\"x\"]\n",
                             "[walk]\njump = [\"k\"]\n[walk]\n",
                             "[walk]\njump = [\"k\"]\nback = [\"\xFF\"]\n",
                             "[walk]\njump = [\"k\"]\rback = [\"x\"]\n"}) {
        const Loaded loaded(text);
        EXPECT_EQ(joined_words(loaded.bindings, Action::Jump), "space pad.a") << text;
        EXPECT_EQ(loaded.bindings.left_out, std::vector<std::string>{"bindings.toml"});
        ASSERT_EQ(loaded.faults.list().size(), 1U) << text;
        EXPECT_GE(loaded.faults.list()[0].line, 2) << text;
        EXPECT_GE(loaded.faults.list()[0].column, 1) << text;
        EXPECT_NE(loaded.messages().find("The whole file is left out."), std::string::npos);
    }
    EXPECT_TRUE(Loaded(std::string_view("[walk]\n\0", 8)).faults.has_errors());
}

// A key of the file may hold what would drive a terminal; what is said of it does not.
TEST(BindingsLayer, EscapeSequencesAreNamedNotSent) {
    for (const char* text : {"[things]\ndrop = [\"\\u001b[31mq\"]\n",
                             "[things]\n\"\\u001b]0;title\\u0007\" = [\"q\"]\n",
                             "[\"\\u001b[2J\"]\ndrop = [\"q\"]\n",
                             "profile = \"\\u001b[5m\"\n[things]\ndrop = [\"\\u001b\"]\n"}) {
        const Loaded loaded(text);
        ASSERT_FALSE(loaded.faults.list().empty()) << text;
        const std::string said = loaded.messages();
        EXPECT_EQ(said.find('\x1b'), std::string::npos);
        EXPECT_EQ(said.find('\x07'), std::string::npos);
        EXPECT_NE(said.find("\\x1b"), std::string::npos) << said;
    }
}

TEST(BindingsLayer, WrongTypesAndRangesKeepTheDefaultAndNameTheRange) {  // D5
    const Loaded loaded(
        "[tuning]\nmouse_deg_per_count = nan\npad_curve = \"wide\"\ninvert_y = 1\n"
        "trigger_threshold = 2\npad_inner_dead_zone = inf\npad_look_deg_per_sec = 90\n");
    const Tuning defaults;
    EXPECT_EQ(loaded.bindings.tuning.mouse_deg_per_count, defaults.mouse_deg_per_count);
    EXPECT_EQ(loaded.bindings.tuning.pad_curve, defaults.pad_curve);
    EXPECT_EQ(loaded.bindings.tuning.trigger_threshold, defaults.trigger_threshold);
    EXPECT_EQ(loaded.bindings.tuning.pad_inner_dead_zone, defaults.pad_inner_dead_zone);
    EXPECT_EQ(loaded.bindings.tuning.pad_look_deg_per_s, 90.0F);
    EXPECT_EQ(loaded.faults.list().size(), 5U);
    EXPECT_NE(loaded.messages().find(
                  "bindings.toml:2:23: error: mouse_deg_per_count = nan: a number from 0.001 to 2 "
                  "is expected. 0.066 is used.\n"),
              std::string::npos)
        << loaded.messages();
}

TEST(BindingsLayer, ANewerFormatIsReadAsFarAsItIsKnown) {  // D7
    const Loaded loaded("format = 99\n[walk]\njump = [\"k\"]\nfly_up = [\"j\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Jump), "k");
    EXPECT_FALSE(loaded.faults.has_errors());
    EXPECT_NE(loaded.messages().find("format 99 is newer than 1"), std::string::npos);
}

TEST(BindingsLayer, HostileNestingNeverReachesTheParser) {  // D10
    std::string dotted = "a";
    for (int i = 0; i < 100'000; ++i) dotted += ".a";
    for (const std::string& text : {dotted + " = 1\n",
                                    "x = " + std::string(100'000, '['),
                                    "x = " + std::string(100'000, '{')}) {
        const Loaded loaded(text);
        EXPECT_TRUE(loaded.faults.has_errors());
        EXPECT_EQ(joined_words(loaded.bindings, Action::Jump), "space pad.a");
    }
}

TEST(BindingsLayer, LimitsHoldToTheByte) {  // D11
    std::string fits = "[walk]\njump = [\"k\"]\n";
    while (fits.size() + 64 < 256 * 1024) fits += "#" + std::string(62, 'x') + "\n";
    fits += "#" + std::string(256 * 1024 - 1 - fits.size(), 'x');
    EXPECT_EQ(joined_words(Loaded(fits).bindings, Action::Jump), "k");
    EXPECT_EQ(joined_words(Loaded(fits + "x").bindings, Action::Jump), "space pad.a");
    const std::string nest_32 = "[walk]\nforward = " + std::string(32, '[') + std::string(32, ']');
    EXPECT_EQ(Loaded(nest_32).messages().find("whole file"), std::string::npos);
    const std::string nest_33 = "[walk]\nforward = " + std::string(33, '[') + std::string(33, ']');
    EXPECT_NE(Loaded(nest_33).messages().find("whole file"), std::string::npos);
}

TEST(BindingsLayer, AnActionInAnotherTableIsTakenAllTheSame) {
    const Loaded loaded("[walk]\ngrab = [\"k\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Grab), "k");
    EXPECT_NE(loaded.messages().find("belongs in [things]"), std::string::npos);
}

TEST(BindingsLayer, HoldsLinesInTheOrderOfTheTextAndNothingOfTheTable) {
    Tuning tuning;
    Diagnostics faults;
    const auto content = read_layer({"a.toml",
                                     "profile = \"viewer\"\n[view]\nfog = \"mouse1\"\n[walk]\n"
                                     "jump = [\"k\", 7]\n[hold]\ngrab = \"hold\"\n[tuning]\n"
                                     "invert_y = true\npad_curve = 3\n"},
                                    tuning,
                                    faults);
    ASSERT_TRUE(content.has_value());
    EXPECT_TRUE(faults.list().empty()) << "what is wrong in a list is for the merge to say";
    EXPECT_EQ(content->profile, "viewer");
    ASSERT_EQ(content->lines.size(), 2U);
    EXPECT_EQ(content->lines[0].action, Action::Fog);
    EXPECT_EQ(content->lines[0].location.line, 3);
    EXPECT_EQ(content->lines[0].inputs.at(0).input.word, "mouse.left");
    EXPECT_EQ(content->aliases,
              std::vector<std::string>{"a.toml:3: \"mouse1\" is called \"mouse.left\" here"});
    EXPECT_EQ(content->lines[1].action, Action::Jump);
    EXPECT_EQ(content->lines[1].inputs.size(), 1U);
    ASSERT_EQ(content->lines[1].faults.size(), 1U);
    EXPECT_EQ(content->lines[1].faults[0].message, "an input is a word in quotes, not 7");
    EXPECT_EQ(content->lines[1].faults[0].location.column, 14);
    ASSERT_EQ(content->holds.size(), 1U);
    EXPECT_EQ(content->holds[0].action, Action::Grab);
    EXPECT_EQ(content->holds[0].mode, HoldMode::Hold);
    EXPECT_TRUE(tuning.invert_y);
    EXPECT_EQ(tuning.pad_curve, 3.0F);
}

TEST(BindingsLayer, SaysWhatAPlaceHoldsInsteadOfWhatIsExpected) {
    const auto said = [](std::string_view text) {
        Tuning tuning;
        Diagnostics faults;
        EXPECT_TRUE(read_layer({"a", std::string{text}}, tuning, faults).has_value());
        return faults.list().empty() ? std::string{} : faults.list()[0].message;
    };
    EXPECT_EQ(said("walk = 3\n"), "[walk] is a table, not 3. Ignored.");
    EXPECT_EQ(said("tuning = []\n"), "[tuning] is a table, not an array. Ignored.");
    EXPECT_EQ(said("format = \"1\"\n"), "format = \"1\": 1 is expected. Read as 1.");
    EXPECT_EQ(said("format = 0\n"), "format = 0: 1 is expected. Read as 1.");
    EXPECT_EQ(said("profile = true\n"), "profile = true: a name in quotes is expected. Ignored.");
    EXPECT_EQ(said("fromat = 1\n"), "no key \"fromat\" here. Nearest: \"format\". Line ignored.");
    EXPECT_EQ(said("[hold]\ncrouch = \"held\"\n"),
              "crouch = \"held\": \"hold\" or \"toggle\" is expected. Line ignored.");
    EXPECT_EQ(said("[hold]\nlook = \"hold\"\n"), "no action \"look\" in [hold]. Line ignored.");
    EXPECT_EQ(said("[tuning]\ninvert_y = 1979-05-27\n"),
              "invert_y = a date or time: true or false is expected. false is used.");
    EXPECT_EQ(said("[tuning]\npad_curve = {}\n").substr(0, 20), "pad_curve = a table:");
}

TEST(BindingsLayer, ReadsAnOptionAsALineWithoutAPlace) {
    Diagnostics faults;
    const auto line = read_bind_option("drop=q,spcae,mouse.4", faults);
    ASSERT_TRUE(line.has_value());
    EXPECT_EQ(line->action, Action::Drop);
    EXPECT_EQ(line->location.line, 0);
    ASSERT_EQ(line->inputs.size(), 2U);
    EXPECT_EQ(line->inputs[0].input.word, "q");
    EXPECT_EQ(line->inputs[1].input.word, "mouse.4");
    EXPECT_EQ(line->faults.size(), 1U);
    EXPECT_TRUE(read_bind_option("drop=", faults)->inputs.empty());
    EXPECT_TRUE(faults.list().empty());
    EXPECT_FALSE(read_bind_option("drop", faults).has_value());
    EXPECT_FALSE(read_bind_option("dorp=q", faults).has_value());
    ASSERT_EQ(faults.list().size(), 2U);
    EXPECT_EQ(faults.list()[0].message, "\"drop\" is not action=key[,key]. Ignored.");
    EXPECT_EQ(faults.list()[1].message, "no action \"dorp\". Nearest: \"drop\". Ignored.");
}

}  // namespace
}  // namespace plumbline::input

#include "engine/input/bindings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::input {
namespace {

std::string joined_words(const Bindings& bindings, Action action) {
    std::string text;
    for (const Input& input : bindings.of(action)) text += (text.empty() ? "" : " ") + input.word;
    return text;
}

/// The user's file over the built-in table.
struct Loaded {
    explicit Loaded(std::string_view text, const std::vector<std::string>& options = {})
        : bindings(load_bindings({{"bindings.toml", std::string{text}}}, options, faults)) {}

    std::string messages() const {
        std::string text;
        for (const Diagnostic& fault : faults.list()) text += to_string(fault) + "\n";
        return text;
    }

    Diagnostics faults;
    Bindings bindings;
};

TEST(Bindings, EveryActionOfTheBuiltInTableIsBound) {
    const Bindings bindings = built_in_bindings();
    for (std::size_t i = 0; i < kActionCount; ++i) {
        // Throwing and turning what is held do these two until a profile gives them keys.
        const auto action = static_cast<Action>(i);
        if (action == Action::TurnModel || action == Action::ShiftModel) continue;
        EXPECT_FALSE(bindings.inputs[i].empty()) << action_name(action);
    }
    EXPECT_EQ(joined_words(bindings, Action::Forward), "w up pad.left_y-");
    EXPECT_EQ(joined_words(bindings, Action::Drop), "q pad.right_bumper");
    EXPECT_EQ(joined_words(bindings, Action::Throw), "mouse.left pad.right_trigger");
    EXPECT_EQ(joined_words(bindings, Action::Grab), "e mouse.right pad.x");
}

TEST(Bindings, TheBuiltInTableHasNoInputTwiceInADomain) {
    const Bindings bindings = built_in_bindings();
    for (std::size_t a = 0; a < kActionCount; ++a) {
        for (std::size_t b = a + 1; b < kActionCount; ++b) {
            const bool is_menu_a = group_of(static_cast<Action>(a)) == ActionGroup::Menu;
            const bool is_menu_b = group_of(static_cast<Action>(b)) == ActionGroup::Menu;
            if (is_menu_a != is_menu_b) continue;
            for (const Input& input : bindings.inputs[a])
                EXPECT_EQ(std::ranges::count(bindings.inputs[b], input), 0) << input.word;
        }
    }
}

TEST(Bindings, ALineReplacesTheListAndTellsWhereItStands) {
    const Loaded loaded("format = 1\n[walk]\njump = [\"b\", \"pad.a\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Jump), "b pad.a");
    EXPECT_EQ(loaded.bindings.of(Action::Jump)[0].origin, "bindings.toml:3");
    EXPECT_EQ(loaded.bindings.of(Action::Drop)[0].origin, "built-in");
}

TEST(Bindings, AnEmptyListUnbinds) {
    const Loaded loaded("[walk]\njump = []\n");
    EXPECT_TRUE(loaded.bindings.of(Action::Jump).empty());
    EXPECT_EQ(loaded.messages(), "");
}

TEST(Bindings, OneWordNeedsNoBrackets) {
    EXPECT_EQ(joined_words(Loaded("[walk]\njump = \"kp_0\"").bindings, Action::Jump), "kp_0");
}

TEST(Bindings, ABadWordCostsOnlyItself) {
    const Loaded loaded("[walk]\njump = [\"spcae\", \"pad.a\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Jump), "pad.a");
    EXPECT_EQ(loaded.messages(),
              "bindings.toml:2:9: error: unknown input \"spcae\" for action \"jump\". Nearest: "
              "\"space\". This entry is left out; \"jump\" keeps: pad.a\n");
}

TEST(Bindings, ALineWithNothingGoodKeepsTheLowerLayers) {
    const Loaded loaded("[walk]\njump = [\"spcae\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Jump), "space pad.a");
    EXPECT_NE(loaded.messages().find("Line ignored; \"jump\" keeps: space, pad.a"),
              std::string::npos);
}

TEST(Bindings, UnknownNamesAreNamedWithTheNearest) {  // D4
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

TEST(Bindings, TheSecondLineWithAnInputIsRefusedAndBothNamed) {  // D6
    const Loaded loaded("[view]\nflashlight = [\"k\"]\n[time]\nstep = [\"k\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Flashlight), "k");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Step), "o");
    EXPECT_EQ(loaded.messages(),
              "bindings.toml:4:9: error: \"k\" already drives \"flashlight\" (line 2, same group). "
              "Line ignored; \"step\" keeps: o\n");
}

TEST(Bindings, AUsersLineTakesAnInputFromADefaultAndSaysSo) {
    const Loaded loaded("[view]\nfog = [\"f\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Fog), "f");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Flashlight), "pad.y");
    EXPECT_EQ(loaded.messages(),
              "bindings.toml:2:1: warning: \"f\" now drives \"fog\" and no longer \"flashlight\" "
              "(built-in), which keeps: pad.y\n");
}

TEST(Bindings, TwoLinesMaySwapTheirKeysInSilence) {
    const Loaded loaded("[view]\nfog = [\"f\"]\nflashlight = [\"g\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Fog), "f");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Flashlight), "g");
    EXPECT_EQ(loaded.messages(), "");
}

TEST(Bindings, TheMenuMayUseKeysOfPlay) {
    const Loaded loaded("[menu]\naccept = [\"f\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Accept), "f");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Flashlight), "f pad.y");
    EXPECT_EQ(loaded.messages(), "");
}

TEST(Bindings, AChordIsAnotherInputThanItsKey) {
    const Loaded loaded("[view]\nstats = [\"f3\"]\nhelp = [\"shift+f3\"]\n");
    EXPECT_EQ(loaded.messages(), "");
}

TEST(Bindings, EscapeCannotBeTakenFromTheMenu) {
    for (const char* text :
         {"[menu]\nmenu = []\n", "[menu]\nmenu = [\"k\"]\n", "[time]\nreset = [\"escape\"]\n"}) {
        const Loaded loaded(text);
        EXPECT_NE(joined_words(loaded.bindings, Action::Menu).find("escape"), std::string::npos)
            << text;
        EXPECT_FALSE(loaded.faults.has_errors()) << loaded.messages();
    }
    const Loaded also("[time]\nreset = [\"escape\"]\n");
    EXPECT_EQ(joined_words(also.bindings, Action::Reset), "escape");
}

TEST(Bindings, TheWheelCannotHoldAnythingDown) {  // C11
    const Loaded loaded("[walk]\nforward = [\"w\", \"wheel.up\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Forward), "w");
    EXPECT_TRUE(loaded.faults.has_errors());
    EXPECT_NE(
        loaded.messages().find(
            "bindings.toml:2:17: error: \"wheel.up\" cannot be held down, and \"forward\" needs"),
        std::string::npos)
        << loaded.messages();
    EXPECT_TRUE(Loaded("[walk]\ncrouch = [\"wheel.down\"]").faults.has_errors());
    EXPECT_FALSE(Loaded("[hold]\ncrouch = \"toggle\"\n[walk]\ncrouch = [\"wheel.left\"]")
                     .faults.has_errors());
    const Loaded late("[hold]\ngrab = \"hold\"\n", {"grab=wheel.left"});
    EXPECT_TRUE(late.faults.has_errors());
}

TEST(Bindings, LookAndOnlyLookFollowsTheMouse) {
    EXPECT_TRUE(Loaded("[walk]\njump = [\"mouse.move\"]").faults.has_errors());
    EXPECT_TRUE(Loaded("[walk]\nlook = [\"x\"]").faults.has_errors());
    EXPECT_EQ(joined_words(Loaded("[walk]\nlook = [\"pad.left_stick\"]").bindings, Action::Look),
              "pad.left_stick");
}

TEST(Bindings, SixteenInputsAndNoMore) {
    std::string list;
    for (int i = 1; i <= 16; ++i) list += fmt::format("\"ctrl+f{}\", ", i);
    const Loaded good("[walk]\njump = [" + list + "]");
    EXPECT_EQ(good.bindings.of(Action::Jump).size(), 16U);
    EXPECT_EQ(good.messages(), "");
    const Loaded over("[walk]\njump = [" + list + "\"k\"]");
    EXPECT_EQ(over.bindings.of(Action::Jump).size(), 16U);
    EXPECT_TRUE(over.faults.has_errors());
}

TEST(Bindings, EmptyMarkedAndWindowsFilesAreAccepted) {  // D2
    EXPECT_EQ(Loaded("").messages(), "");
    EXPECT_EQ(
        joined_words(Loaded("\xEF\xBB\xBF[walk]\r\njump = [\"k\"]\r\n").bindings, Action::Jump),
        "k");
}

TEST(Bindings, ABrokenFileIsLeftOutWhole) {  // D3, D8, D9
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
TEST(Bindings, EscapeSequencesAreNamedNotSent) {
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

TEST(Bindings, WrongTypesAndRangesKeepTheDefaultAndNameTheRange) {  // D5
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

TEST(Bindings, ANewerFormatIsReadAsFarAsItIsKnown) {  // D7
    const Loaded loaded("format = 99\n[walk]\njump = [\"k\"]\nfly_up = [\"j\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Jump), "k");
    EXPECT_FALSE(loaded.faults.has_errors());
    EXPECT_NE(loaded.messages().find("format 99 is newer than 1"), std::string::npos);
}

TEST(Bindings, HostileNestingNeverReachesTheParser) {  // D10
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

TEST(Bindings, LimitsHoldToTheByte) {  // D11
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

TEST(Bindings, TheCommandLineIsTheHighestLayer) {
    const Loaded loaded("[things]\ndrop = [\"k\"]\n", {"drop=j,mouse.4", "jump=", "fog=spcae"});
    EXPECT_EQ(joined_words(loaded.bindings, Action::Drop), "j mouse.4");
    EXPECT_EQ(loaded.bindings.of(Action::Drop)[0].origin, "--bind");
    EXPECT_TRUE(loaded.bindings.of(Action::Jump).empty());
    EXPECT_EQ(joined_words(loaded.bindings, Action::SunFaster), "");
    EXPECT_NE(loaded.messages().find("--bind: error: unknown input \"spcae\" for action \"fog\""),
              std::string::npos);
    EXPECT_TRUE(Loaded("", {"drop"}).faults.has_errors());
    EXPECT_NE(Loaded("", {"dorp=q"}).messages().find("Nearest: \"drop\""), std::string::npos);
}

TEST(Bindings, AnActionInAnotherTableIsTakenAllTheSame) {
    const Loaded loaded("[walk]\ngrab = [\"k\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Grab), "k");
    EXPECT_NE(loaded.messages().find("belongs in [things]"), std::string::npos);
}

TEST(Bindings, WhatIsPrintedReadsBackTheSame) {
    const Loaded first(
        "[tuning]\ninvert_y = true\n[hold]\nsprint = \"toggle\"\n[walk]\njump = [\"\\\\\", "
        "\"label:/\", \"label:\\\"\"]\n[view]\nfog = [\"f\"]\n",
        {"drop="});
    const std::string printed = print_bindings(first.bindings);
    const Loaded second(printed);
    EXPECT_EQ(second.messages(), "");
    for (std::size_t i = 0; i < kActionCount; ++i) {
        EXPECT_EQ(first.bindings.inputs[i], second.bindings.inputs[i]);
        EXPECT_EQ(first.bindings.hold_mode[i], second.bindings.hold_mode[i]);
    }
    EXPECT_TRUE(second.bindings.tuning.invert_y);
    EXPECT_NE(printed.find("# built-in; \"f\" taken by fog (bindings.toml:8)"), std::string::npos)
        << printed;
    EXPECT_NE(printed.find("drop = []"), std::string::npos);
    EXPECT_NE(printed.find("# --bind"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::input

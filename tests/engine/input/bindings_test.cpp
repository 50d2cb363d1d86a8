#include "engine/input/bindings.h"

#include "tests/engine/input/loaded.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plumbline::input {
namespace {

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

TEST(Bindings, TheSecondLineWithAnInputIsRefusedAndBothNamed) {  // D6
    const Loaded loaded("[view]\nflashlight = [\"i\"]\n[time]\nstep = [\"i\"]\n");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Flashlight), "i");
    EXPECT_EQ(joined_words(loaded.bindings, Action::Step), "o");
    EXPECT_EQ(loaded.messages(),
              "bindings.toml:4:9: error: \"i\" already drives \"flashlight\" (line 2, same group). "
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

}  // namespace
}  // namespace plumbline::input

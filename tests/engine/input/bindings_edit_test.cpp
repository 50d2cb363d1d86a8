#include "engine/input/bindings_edit.h"

#include <gtest/gtest.h>

namespace plumbline::input {
namespace {

Input input(std::string_view word) {
    const Result<Input> parsed = parse_input(word);
    EXPECT_TRUE(parsed.ok()) << word;
    return *parsed;
}

std::vector<std::string> words(const Bindings& bindings, Action action) {
    std::vector<std::string> list;
    for (const Input& each : bindings.of(action)) list.push_back(each.word);
    return list;
}

using Words = std::vector<std::string>;

TEST(BindingsEdit, AnInputTakesAPlaceAndIsTakenFromOthers) {
    Bindings bindings = built_in_bindings();
    EXPECT_EQ(also_drives(bindings, input("f"), Action::Drop), std::vector{Action::Flashlight});
    put_input(bindings, Action::Drop, 0, input("f"));
    EXPECT_EQ(words(bindings, Action::Drop), (Words{"f", "pad.right_bumper"}));
    EXPECT_EQ(words(bindings, Action::Flashlight), Words{"pad.y"});
    put_input(bindings, Action::Drop, 9, input("k"));
    EXPECT_EQ(words(bindings, Action::Drop), (Words{"f", "pad.right_bumper", "k"}));
    put_input(bindings, Action::Drop, 0, input("k"));  // has it already: no second time
    EXPECT_EQ(words(bindings, Action::Drop), (Words{"pad.right_bumper", "k"}));
}

TEST(BindingsEdit, TheMenusKeysAreADomainOfTheirOwn) {
    const Bindings bindings = built_in_bindings();
    EXPECT_TRUE(also_drives(bindings, input("enter"), Action::Drop).empty());
    EXPECT_EQ(also_drives(bindings, input("pad.start"), Action::Drop), std::vector{Action::Menu});
    EXPECT_TRUE(also_drives(bindings, input("escape"), Action::Drop).empty());  // may do both
}

TEST(BindingsEdit, WhatIsWrittenReadsBackWithoutAWord) {
    const Bindings below = built_in_bindings();
    Bindings wanted = below;
    put_input(wanted, Action::Drop, 0, input("ctrl+\\"));
    put_input(wanted, Action::Fog, 0, input("q"));
    remove_input(wanted, Action::Help, 0);
    wanted.tuning.invert_y = true;
    wanted.tuning.mouse_deg_per_count = 0.1F;
    wanted.hold_mode[static_cast<std::size_t>(Action::Crouch)] = HoldMode::Toggle;
    const std::string text = ui_bindings_text(below, wanted);
    EXPECT_EQ(text.substr(text.find("format")),
              "format = 1\n\n[tuning]\nmouse_deg_per_count = 0.1\ninvert_y = true\n\n[hold]\n"
              "crouch = \"toggle\"\n\n[things]\ndrop = [\"ctrl+\\\\\", \"pad.right_bumper\"]\n\n"
              "[view]\nfog = [\"q\"]\nhelp = []\n");
    Diagnostics faults;
    const Bindings read = load_bindings({{"bindings.ui.toml", text}}, {}, faults);
    EXPECT_TRUE(faults.list().empty());
    for (std::size_t i = 0; i < kActionCount; ++i) EXPECT_EQ(read.inputs[i], wanted.inputs[i]) << i;
    EXPECT_EQ(read.hold_mode, wanted.hold_mode);
    EXPECT_EQ(read.tuning.mouse_deg_per_count, 0.1F);
}

TEST(BindingsEdit, ResettingGivesBackWhatNothingElseDrivesByNow) {
    const Bindings below = built_in_bindings();
    Bindings bindings = below;
    put_input(bindings, Action::Fog, 0, input("q"));  // from drop
    reset_action(bindings, below, Action::Drop);
    EXPECT_EQ(words(bindings, Action::Drop), Words{"pad.right_bumper"});
    reset_action(bindings, below, Action::Fog);
    reset_action(bindings, below, Action::Drop);
    EXPECT_EQ(words(bindings, Action::Drop), (Words{"q", "pad.right_bumper"}));

    // Exchanged within a group: the group finds its way back as a whole.
    put_input(bindings, Action::Fog, 0, input("h"));
    put_input(bindings, Action::Help, 0, input("g"));
    reset_group(bindings, below, ActionGroup::View);
    EXPECT_EQ(words(bindings, Action::Fog), Words{"g"});
    EXPECT_EQ(words(bindings, Action::Help), Words{"h"});
}

// What a message says an action keeps is what it keeps in the end.
TEST(BindingsEdit, MessagesSayWhatIsKeptAfterAllLines) {
    Diagnostics faults;
    load_bindings({{"bindings.toml", "[things]\ndrop = [\"spcae\"]\n[time]\nstep = [\"q\"]\n"},
                   {"bindings.ui.toml", "[view]\nfog = [\"pad.right_bumper\"]\n"}},
                  {},
                  faults);
    ASSERT_EQ(faults.list().size(), 3U);
    EXPECT_EQ(to_string(faults.list()[0]),
              "bindings.toml:2:9: error: unknown input \"spcae\" for action \"drop\". Nearest: "
              "\"space\". Line ignored; \"drop\" keeps: nothing");
    EXPECT_TRUE(faults.list()[1].message.ends_with("which keeps: nothing"))
        << faults.list()[1].message;
}

}  // namespace
}  // namespace plumbline::input

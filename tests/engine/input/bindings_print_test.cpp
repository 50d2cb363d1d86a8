// The effective table as TOML.
#include "tests/engine/input/loaded.h"

#include <gtest/gtest.h>

namespace plumbline::input {
namespace {

TEST(BindingsPrint, WhatIsPrintedReadsBackTheSame) {
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

TEST(BindingsPrint, InputsStandInQuotesWithWhatTheyMustEscape) {
    const Loaded loaded("[walk]\njump = [\"\\\\\", \"label:\\\"\", \"ctrl+k\"]\n");
    EXPECT_EQ(inputs_text(loaded.bindings.of(Action::Jump)),
              "[\"\\\\\", \"label:\\\"\", \"ctrl+k\"]");
    EXPECT_EQ(inputs_text({}), "[]");
}

TEST(BindingsPrint, OfHoldsOnlyTheUsualThreeAndTheOthersThatToggle) {
    const auto holds = [](const std::string& printed) {
        const std::size_t begin = printed.find("[hold]\n") + 7;
        return printed.substr(begin, printed.find("\n\n", begin) - begin);
    };
    EXPECT_EQ(holds(print_bindings(built_in_bindings())),
              "crouch = \"hold\"\nsprint = \"hold\"\ngrab = \"toggle\"");
    const Loaded loaded("[hold]\npush = \"toggle\"\npull = \"hold\"\ngrab = \"hold\"\n");
    EXPECT_EQ(holds(print_bindings(loaded.bindings)),
              "crouch = \"hold\"\nsprint = \"hold\"\ngrab = \"hold\"\npush = \"toggle\"");
}

TEST(BindingsPrint, EachLineNamesItsLayerAndWhoSharesItsInputs) {
    Bindings bindings = built_in_bindings();
    bindings.inputs[index_of(Action::Fog)] = {*parse_input("q")};
    bindings.origin[index_of(Action::Fog)] = "here:1";
    bindings.notes[index_of(Action::Fog)] = {"noted"};
    bindings.inputs[index_of(Action::Accept)] = {*parse_input("q")};  // the menu's own keys
    bindings.origin[index_of(Action::Accept)].clear();
    const std::string printed = print_bindings(bindings);
    const auto line_of = [&](std::string_view begin) {
        const std::size_t at = printed.find("\n" + std::string{begin}) + 1;
        return printed.substr(at, printed.find('\n', at) - at);
    };
    EXPECT_EQ(
        line_of("fog ="),
        "fog = [\"q\"]" + std::string(56 - 11, ' ') + "  # here:1; noted; \"q\" also drives drop");
    EXPECT_TRUE(line_of("drop =").ends_with("  # built-in; \"q\" also drives fog"));
    EXPECT_TRUE(line_of("accept =").ends_with("  # unbound"));
    EXPECT_TRUE(line_of("jump =").ends_with("  # built-in"));
}

}  // namespace
}  // namespace plumbline::input

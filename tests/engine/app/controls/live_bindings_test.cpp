// The bindings in force while files are saved, broken and mended, and what the controls pages write.
#include "engine/app/controls/live_bindings.h"

#include "engine/input/bindings_edit.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

class LiveBindingsTest : public testing::Test {
protected:
    LiveBindings open(std::vector<std::string> command_line = {}, bool safe = false) {
        return LiveBindings({.shipped_folder = shipped_.path(),
                             .user_folder = user_.path(),
                             .profile = {},
                             .command_line = std::move(command_line),
                             .safe = safe});
    }
    /// Saves the file and looks until it is quiet; whether something else holds now.
    bool saved(LiveBindings& bindings, std::string_view text) {
        user_.write("bindings.toml", text);
        bool changed = false;
        for (int i = 0; i < 4; ++i, now_s_ += 0.2) changed |= bindings.reload_if_changed(now_s_);
        return changed;
    }
    static std::string jump(const input::Bindings& bindings) {
        std::string words;
        for (const input::Input& each : bindings.of(Action::Jump)) words += each.word + " ";
        return words;
    }

    test::TemporaryFolder shipped_;
    test::TemporaryFolder user_;
    double now_s_{0};
};

TEST_F(LiveBindingsTest, WhatIsSavedHoldsAtOnceAndABrokenFileNever) {
    LiveBindings bindings = open();
    EXPECT_FALSE(bindings.reload_if_changed(now_s_));
    EXPECT_TRUE(saved(bindings, "[walk]\njump = [\"k\"]\n"));
    EXPECT_EQ(jump(bindings.current()), "k ");
    EXPECT_TRUE(saved(bindings, "[walk]\njump = [\"x\n"));
    EXPECT_EQ(jump(bindings.current()), "k ") << "not thrown back to the defaults";
    EXPECT_TRUE(bindings.faults().has_errors());
    EXPECT_TRUE(saved(bindings, "[walk]\njump = [\"i\"]\n"));
    EXPECT_EQ(jump(bindings.current()), "i ");
    EXPECT_TRUE(bindings.faults().list().empty());
    EXPECT_FALSE(saved(bindings, "[walk]\njump = [\"i\"]\n")) << "it says the same";
}

TEST_F(LiveBindingsTest, AFileThatIsGoneForAMomentChangesNothing) {
    user_.write("bindings.toml", "[walk]\njump = [\"k\"]\n");
    LiveBindings bindings = open();
    std::filesystem::remove(user_.path() / "bindings.toml");
    for (int i = 0; i < 4; ++i, now_s_ += 0.2) bindings.reload_if_changed(now_s_);
    EXPECT_EQ(jump(bindings.current()), "k ");
}

TEST_F(LiveBindingsTest, AChangeIsWrittenWithoutWhatTheCommandLineAdds) {
    LiveBindings bindings = open({"jump=u"});
    EXPECT_EQ(jump(bindings.current()), "u ");
    EXPECT_EQ(jump(bindings.stored()), "space pad.a ");
    input::Bindings wanted = bindings.stored();
    input::put_input(wanted, Action::Fog, 0, *input::parse_input("k"));
    EXPECT_TRUE(bindings.change(wanted).ok());
    EXPECT_EQ(bindings.current().of(Action::Fog)[0].word, "k");
    EXPECT_EQ(bindings.below().of(Action::Fog)[0].word, "g");
    EXPECT_EQ(jump(bindings.current()), "u ");
    const std::string text = user_.read("bindings.ui.toml");
    EXPECT_NE(text.find("fog = [\"k\"]"), std::string::npos) << text;
    EXPECT_EQ(text.find("jump"), std::string::npos) << text;
    EXPECT_EQ(open().current().of(Action::Fog)[0].word, "k") << "the next sitting";
    EXPECT_TRUE(bindings.change(bindings.below()).ok());
    EXPECT_EQ(bindings.current().of(Action::Fog)[0].word, "g");
}

TEST_F(LiveBindingsTest, WhatCannotBeStoredHoldsForTheSession) {
    user_.write("bindings.toml", "[walk]\njump = [\"k\"]\n");
    LiveBindings safe = open({}, true);
    EXPECT_EQ(jump(safe.current()), "space pad.a ") << "built-in settings only";
    input::Bindings wanted = safe.stored();
    input::put_input(wanted, Action::Jump, 0, *input::parse_input("j"));
    EXPECT_FALSE(safe.change(wanted).ok());
    EXPECT_EQ(jump(safe.current()), "j pad.a ");
    EXPECT_EQ(user_.read("bindings.ui.toml"), "");
    EXPECT_FALSE(safe.reload_if_changed(9.0)) << "no file is watched";
}

TEST_F(LiveBindingsTest, TheUsualProfileGoesWhenAnotherSceneHasNone) {
    shipped_.write("controls/viewer.toml", "[walk]\njump = [\"v\"]\n");
    LiveBindings bindings = open();
    bindings.use_usual_profile("viewer");
    EXPECT_EQ(jump(bindings.current()), "v ");
    bindings.use_usual_profile("");
    EXPECT_EQ(jump(bindings.current()), "space pad.a ");
}

}  // namespace
}  // namespace plumbline::app

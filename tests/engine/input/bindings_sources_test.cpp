#include "engine/input/bindings.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace plumbline::input {
namespace {
namespace fs = std::filesystem;

const fs::path kShipped = fs::path{PL_SOURCE_DIR} / "config";

std::string messages_of(const Diagnostics& faults) {
    std::string text;
    for (const Diagnostic& fault : faults.list()) text += to_string(fault) + "\n";
    return text;
}

class BindingSourcesTest : public testing::Test {
protected:
    Bindings load(std::string_view profile = {}) {
        const BindingSources sources =
            find_binding_sources(kShipped, user_.path(), {profile}, faults_);
        return load_bindings(sources.layers, {}, faults_);
    }

    test::TemporaryFolder user_;
    Diagnostics faults_;
};

TEST_F(BindingSourcesTest, ProfilesLoadWithoutAWord) {
    for (const char* profile : {"book", "nature", "viewer"}) {
        faults_ = {};
        const Bindings bindings = load(profile);
        EXPECT_EQ(messages_of(faults_), "") << profile;
        // Nobody loses the way to move or to look.
        for (const Action action : {Action::Forward, Action::Left, Action::Look, Action::Jump})
            EXPECT_FALSE(bindings.of(action).empty()) << profile;
    }
}

TEST_F(BindingSourcesTest, TheProfilesHaveTheKeysOfTheirSources) {
    const auto drives = [](const Bindings& bindings, Action action, std::string_view word) {
        for (const Input& input : bindings.of(action))
            if (input.word == word) return true;
        return false;
    };
    const Bindings book = load("book");
    EXPECT_TRUE(drives(book, Action::ZoomIn, "z") && drives(book, Action::ZoomOut, "x"));
    EXPECT_TRUE(drives(book, Action::RotateLeft, "left") && drives(book, Action::Wireframe, "w"));
    EXPECT_TRUE(drives(book, Action::RotateRight, "right") && drives(book, Action::Forward, "up"));
    EXPECT_TRUE(drives(book, Action::Back, "down"));
    EXPECT_TRUE(drives(book, Action::Remove, "d") && drives(book, Action::Shoot, "mouse.right"));
    EXPECT_TRUE(drives(book, Action::Grab, "mouse.left"));
    EXPECT_EQ(book.hold_mode[index_of(Action::Grab)], HoldMode::Hold);
    EXPECT_TRUE(drives(book, Action::Lift, "g") && drives(book, Action::Explode, "e"));
    EXPECT_TRUE(drives(book, Action::CollisionBoxes, "b") && drives(book, Action::DepthTest, "t"));
    EXPECT_TRUE(drives(book, Action::CollisionShapes, "s"));
    EXPECT_TRUE(book.tuning.free_pointer);
    const Bindings nature = load("nature");
    EXPECT_TRUE(drives(nature, Action::RotateLeft, "q") &&
                drives(nature, Action::RotateRight, "e"));
    EXPECT_TRUE(drives(nature, Action::Wireframe, "m") && drives(nature, Action::Points, "v"));
    EXPECT_TRUE(drives(nature, Action::Flashlight, "y") && drives(nature, Action::Flashlight, "p"));
    EXPECT_TRUE(drives(nature, Action::AimSpot, "1") && drives(nature, Action::Fog, "f"));
    EXPECT_TRUE(drives(nature, Action::CameraPlay, "space"));
    EXPECT_TRUE(drives(nature, Action::CameraReload, "r"));
    EXPECT_TRUE(drives(load("viewer"), Action::ZoomIn, "wheel.up"));
}

TEST_F(BindingSourcesTest, MissingFilesAreNoFaultAndAreWatched) {  // D1
    const BindingSources sources = find_binding_sources(kShipped, user_.path(), {}, faults_);
    EXPECT_EQ(messages_of(faults_), "");
    EXPECT_EQ(sources.layers.size(), 1U);
    EXPECT_EQ(sources.watched.size(), 3U);
    EXPECT_FALSE(fs::exists(user_.path() / "bindings.toml"));
    const BindingSources homeless = find_binding_sources(kShipped, {}, {}, faults_);
    EXPECT_EQ(homeless.watched.size(), 1U);
}

TEST_F(BindingSourcesTest, LayersReplaceInOrder) {
    user_.write("bindings.toml", "[things]\ndrop = [\"k\"]\nundo_drop = [\"u\"]\n");
    user_.write("bindings.ui.toml", "[things]\ndrop = [\"j\"]\nremove = [\"i\"]\n");
    const Bindings bindings = load();
    EXPECT_EQ(bindings.of(Action::Drop)[0].word, "j");
    EXPECT_EQ(bindings.of(Action::Drop)[0].origin, "bindings.ui.toml:2");
    EXPECT_EQ(bindings.of(Action::UndoDrop)[0].word, "u");
}

TEST_F(BindingSourcesTest, TheUsersFileMayChooseTheProfile) {
    user_.write("bindings.toml", "profile = \"nature\"\n");
    EXPECT_EQ(load().of(Action::Wireframe)[0].word, "m");
    EXPECT_EQ(load("book").of(Action::Wireframe)[0].word, "w");
}

TEST_F(BindingSourcesTest, UnknownProfilesAreNamedAndCannotLeadOut) {
    load("natur");
    EXPECT_EQ(messages_of(faults_),
              "profile: error: no profile \"natur\". Nearest: \"nature\". There are: book, nature, "
              "viewer. None is used.\n");
    faults_ = {};
    load("../bindings");
    EXPECT_TRUE(faults_.has_errors());
}

TEST_F(BindingSourcesTest, WhatIsNoRegularFileIsRefusedWithoutWaiting) {  // D14, D13
    const fs::path file = user_.path() / "bindings.toml";
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(load().of(Action::Jump)[0].word, "space");
    EXPECT_NE(messages_of(faults_).find("The file is left out."), std::string::npos);
    EXPECT_EQ(find_binding_sources(kShipped, user_.path(), {}, faults_).left_out,
              std::vector<std::string>{"bindings.toml"});
    fs::remove(file);
    fs::create_directory(file);
    faults_ = {};
    load();
    EXPECT_TRUE(faults_.has_errors());
    fs::remove(file);
    fs::create_symlink(file, file);
    faults_ = {};
    load();
    EXPECT_TRUE(faults_.has_errors());
}

TEST_F(BindingSourcesTest, UnreadableAndOversizedFilesLeaveTheDefaults) {  // D15, D11
    const fs::path file = user_.path() / "bindings.toml";
    user_.write("bindings.toml", std::string(300 * 1024, '#'));
    EXPECT_EQ(load().of(Action::Jump)[0].word, "space");
    EXPECT_TRUE(faults_.has_errors());
    if (geteuid() == 0) return;  // root may read everything
    user_.write("bindings.toml", "[walk]\njump = [\"k\"]\n");
    fs::permissions(file, fs::perms::none);
    faults_ = {};
    EXPECT_EQ(load().of(Action::Jump)[0].word, "space");
    EXPECT_TRUE(faults_.has_errors());
}

TEST_F(BindingSourcesTest, TheUsualProfileIsTakenWhereNobodyAskedForAnother) {
    const auto layers = [&](const ProfileChoice& choice) {
        std::vector<std::string> names;
        for (const BindingLayer& layer :
             find_binding_sources(kShipped, user_.path(), choice, faults_).layers)
            names.push_back(layer.name);
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(layers({.usual = "viewer"}), (Names{"config/bindings.toml", "controls/viewer.toml"}));
    EXPECT_EQ(layers({.asked = "book", .usual = "viewer"}),
              (Names{"config/bindings.toml", "controls/book.toml"}));
    user_.write("bindings.toml", "profile = \"nature\"\n");
    EXPECT_EQ(layers({.usual = "viewer"}),
              (Names{"config/bindings.toml", "controls/nature.toml", "bindings.toml"}));
    // One that cannot be parsed names no profile; its faults are said when it is loaded.
    user_.write("bindings.toml", "profile = \"nature\n");
    user_.write("bindings.ui.toml", "");
    EXPECT_EQ(layers({}), (Names{"config/bindings.toml", "bindings.toml", "bindings.ui.toml"}));
    EXPECT_EQ(messages_of(faults_), "");
}

}  // namespace
}  // namespace plumbline::input
